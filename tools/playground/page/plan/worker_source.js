// The engine lies in the page, compressed; it becomes a worker without any request.

async function unpack(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).blob();
}

/** Resolves to a function that starts a worker. */
export async function loadWorker() {
  const source = await unpack(document.getElementById("engine").textContent);
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  return () => new Worker(address);
}
