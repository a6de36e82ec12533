// Which step of the path is shown, and what moves it: as in the player, for a path that changes.

import { clamp, story } from "player";

const by = (id) => document.getElementById(id);
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

/** position is a step with its fraction; direction is 1, -1, or 0 while paused. */
const playing = { position: 0, direction: 0, speed: 1, before: 0, show: () => {}, announce: () => {} };

const last = () => Math.max(story.states - 1, 0);

export const now = () => Math.min(Math.round(playing.position), last());

/** The speed 1 takes 20 seconds for the whole path, within what the eye can follow. */
const stepsPerSecond = () => clamp(last() / 20, 30, 1500) * playing.speed;

/** Call when the story has another path: the same share of the way is shown. */
export function keepShare(statesBefore) {
  playing.position = statesBefore > 1 ? (playing.position / (statesBefore - 1)) * last() : 0;
  by("scrub").max = last();
}

export function writeScrub() {
  by("scrub").value = now();
  by("scrub").setAttribute("aria-valuetext", `step ${now()} of ${last()}`);
}

function writePlaying() {
  const forward = playing.direction > 0;
  by("playback").classList.toggle("playing", forward);
  by("play").setAttribute("aria-label", forward ? "Pause" : "Play");
  by("rewind").setAttribute("aria-pressed", String(playing.direction < 0));
}

export function pause() {
  if (playing.direction === 0) return;
  playing.direction = 0;
  writePlaying();
}

function play(direction) {
  if (last() === 0) return;
  if (direction > 0 && now() >= last()) playing.position = 0;
  if (direction < 0 && now() <= 0) return;
  const standing = playing.direction === 0;
  playing.direction = direction;
  playing.before = performance.now();
  writePlaying();
  if (standing) requestAnimationFrame(advance);
}

function advance(time) {
  if (playing.direction === 0) return;
  // A tab that was away for long goes on where it was, not seconds later.
  const seconds = clamp((time - playing.before) / 1000, 0, 0.1);
  playing.before = time;
  const next = playing.position + playing.direction * seconds * stepsPerSecond();
  playing.position = clamp(next, 0, last());
  playing.show();
  if (playing.position === next) requestAnimationFrame(advance);
  else pause();
}

const toggle = (direction) => (playing.direction === direction ? pause() : play(direction));

/** Shows one step and stays there. */
export function goTo(state) {
  if (story.states === 0) return;
  pause();
  playing.position = clamp(state, 0, last());
  playing.show();
  playing.announce(now(), last());
}

export const commands = {
  "to-start": () => goTo(0),
  "rewind": () => toggle(-1),
  "step-back": () => goTo(now() - 1),
  "play": () => toggle(1),
  "step-on": () => goTo(now() + 1),
  "to-end": () => goTo(last()),
};

export function watchPlayback({ show, announce }) {
  Object.assign(playing, { show, announce });
  for (const speed of [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8, 16]) {
    by("speed").add(new Option(`${speed}\u00d7`, speed, false, speed === (reducedMotion.matches ? 0.25 : 1)));
  }
  playing.speed = Number(by("speed").value);
  by("speed").addEventListener("change", () => { playing.speed = Number(by("speed").value); });
  for (const [id, command] of Object.entries(commands)) by(id).addEventListener("click", command);
  by("scrub").addEventListener("input", () => goTo(Number(by("scrub").value)));
}
