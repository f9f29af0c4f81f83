// Switches over the picture, and the warp and confidence sliders below it.
import { confidenceGradient } from './colours.js';
import { make, percent } from './dom.js';

function toggle(state, set, name, label, key) {
  const input = make('input', { type: 'checkbox', id: `show-${name}`, checked: state[name], onchange: () => set({ [name]: input.checked }) });
  return make('label', { class: 'chip', title: key ? `Key ${key}` : '' }, input, make('span', {}, label));
}

function choice(state, set, name, label, options) {
  const select = make('select', { id: `show-${name}`, onchange: () => set({ [name]: select.value }) },
    Object.entries(options).map(([value, text]) => make('option', { value, selected: state[name] === value }, text)));
  return make('label', { class: 'choice' }, label, select);
}

function slider(state, set, name, label, { max = 1, step = 0.01, ...more } = {}) {
  const input = make('input', { type: 'range', id: `set-${name}`, min: '0', max: String(max), step: String(step), ...more,
    oninput: () => set({ [name]: Number(input.value) }) });
  input.value = state[name];
  return make('label', { class: 'slider' }, label, input);
}

export function fillToolbar(element, app) {
  const { state, set, report } = app;
  const pairwise = report.shapes.length > 1;
  const matched = report.matches.length > 0;
  element.append(
    toggle(state, set, 'points', 'Points', 'p'),
    ...(matched ? [toggle(state, set, 'others', 'Unmatched too', 'u'), toggle(state, set, 'lines', 'Lines', 'l')] : []),
    ...(pairwise ? [toggle(state, set, 'linked', 'Link cameras', 'k')] : []),
    ...(matched ? [toggle(state, set, 'aligned', 'Face alike', 'f')] : []),
    ...(matched ? [choice(state, set, 'colouring', 'Colour', { part: 'matched part', position: 'model position', plain: 'none' })] : []),
    slider(state, set, 'opacity', 'Surface'),
    slider(state, set, 'ballScale', 'Ball size'),
    make('span', { class: 'buttons' },
      make('button', { type: 'button', title: 'Key 0', onclick: app.reset }, 'Reset view'),
      make('button', { type: 'button', onclick: app.save }, 'Save picture')));
}

export function fillFooter(element, app) {
  const { state, set } = app;
  if (!app.report.matches.length) return;
  const play = make('button', { type: 'button', id: 'play', title: 'Space', onclick: app.play }, '\u25b6');
  element.append(
    make('div', { class: 'warp' }, play, slider(state, set, 'share', 'Warp model into data'), make('output', { id: 'share' }),
      toggle(state, set, 'overlay', 'Lay over data', 'o')),
    make('div', { class: 'legend' },
      make('span', {}, 'Confidence'),
      make('div', { class: 'scale' }, make('div', { class: 'ramp', style: `background: ${confidenceGradient}` }),
        slider(state, set, 'least', '', { 'aria-label': 'Least confidence shown' }),
        make('div', { class: 'ends' }, make('span', {}, '0'), make('output', { id: 'least' }), make('span', {}, '1')))));
}

/// Brings the controls in line with the state when keys or playing changed it.
export function refreshControls(state) {
  for (const name of ['points', 'others', 'lines', 'linked', 'aligned', 'overlay']) {
    const input = document.getElementById(`show-${name}`);
    if (input) input.checked = state[name];
  }
  const share = document.getElementById('set-share');
  if (!share) return;
  share.value = state.share;
  document.getElementById('share').textContent = percent(state.share);
  document.getElementById('play').textContent = state.playing ? '\u275a\u275a' : '\u25b6';
  document.getElementById('least').textContent = state.least > 0 ? `shown from ${state.least.toFixed(2)}` : 'all pairs shown';
}
