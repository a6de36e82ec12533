// Short messages: for everybody, and for those who hear the page.

const shownFor = 5000; // milliseconds
let timer = 0;

export function announce(text) {
  const place = document.getElementById("announce");
  if (place.textContent !== text) place.textContent = text;
}

export function notice(text, bad = false) {
  const place = document.getElementById("notice");
  place.textContent = text;
  place.classList.toggle("bad", bad);
  place.hidden = false;
  announce(text);
  clearTimeout(timer);
  timer = setTimeout(() => { place.hidden = true; }, shownFor);
}
