// Everything the mouse does, by keys.
import { rollView, turnView, zoomView } from './view.js';

/// Returns the help line.
export function attachKeys(element, app) {
  const { state, set } = app;
  const view = () => app.stage.activeView();
  const turns = {
    ArrowLeft: () => turnView(view(), -0.1, 0), ArrowRight: () => turnView(view(), 0.1, 0),
    ArrowUp: () => turnView(view(), 0, -0.1), ArrowDown: () => turnView(view(), 0, 0.1),
    '+': () => zoomView(view(), 1.15), '=': () => zoomView(view(), 1.15), '-': () => zoomView(view(), 1 / 1.15),
    r: () => rollView(view(), Math.PI / 2),
  };
  const flip = (name) => () => set({ [name]: !state[name] });
  const step = (by) => () => {
    const count = app.report.matches[state.match]?.pairs.length;
    if (count) app.choosePair((state.pair + by + count) % count);
  };
  const keys = {
    p: flip('points'), u: flip('others'), l: flip('lines'), m: flip('plane'), k: flip('linked'), f: flip('aligned'), o: flip('overlay'),
    n: step(1), b: step(-1), 0: app.reset, Escape: () => set({ pair: -1, ball: null }),
  };
  for (let i = 1; i <= 9; ++i) keys[i] = () => app.chooseMatch(i - 1);

  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !app.stage) return;
    const typing = event.target.matches('input, select, button, summary');
    if (event.key === ' ' && !typing && app.report.matches.length) {
      event.preventDefault();
      app.play();
    } else if (event.key in turns && event.target === element) {
      event.preventDefault();
      turns[event.key]();
      app.stage.redraw();
    } else if (event.key in keys && !event.target.matches('select')) {
      keys[event.key]();
    }
  });
  return app.report.matches.length
    ? 'Drag turns, wheel zooms, Shift+drag moves; click a ball or a line. Keys: 1\u20139 match, n/b pair, space plays, arrows turn, 0 resets.'
    : 'Drag turns, wheel zooms, Shift+drag moves; click a ball. Keys: arrows turn, +/\u2212 zoom, r rolls, 0 resets.';
}
