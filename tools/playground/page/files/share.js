// A problem in the address of the page: JSON, deflated, base64 for addresses, behind "#p=".

async function through(bytes, stream) {
  const piped = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

export async function toHash(problem) {
  const packed = await through(new TextEncoder().encode(JSON.stringify(problem)), new CompressionStream("deflate-raw"));
  let characters = "";
  for (const byte of packed) characters += String.fromCharCode(byte);
  return `p=${btoa(characters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** The problem in a text "p=...". Throws where it is none. */
export async function fromHash(text) {
  const characters = atob(text.slice(2).replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(characters, (character) => character.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw"))));
}

/** What an address asks for behind "#" or "?", {problem, example, lesson, ...}: parts "name=value", joined by "&". */
export async function wishesOf({ hash, search }) {
  const parts = Object.fromEntries((hash || search).replace(/^[#?]/, "").split("&").filter(Boolean).map((part) => {
    const at = part.indexOf("=");
    return at < 0 ? [part, ""] : [part.slice(0, at), part.slice(at + 1)];
  }));
  if (parts.p) parts.problem = await fromHash(`p=${parts.p}`);
  return parts;
}
