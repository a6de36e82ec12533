// The worker lies in the page as a text, so that it starts without any request.

let address = null;

export function startWorker() {
  address ??= URL.createObjectURL(new Blob([document.getElementById("engine").textContent], { type: "text/javascript" }));
  return new Worker(address);
}
