// The warp played: the slider goes to the data and back by itself until it is stopped, or, where motion is unwelcome, leaps.

const oneWay = 2000; // milliseconds, as in the animation of `homolog morph`

/// The share at a phase: from 0 to 1 as the phase does, back to 0 as it goes on to 2, and so on; slow at both ends.
export const shareAt = (phase) => (1 - Math.cos(Math.PI * phase)) / 2;

/// The phase on the way there at which the share is reached.
export const phaseOf = (share) => Math.acos(1 - 2 * share) / Math.PI;

export class Player {
  /// `moveTo(share, playing)` shows a share.
  constructor(moveTo) {
    this.moveTo = moveTo;
    this.frame = 0;
  }

  /// Plays from a share on. With reduced motion it shows the end that is farther away, and no frame between.
  start(share) {
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return this.moveTo(share < 0.5 ? 1 : 0, false);
    let first;
    const step = (now) => {
      first ??= now;
      this.moveTo(shareAt(phaseOf(share) + (now - first) / oneWay), true);
      this.frame = requestAnimationFrame(step);
    };
    this.moveTo(share, true);
    this.frame = requestAnimationFrame(step);
  }

  stop() {
    cancelAnimationFrame(this.frame);
  }
}
