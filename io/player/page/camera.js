// What part of the plane the stage shows, and the gestures that change it.

const stage = document.getElementById("stage");

/** Shows the field with a small margin; zoom 1 is the whole field. */
const camera = { zoom: 1, x: 0, y: 0, size: 1, onChange: () => {} };

const mostZoom = 4000;

function fieldCentre() {
  const [lowX, lowY, highX, highY] = story.bounds;
  return [(lowX + highX) / 2, (lowY + highY) / 2];
}

function fieldSide() {
  const [lowX, lowY, highX, highY] = story.bounds;
  return Math.max(highX - lowX, highY - lowY);
}

/** Pixels of the page for one unit of the workspace. */
const scaleOf = () => (camera.zoom * camera.size) / (fieldSide() * 1.04);

const toPageX = (x) => camera.size / 2 + (x - camera.x) * scaleOf();
const toPageY = (y) => camera.size / 2 - (y - camera.y) * scaleOf();

/** The point [x, y] of the plane under a point of the page. */
const toPlane = (pageX, pageY) =>
  [camera.x + (pageX - camera.size / 2) / scaleOf(), camera.y + (camera.size / 2 - pageY) / scaleOf()];

function moveCamera(zoom, x, y) {
  camera.zoom = clamp(zoom, 1, mostZoom);
  const [centreX, centreY] = fieldCentre();
  // The centre of the view stays in the field, and in the middle when the whole field is seen.
  const reach = (fieldSide() / 2) * (1 - 1 / camera.zoom) * 1.04;
  camera.x = clamp(x, centreX - reach, centreX + reach);
  camera.y = clamp(y, centreY - reach, centreY + reach);
  stage.classList.toggle("zoomed", camera.zoom > 1);
  camera.onChange();
}

const fit = () => moveCamera(1, ...fieldCentre());

/** Zooms so that the point of the plane under (pageX, pageY) stays there. */
function zoomAt(factor, pageX, pageY) {
  const before = scaleOf();
  const zoom = clamp(camera.zoom * factor, 1, mostZoom);
  const after = (before * zoom) / camera.zoom;
  const x = pageX - camera.size / 2;
  const y = camera.size / 2 - pageY;
  moveCamera(zoom, camera.x + x / before - x / after, camera.y + y / before - y / after);
}

const zoomCentre = (factor) => zoomAt(factor, camera.size / 2, camera.size / 2);

const pan = (pixelsX, pixelsY) =>
  moveCamera(camera.zoom, camera.x - pixelsX / scaleOf(), camera.y + pixelsY / scaleOf());

/** Where a pointer is on the stage, in pixels from its upper left corner. */
function placeOf(event) {
  const box = stage.getBoundingClientRect();
  return [event.clientX - box.left - stage.clientLeft, event.clientY - box.top - stage.clientTop];
}

/** One pointer pans, two pinch. */
function watchPointers() {
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, gap: Math.hypot(a[0] - b[0], a[1] - b[1]) };
  };
  stage.addEventListener("pointerdown", (event) => {
    if (event.target.closest("button")) return;
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, placeOf(event));
    stage.classList.add("held");
  });
  stage.addEventListener("pointermove", (event) => {
    if (!pointers.has(event.pointerId)) return;
    const before = pointers.size === 2 ? spread() : null;
    const [oldX, oldY] = pointers.get(event.pointerId);
    const [x, y] = placeOf(event);
    pointers.set(event.pointerId, [x, y]);
    if (before) {
      const now = spread();
      zoomAt(now.gap / Math.max(before.gap, 1), now.x, now.y);
      pan(now.x - before.x, now.y - before.y);
    } else if (camera.zoom > 1) {
      pan(x - oldX, y - oldY);
    }
  });
  for (const end of ["pointerup", "pointercancel"]) {
    stage.addEventListener(end, (event) => {
      pointers.delete(event.pointerId);
      if (pointers.size === 0) stage.classList.remove("held");
    });
  }
}

/** The coordinates under the pointer, with as many digits as tell one pixel from the next. */
function writeCoordinates(event) {
  const digits = clamp(Math.ceil(Math.log10(scaleOf())), 0, 12);
  const [x, y] = toPlane(...placeOf(event)).map((value) => value.toFixed(digits));
  const note = document.getElementById("coordinates");
  note.textContent = `x ${x}, y ${y}`;
  note.hidden = false;
}

function watchStage() {
  watchPointers();
  stage.addEventListener("pointermove", writeCoordinates);
  stage.addEventListener("pointerleave", () => { document.getElementById("coordinates").hidden = true; });
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomAt(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), ...placeOf(event));
    writeCoordinates(event);
  }, { passive: false });
  stage.addEventListener("dblclick", (event) => {
    if (!event.target.closest("button")) zoomAt(2, ...placeOf(event));
  });
  document.getElementById("zoom-in").addEventListener("click", () => zoomCentre(1.5));
  document.getElementById("zoom-out").addEventListener("click", () => zoomCentre(1 / 1.5));
  document.getElementById("zoom-fit").addEventListener("click", fit);
}
