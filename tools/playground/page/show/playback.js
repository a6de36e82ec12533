// The player's playback on a page whose path changes. It calls show and announce of this module.

import { by, commands, fillSpeeds, goTo, lastStep, now, playing } from "player";

let listeners = { show: () => {}, announce: () => {} };

/** Another step is to be shown. */
export const show = () => listeners.show();

/** The playback stands still at a step. */
export const announce = () => listeners.announce(now(), lastStep());

let lastStepBefore = 0;

/** Call when the story has another path: the same share of the way is shown, also where there was no path in between. */
export function keepShare() {
  playing.position = lastStepBefore > 0 ? (playing.position / lastStepBefore) * lastStep() : 0;
  lastStepBefore = lastStep();
  by("scrub").max = lastStep();
}

export function writeScrub() {
  by("scrub").value = now();
  by("scrub").setAttribute("aria-valuetext", `step ${now()} of ${lastStep()}`);
}

export function watchPlayback(given) {
  listeners = given;
  fillSpeeds();
  by("speed").addEventListener("change", () => { playing.speed = Number(by("speed").value); });
  for (const [id, command] of Object.entries(commands)) by(id).addEventListener("click", command);
  by("scrub").addEventListener("input", () => goTo(Number(by("scrub").value)));
}
