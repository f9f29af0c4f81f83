// The lines between matched points, drawn across the panes on a flat canvas over the picture.
import { valueColour, css } from './colours.js';

/// A curve that leaves both ends along the line between the panes, so that crossing lines stay apart near the balls.
function controls({ from, to }, stacked) {
  const bend = 0.28;
  const dx = stacked ? 0 : bend * (to.x - from.x);
  const dy = stacked ? bend * (to.y - from.y) : 0;
  return [{ x: from.x + dx, y: from.y + dy }, { x: to.x - dx, y: to.y - dy }];
}

function pointAt(line, [a, b], t) {
  const s = 1 - t;
  const blend = (k) => s ** 3 * line.from[k] + 3 * s * s * t * a[k] + 3 * s * t * t * b[k] + t ** 3 * line.to[k];
  return { x: blend('x'), y: blend('y') };
}

function stroke(context, line, stacked, width, colour) {
  const [a, b] = controls(line, stacked);
  context.beginPath();
  context.moveTo(line.from.x, line.from.y);
  context.bezierCurveTo(a.x, a.y, b.x, b.y, line.to.x, line.to.y);
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
}

function dot(context, { x, y }, radius, colour) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = '#fff';
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = colour;
  context.stroke();
}

/// `lines`: { from, to, confidence, pair }. The marked ones (hovered or chosen) come last and thicker.
export function drawLines(context, lines, marked, stacked) {
  const faded = marked.chosen >= 0 ? 0.3 : 0.85;
  const order = [...lines].sort((a, b) => (a.pair === marked.chosen) - (b.pair === marked.chosen) || a.confidence - b.confidence);
  for (const line of order) {
    const strong = line.pair === marked.chosen || line.pair === marked.hovered;
    const colour = valueColour(line.confidence);
    stroke(context, line, stacked, strong ? 6 : 3.2, 'rgb(255 255 255 / 0.65)');
    stroke(context, line, stacked, strong ? 3 : 1.5, css(colour, strong ? 1 : faded));
    for (const end of [line.from, line.to]) dot(context, end, strong ? 4.5 : 2.8, css(colour));
  }
}

/// A ring around a chosen ball.
export function drawRing(context, { x, y, radius }) {
  for (const [width, colour] of [[5, '#fff'], [2, '#1c2330']]) {
    context.beginPath();
    context.arc(x, y, radius + 3, 0, 2 * Math.PI);
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.stroke();
  }
}

/// The pair whose line passes within a few pixels, or -1.
export function pickLine(lines, x, y, stacked) {
  let [best, pair] = [7, -1];
  for (const line of lines) {
    const bend = controls(line, stacked);
    for (let i = 0; i <= 60; ++i) {
      const p = pointAt(line, bend, i / 60);
      const d = Math.hypot(p.x - x, p.y - y);
      if (d < best) [best, pair] = [d, line.pair];
    }
  }
  return pair;
}
