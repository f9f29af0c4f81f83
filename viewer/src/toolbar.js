// Switches over the picture, and the warp and confidence sliders below it.
import { valueGradient } from './colours.js';
import { make, percent } from './dom.js';

function toggle(state, set, name, label, key) {
  const input = make('input', { type: 'checkbox', id: `show-${name}`, checked: state[name], onchange: () => set({ [name]: input.checked }) });
  return make('label', { class: 'chip', title: key ? `Key ${key}` : '' }, input, make('span', {}, label));
}

/// Colours that tell a place need a denser surface than the glass in which the balls lie.
export const fittingOpacity = { part: 0.3, position: 0.9, plain: 0.3 };

function choice(state, set, name, label, options) {
  const select = make('select', { id: `show-${name}`, onchange: () => set({ [name]: select.value, opacity: fittingOpacity[select.value] }) },
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
    ...(matched ? [toggle(state, set, 'others', 'Unmatched', 'u'), toggle(state, set, 'lines', 'Lines', 'l')] : []),
    ...(report.symmetries.some(({ normal }) => normal) ? [toggle(state, set, 'plane', 'Mirror plane', 'm')] : []),
    ...(pairwise ? [toggle(state, set, 'linked', 'Linked', 'k')] : []),
    ...(matched ? [toggle(state, set, 'aligned', 'Face alike', 'f')] : []),
    ...(matched ? [choice(state, set, 'colouring', 'Colour', { part: 'part', position: 'position', plain: 'none' })] : []),
    slider(state, set, 'opacity', 'Surface'),
    slider(state, set, 'ballScale', 'Ball size'));
}

export function fillButtons(element, app) {
  element.append(
    make('button', { type: 'button', title: 'Key 0', onclick: app.reset }, 'Reset view'),
    make('button', { type: 'button', onclick: app.save }, 'Save picture'));
}

export function fillFooter(element, app) {
  if (app.report.matches.length) element.append(warpControls(app), legend(app, 'Confidence'));
  else element.append(legend(app, 'Response (a ball: 1, a cylinder: 0.79)'));
}

function legend({ state, set }, title) {
  return make('div', { class: 'legend' },
    make('span', {}, title),
    make('div', { class: 'scale' }, make('div', { class: 'ramp', style: `background: ${valueGradient}` }),
      slider(state, set, 'least', '', { 'aria-label': 'Least value shown' }),
      make('div', { class: 'ends' }, make('span', {}, '0'), make('output', { id: 'least' }), make('span', {}, '1'))));
}

function warpControls(app) {
  const { state, set, pause } = app;
  const play = make('button', { type: 'button', id: 'play', onclick: app.play });
  return make('div', { class: 'warp' }, play, slider(state, pause, 'share', 'Warp model into data'), make('output', { id: 'share' }),
    toggle(state, set, 'overlay', 'Lay over data', 'o'));
}

/// Brings the controls in line with the state when keys or playing changed it.
export function refreshControls(state) {
  for (const name of ['points', 'others', 'lines', 'plane', 'linked', 'aligned', 'overlay']) {
    const input = document.getElementById(`show-${name}`);
    if (input) input.checked = state[name];
  }
  document.getElementById('set-opacity').value = state.opacity;
  document.getElementById('least').textContent = state.least > 0 ? `shown from ${state.least.toFixed(2)}` : 'all shown';
  const share = document.getElementById('set-share');
  if (!share) return;
  share.value = state.share;
  document.getElementById('share').textContent = percent(state.share);
  const play = document.getElementById('play');
  play.textContent = state.playing ? '\u275a\u275a' : '\u25b6';
  play.setAttribute('aria-label', state.playing ? 'Pause' : 'Play the warp, there and back');
  play.title = `${state.playing ? 'Pause' : 'Play'} (space)`;
}
