// All colours of the page's pictures. Confidence (or response) runs from amber (doubtful) over magenta to indigo (sure): readable on white, also for
// colour-blind eyes, because it darkens steadily.

const scale = [[0.95, 0.66, 0.2], [0.88, 0.42, 0.36], [0.72, 0.22, 0.5], [0.5, 0.2, 0.68], [0.25, 0.2, 0.7]];

export const surfaceColour = [0.8, 0.83, 0.86];
export const partColour = [0.2, 0.66, 0.62];
export const overlayColour = [0.98, 0.72, 0.35];
export const planeColour = 0x2f7fe0;
export const idleColour = [0.5, 0.55, 0.62];

export const mix = (a, b, t) => a.map((x, i) => x + t * (b[i] - x));

export function valueColour(value) {
  const x = Math.min(1, Math.max(0, value)) * (scale.length - 1);
  const i = Math.min(scale.length - 2, Math.floor(x));
  return mix(scale[i], scale[i + 1], x - i);
}

export const css = (rgb, alpha = 1) => `rgb(${rgb.map((x) => Math.round(255 * x)).join(' ')} / ${alpha})`;

export const valueGradient = `linear-gradient(90deg, ${scale.map((rgb) => css(rgb)).join(', ')})`;
