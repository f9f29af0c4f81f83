// Puts the page together: one state, one way to change it.
import { make } from './dom.js';
import { attachKeys } from './keys.js';
import { Looks } from './looks.js';
import { fillPanel, refreshPanel } from './panel.js';
import { Player } from './play.js';
import { readReport } from './report.js';
import { Stage } from './stage.js';
import { fillButtons, fillFooter, fillToolbar, fittingOpacity, refreshControls } from './toolbar.js';

const byId = (id) => document.getElementById(id);
const report = readReport(byId('report').textContent);
const state = {
  match: report.matches.length ? 0 : -1, pair: -1, ball: null, hovered: -1,
  share: 0, playing: false, overlay: true, least: 0,
  points: true, others: true, lines: true, plane: true, linked: true, aligned: true,
  colouring: 'part', opacity: fittingOpacity.part, ballScale: 1,
};

const app = { report, state, set, chooseMatch, choosePair, chooseBall, play, pause, save, reset: () => app.stage?.resetViews() };

function set(change) {
  const before = { ...state };
  Object.assign(state, change);
  const changed = { match: before.match !== state.match };
  app.stage?.show(state);
  refreshControls(state);
  if ('match' in change || 'pair' in change || 'ball' in change) refreshPanel(app, changed);
}

function chooseMatch(match) {
  if (match >= 0 && match < report.matches.length) set({ match, pair: -1, ball: null });
}

function choosePair(pair) {
  set({ pair, ball: null });
}

function chooseBall(ball) {
  set({ ball, pair: -1 });
}

const player = new Player((share, playing) => set({ share, playing }));

function play() {
  if (state.playing) pause();
  else player.start(state.share);
}

function pause(change = {}) {
  player.stop();
  set({ ...change, playing: false });
}

async function save() {
  const url = URL.createObjectURL(await app.stage.toBlob());
  make('a', { href: url, download: 'homolog.png' }).click();
  URL.revokeObjectURL(url);
}

function hover(x, y) {
  const found = x < 0 ? {} : app.stage.pick(x, y);
  byId('view').style.cursor = found.pair >= 0 || found.ball ? 'pointer' : 'grab';
  const hovered = found.pair ?? -1;
  if (hovered !== state.hovered) {
    state.hovered = hovered;
    app.stage.redraw();
  }
}

function click(x, y) {
  const found = app.stage.pick(x, y);
  set({ pair: found.pair ?? -1, ball: found.ball ?? null });
}

function writeTitle() {
  const names = report.shapes.map((shape) => shape.name);
  document.title = `${names.join(' \u2194 ')} \u00b7 homolog`;
  byId('title').append(...names.flatMap((name, i) => [...(i ? [make('span', { class: 'arrow' }, '\u2194')] : []), make('span', {}, name)]));
  const roles = report.shapes.length > 1 ? ['model', 'data'] : ['shape'];
  const found = ({ points }) => points.filter((point) => !point.followed).length;
  byId('summary').textContent = report.shapes.map((shape, i) => `${roles[i]}: ${found(shape)} salient points`).join(' \u00b7 ');
  byId('captions').append(...report.shapes.map((shape, i) => make('div', {}, make('b', {}, roles[i]), ` ${shape.name}`, drawnNote(shape.mesh))));
}

function drawnNote({ indices, triangles }) {
  const drawn = indices.length / 3;
  return make('small', {}, drawn < triangles ? ` drawn with ${drawn.toLocaleString('en')} of ${triangles.toLocaleString('en')} triangles` : '');
}

function start() {
  writeTitle();
  fillButtons(byId('buttons'), app);
  fillToolbar(byId('toolbar'), app);
  fillFooter(byId('footer'), app);
  fillPanel(byId('panel'), app);
  byId('help').textContent = attachKeys(byId('view'), app);
  try {
    app.stage = new Stage(byId('view'), report, new Looks(report), { click, hover });
  } catch (error) {
    byId('view').replaceChildren(make('p', { class: 'trouble' }, `The shapes cannot be drawn here: ${error.message} The numbers beside are complete.`));
  }
  set({});
  refreshPanel(app, { match: true });
}

start();
