// The column beside the picture: the family of matches, the numbers of what was clicked, the pairs, and how they were found.
import { valueColour, css } from './colours.js';
import { make, percent, place, short } from './dom.js';

const handednessNote = {
  proper: 'not mirrored', mirrored: 'the part is a mirror image', ambiguous: 'the part is its own mirror image, or too flat to tell',
};

function meter(confidence) {
  return make('span', { class: 'meter', title: `confidence ${short(confidence)}` },
    make('span', { style: `width: ${100 * confidence}%; background: ${css(valueColour(confidence))}` }));
}

const leastError = 1e-5;  // in diagonals; smaller ones are a matter of rounding

const errorOf = ({ error }) => `${Number((100 * Math.max(error, leastError)).toPrecision(2))}\u2009%`;

/// What a match of a shape with itself says, in a line.
function symmetryNote(symmetry) {
  if (!symmetry) return [];
  const does = symmetry.normal ? 'mirror plane' : `repeated${symmetry.mirrored ? ' as its mirror image' : ''}, turned by ${symmetry.degrees.toFixed(1)}\u00b0`;
  return [make('span', { class: 'second symmetry', title: 'root of the mean square distance from the surface, in diagonals' },
    `${does}, error ${errorOf(symmetry)}`)];
}

function symmetryNumbers(symmetry) {
  if (!symmetry) return [];
  const { normal, offset, degrees, axis, shift } = symmetry;
  const does = normal
    ? [['mirror plane', `normal ${place(normal.map((x) => Math.round(1e4 * x) / 1e4))}; offset ${short(offset)}`]]
    : [['turned by', `${degrees.toFixed(1)}\u00b0 about ${place(axis)}`], ['shifted by', place(shift)]];
  if (symmetry.mirrored) does.unshift(['mirror image', 'x negated first']);
  return [...does, ['error', `${errorOf(symmetry)} of the diagonal (root mean square)`]];
}

function matchEntry(match, index, app) {
  const input = make('input', { type: 'radio', name: 'match', value: String(index), onchange: () => app.chooseMatch(index) });
  return make('label', { class: 'match' }, input,
    make('span', { class: 'rank' }, String(index + 1)),
    make('span', { class: 'facts' },
      make('span', { class: 'first' }, make('b', {}, `${match.pairs.length} pairs`), meter(match.confidence), percent(match.confidence)),
      make('span', { class: 'second', title: 'handedness, scale, and the shares of model and data that the match explains' },
        make('span', { class: `hand ${match.handedness}`, title: handednessNote[match.handedness] ?? '' }, match.handedness),
        ` \u00d7${match.scale.toPrecision(3)} \u00b7 covers ${Math.round(100 * match.model_coverage)} / ${percent(match.data_coverage)}`),
      symmetryNote(app.report.symmetries[index])));
}

function familyList(app) {
  const { matches, doubt } = app.report;
  return make('section', { id: 'family', 'aria-label': 'Matches' },
    make('h2', {}, matches.length === 1 ? 'One match' : `${matches.length} matches`, make('small', {}, 'best first')),
    doubt ? [make('p', { class: 'doubt' }, doubt)] : [],
    make('div', { class: 'matches' }, matches.map((match, index) => matchEntry(match, index, app))));
}

function table(head, rows) {
  return make('table', {}, make('thead', {}, make('tr', {}, head.map((text) => make('th', { scope: 'col' }, text)))), make('tbody', {}, rows));
}

function pairRows(app, match) {
  return match.pairs.map((pair, index) => {
    const choose = make('button', { type: 'button', onclick: () => app.choosePair(index) }, String(index + 1));
    const cells = [choose, pair.model, pair.data, short(pair.descriptor_distance), pair.confidence.toFixed(2)];
    const row = make('tr', { 'data-pair': String(index), onclick: () => app.choosePair(index) }, cells.map((cell) => make('td', {}, cell)));
    row.lastChild.style.color = css(valueColour(pair.confidence));
    return row;
  });
}

function pointRows(app) {
  return app.report.shapes[0].points.map((point, index) => {
    const choose = make('button', { type: 'button', onclick: () => app.chooseBall({ side: 0, index }) }, String(index));
    return make('tr', { 'data-point': String(index), onclick: () => app.chooseBall({ side: 0, index }) },
      [choose, short(point.radius), point.response.toFixed(2)].map((cell) => make('td', {}, cell)));
  });
}

function numbers(rows) {
  return make('table', { class: 'numbers' }, make('tbody', {}, rows.map(([name, ...values]) =>
    make('tr', {}, make('th', { scope: 'row' }, name), values.map((value) => make('td', { colspan: String(3 - values.length) }, value))))));
}

function pairNumbers({ report, state }) {
  const match = report.matches[state.match];
  const pair = match.pairs[state.pair];
  const [a, b] = [report.shapes[0].points[pair.model], report.shapes[1].points[pair.data]];
  return [make('h2', {}, `Pair ${state.pair + 1}`, make('small', {}, `of ${match.pairs.length}`)), numbers([
    ['', 'model', 'data'],
    ['point', String(pair.model), b.followed ? `${pair.data}, followed by the map` : String(pair.data)],
    ['radius', short(a.radius), short(b.radius)],
    ['response', short(a.response), short(b.response)],
    ['position', place(a.position), place(b.position)],
    ['radius ratio', `${short(b.radius / a.radius)}  (match: ${short(match.scale)})`],
    ['descriptor distance', short(pair.descriptor_distance)],
    ['confidence', short(pair.confidence)],
  ])];
}

function pointNumbers({ report, state: { ball } }) {
  const { name, points } = report.shapes[ball.side];
  const point = points[ball.index];
  return [make('h2', {}, `Point ${ball.index}`, make('small', {}, name)), numbers([
    ['radius', short(point.radius)],
    ['response', short(point.response)],
    ['position', place(point.position)],
    ['direction', point.direction.some((x) => x !== 0) ? place(point.direction) : 'none'],
    ...(report.matches.length ? [['', 'not matched']] : []),
  ])];
}

function matchNumbers({ report, state }) {
  const match = report.matches[state.match];
  return [make('h2', {}, `Match ${state.match + 1}`), numbers([
    ['confidence', short(match.confidence)],
    ['handedness', `${match.handedness}${handednessNote[match.handedness] ? `: ${handednessNote[match.handedness]}` : ''}`],
    ['scale', short(match.scale)],
    ['covers', `${percent(match.model_coverage)} of the model, ${percent(match.data_coverage)} of the data`],
    ...symmetryNumbers(report.symmetries[state.match]),
    ['bending', short(match.bending)],
    ['chamfer', short(match.chamfer)],
  ]), make('p', { class: 'hint' }, 'Click a ball, a line or a row below to read its numbers.')];
}

export function fillPanel(element, app) {
  const { report } = app;
  const details = make('section', { id: 'details', 'aria-live': 'polite' });
  const rows = make('section', { id: 'rows' });
  if (report.matches.length) element.append(familyList(app), details, rows);
  else if (report.shapes.length > 1) element.append(nothingFound(), details);
  else element.append(details, rows);
  element.append(howFound(report));
}

function nothingFound() {
  return make('section', { id: 'nothing' }, make('h2', {}, 'Nothing found'),
    make('p', {}, 'No part of the model was found again in the data. The balls show the salient points of both; the table below tells at ' +
      'which stage the last candidate was given up.'));
}

function howFound({ counts, parameters, program, shapes, matches }) {
  const list = (object) => numbers(Object.entries(object).map(([name, value]) => [name, String(value)]));
  const stages = Object.keys(counts).length ? [make('h3', {}, 'Left after each stage'), list(counts)] : [];
  return make('details', { open: shapes.length > 1 && !matches.length, id: 'how' }, make('summary', {}, 'How it was found'), ...stages, make('h3', {}, 'Parameters'),
    list(parameters), make('p', { class: 'hint' }, program));
}

/// Shows the numbers of the chosen pair, point or match.
export function refreshPanel(app, changed) {
  const { report, state } = app;
  const match = report.matches[state.match];
  const details = document.getElementById('details');
  if (state.ball) details.replaceChildren(...pointNumbers(app));
  else if (match && state.pair >= 0) details.replaceChildren(...pairNumbers(app));
  else if (match) details.replaceChildren(...matchNumbers(app));
  else details.replaceChildren(make('p', { class: 'hint' }, 'Click a ball to read its numbers.'));
  if (changed.match && match) refreshRows(table(['#', 'model', 'data', 'distance', 'conf.'], pairRows(app, match)), 'Pairs');
  if (changed.match && report.shapes.length === 1) {
    refreshRows(table(['point', 'radius', 'response'], pointRows(app)), `${report.shapes[0].points.length} salient points`);
  }
  for (const input of document.getElementsByName('match')) input.checked = Number(input.value) === state.match;
  markRow(state);
}

function refreshRows(content, title) {
  document.getElementById('rows').replaceChildren(make('h2', {}, title), content);
}

/// Scrolls the panel alone: on a phone the page must stay at the picture.
function bringIntoView(row, panel) {
  const [inner, outer] = [row.getBoundingClientRect(), panel.getBoundingClientRect()];
  if (inner.bottom > outer.bottom) panel.scrollTop += inner.bottom - outer.bottom + 10;
  if (inner.top < outer.top) panel.scrollTop -= outer.top - inner.top + 10;
}

function markRow({ pair, ball }) {
  for (const row of document.querySelectorAll('#rows tbody tr')) {
    const chosen = row.dataset.pair ? Number(row.dataset.pair) === pair : Number(row.dataset.point) === ball?.index;
    row.classList.toggle('chosen', chosen);
    if (chosen) bringIntoView(row, document.getElementById('panel'));
  }
}
