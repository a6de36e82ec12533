// Runs once the engine's bytes are read.

const packed = document.getElementById("engine").textContent;
const engineBytes = Uint8Array.fromBase64?.(packed) ?? Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
firstWorker.postMessage({ kind: "engine", bytes: engineBytes });
