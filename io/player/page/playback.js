// Which step of the path is shown, and what moves it.

const by = (id) => document.getElementById(id);

const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

/** position is a step of the path with its fraction; direction is 1, -1, or 0 while paused. */
const playing = { position: 0, direction: 0, speed: 1, before: 0 };

const lastStep = () => story.lastStep;

/** The index of the state that is shown. */
const now = () => stateNear(Math.round(playing.position));

/** The speed 1 takes 20 seconds for the whole path, within what the eye can follow. */
const stepsPerSecond = () => clamp(lastStep() / 20, 30, 1500) * playing.speed;

function fillSpeeds() {
  for (const speed of [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8, 16]) {
    by("speed").add(new Option(`${speed}\u00d7`, speed, false, speed === (reducedMotion.matches ? 0.25 : 1)));
  }
  playing.speed = Number(by("speed").value);
}

function writePlaying() {
  const forward = playing.direction > 0;
  by("playback").classList.toggle("playing", forward);
  by("play").setAttribute("aria-label", forward ? "Pause" : "Play");
  by("rewind").setAttribute("aria-pressed", String(playing.direction < 0));
}

function pause() {
  playing.direction = 0;
  writePlaying();
  announce();
}

function play(direction) {
  if (lastStep() === 0) return;
  if (direction > 0 && playing.position >= lastStep()) playing.position = 0;
  if (direction < 0 && playing.position <= 0) return;
  const stood = playing.direction === 0;
  playing.direction = direction;
  playing.before = performance.now();
  writePlaying();
  if (stood) requestAnimationFrame(advance);
}

function advance(time) {
  if (playing.direction === 0) return;
  // A tab that was away for long goes on where it was, not seconds later.
  const seconds = clamp((time - playing.before) / 1000, 0, 0.1);
  playing.before = time;
  const next = playing.position + playing.direction * seconds * stepsPerSecond();
  playing.position = clamp(next, 0, lastStep());
  show();
  if (playing.position === next) requestAnimationFrame(advance);
  else pause();
}

const toggle = (direction) => (playing.direction === direction ? pause() : play(direction));

/** Shows one state, by its index, and stays there. */
function goToState(state) {
  if (story.states === 0) return;
  playing.position = story.steps[clamp(state, 0, story.states - 1)];
  show();
  pause();
}

/** Shows one step, or the nearest to it that the page holds. */
const goTo = (step) => goToState(stateNear(clamp(step, 0, lastStep())));

/** The bar has all steps: one move of it leads to another state, also where steps are left out. */
function followBar() {
  const step = Number(by("scrub").value);
  const state = stateNear(step);
  goToState(state === now() ? state + Math.sign(step - story.steps[state]) : state);
}

const commands = {
  "to-start": () => goTo(0),
  "rewind": () => toggle(-1),
  "step-back": () => goToState(now() - 1),
  "play": () => toggle(1),
  "step-on": () => goToState(now() + 1),
  "to-end": () => goTo(lastStep()),
};
