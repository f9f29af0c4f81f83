// Turning, zooming and shifting a view by mouse, touch or keys. A view is plain data; linked panes share one.
import { Quaternion, Vector2, Vector3 } from 'three';

export const makeView = (turn) => ({ turn: turn.clone(), zoom: 1, shift: new Vector2() });

export function copyView(to, from) {
  to.turn.copy(from.turn);
  to.zoom = from.zoom;
  to.shift.copy(from.shift);
}

const axisX = new Vector3(1, 0, 0);
const axisY = new Vector3(0, 1, 0);
const axisZ = new Vector3(0, 0, 1);

function rotate(view, axis, angle) {
  view.turn.premultiply(new Quaternion().setFromAxisAngle(axis, angle)).normalize();
}

export function turnView(view, dx, dy) {
  rotate(view, axisY, dx);
  rotate(view, axisX, dy);
}

export function rollView(view, angle) {
  rotate(view, axisZ, angle);
}

export function zoomView(view, factor) {
  view.zoom = Math.min(12, Math.max(0.3, view.zoom * factor));
}

/// Listens on the stage. `viewAt(x, y)` gives the view and the pane's height under a pixel; `click` and `hover` get pixels; `changed` redraws.
export function attachPointer(element, { viewAt, changed, click, hover }) {
  const fingers = new Map();
  let target = null;
  let travelled = 0;
  const at = (event) => {
    const box = element.getBoundingClientRect();
    return new Vector2(event.clientX - box.left, event.clientY - box.top);
  };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return { distance: a.distanceTo(b), middle: a.clone().add(b).multiplyScalar(0.5) };
  };
  const shift = (delta) => {
    target.view.shift.x += (2 * delta.x) / target.height;
    target.view.shift.y -= (2 * delta.y) / target.height;
  };

  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, at(event));
    if (fingers.size === 1) [target, travelled] = [viewAt(at(event).x, at(event).y), 0];
  });
  element.addEventListener('pointermove', (event) => {
    const now = at(event);
    if (!fingers.has(event.pointerId)) return hover(now.x, now.y);
    const before = fingers.size === 2 ? spread() : null;
    const delta = now.clone().sub(fingers.get(event.pointerId));
    travelled += delta.length();
    fingers.set(event.pointerId, now);
    if (before) {
      zoomView(target.view, spread().distance / (before.distance || 1));
      shift(spread().middle.sub(before.middle));
    } else if (event.shiftKey || event.buttons & 6) {
      shift(delta);
    } else {
      turnView(target.view, delta.x * 0.008, delta.y * 0.008);
    }
    changed();
  });
  const release = (event) => {
    const wasClick = event.type === 'pointerup' && fingers.size === 1 && travelled < 5;
    fingers.delete(event.pointerId);
    if (wasClick) click(at(event).x, at(event).y);
  };
  element.addEventListener('pointerup', release);
  element.addEventListener('pointercancel', release);
  element.addEventListener('pointerleave', () => hover(-1, -1));
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoomView(viewAt(at(event).x, at(event).y).view, Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)));
    changed();
  }, { passive: false });
}
