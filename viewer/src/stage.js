// The picture: both panes on one canvas, the lines on a second one over it.
import { ColorManagement, LinearSRGBColorSpace, Quaternion, WebGLRenderer } from 'three';
import { idleColour, valueColour } from './colours.js';
import { drawLines, drawRing, pickLine } from './lines.js';
import { confidentPairs, plainColours } from './looks.js';
import { firstTurn } from './orientation.js';
import { Pane } from './pane.js';
import { attachPointer, copyView, makeView } from './view.js';
import { between } from './warp.js';

ColorManagement.enabled = false;

export class Stage {
  constructor(element, report, looks, actions) {
    Object.assign(this, { element, report, looks });
    [this.picture, this.flat] = element.querySelectorAll('canvas');
    this.renderer = new WebGLRenderer({ canvas: this.picture, antialias: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setClearColor(0xffffff);
    this.renderer.autoClear = false;
    this.panes = report.shapes.map((shape) => new Pane(shape));
    if (this.panes[1]) this.panes[1].layOver(report.shapes[0].mesh);
    this.start = firstTurn(report.shapes.at(-1).mesh.positions, report.matches.length ? looks.of(0).turn.clone().invert() : undefined);
    this.views = this.panes.map(() => makeView(this.start));
    this.turn = new Quaternion();
    this.goal = new Quaternion();
    new ResizeObserver(() => this.redraw()).observe(element);
    attachPointer(this.flat, { ...actions, viewAt: (x, y) => this.viewAt(x, y), changed: () => this.redraw() });
  }

  viewAt(x, y) {
    const i = Math.max(0, this.panes.findIndex((pane) => pane.contains(x, y)));
    this.active = i;
    return { view: this.views[this.linked ? 0 : i], height: this.panes[i].area.height };
  }

  /// The view that keys turn: the shared one, or that of the pane used last.
  activeView() {
    return this.views[this.linked ? 0 : this.active ?? 0];
  }

  resetViews() {
    for (const view of this.views) copyView(view, makeView(this.start));
    this.redraw();
  }

  /// Takes over what is to be shown and draws it.
  show(state) {
    if (state.linked !== this.linked && this.linked !== undefined) copyView(this.views[1] ?? this.views[0], this.views[0]);
    this.linked = state.linked;
    this.state = state;
    this.match = this.report.matches[state.match];
    this.look = this.match && this.looks.of(state.match);
    this.pairs = confidentPairs(this.match, state.least);
    this.goal = this.look && state.aligned ? this.look.turn : new Quaternion();
    this.placeSurfaces();
    this.placeBalls();
    this.placePlanes();
    this.redraw();
  }

  placeSurfaces() {
    const { state, look, panes, report } = this;
    const colours = look ? this.looks.colours(look, state.colouring) : report.shapes.map(plainColours);
    panes.forEach(({ surface }, side) => {
      surface.opacity = state.opacity;
      surface.paint(colours[side], look ? look.weights[side] : new Float32Array(colours[side].length / 3));
    });
    if (!look) return panes[1] && (panes[1].overlay.group.visible = false);
    const [model, data] = panes;
    model.surface.place(between(report.shapes[0].mesh.positions, look.surface.home, state.share));
    data.overlay.group.visible = state.overlay && state.share > 0;
    data.overlay.place(between(look.surface.aligned, look.surface.warped, state.share));
    data.overlay.paint(look.overlay, look.weights[0]);
    data.overlay.opacity = 0.55 * Math.min(1, state.share * 5);
  }

  placeBalls() {
    const { state, look, panes, pairs } = this;
    panes.forEach((pane, side) => {
      const places = Float32Array.from(pane.shape.points.flatMap((point) => point.place));
      if (look && side === 0) between(places, look.balls.home, state.share, places);
      const values = look
        ? new Map(pairs.map((pair) => [side ? pair.data : pair.model, pair.confidence]))
        : new Map([...pane.shape.points.entries()].map(([i, { response }]) => [i, response]).filter(([, value]) => value >= state.least));
      pane.shape.points.forEach(({ radius, followed }, i) => {
        const solid = values.has(i);
        pane.balls.set(i, {
          place: places.subarray(3 * i, 3 * i + 3),
          radius: radius * state.ballScale,
          shown: state.points && (solid || (look && state.others && !followed)),
          colour: solid ? valueColour(values.get(i)) : idleColour,
          solid,
        });
      });
    });
  }

  placePlanes() {
    const symmetry = this.report.symmetries[this.state.match];
    for (const { plane } of this.panes) plane.show(this.state.plane && symmetry?.normal && symmetry);
  }

  redraw() {
    this.pending ??= requestAnimationFrame(() => {
      this.pending = undefined;
      this.draw();
    });
  }

  draw() {
    if (!this.state) return;
    this.layout();
    this.turnModel();
    const { renderer, panes } = this;
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    const height = this.element.clientHeight;
    panes.forEach((pane, side) => {
      pane.look(this.views[this.linked ? 0 : side], side === 0 && panes.length > 1 ? this.turn : undefined);
      const { x, y, width, height: h } = pane.area;
      renderer.setViewport(x, height - y - h, width, h);
      renderer.setScissor(x, height - y - h, width, h);
      renderer.render(pane.scene, pane.camera);
    });
    this.drawFlat();
  }

  /// The model turns smoothly to face as the data does in the chosen match.
  turnModel() {
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches || this.turn.angleTo(this.goal) < 0.01 || !this.drawn;
    this.turn.slerp(this.goal, still ? 1 : 0.2);
    this.drawn = true;
    if (!still) this.redraw();
  }

  layout() {
    const { clientWidth: width, clientHeight: height } = this.element;
    const ratio = Math.min(2, devicePixelRatio);
    this.stacked = width < 0.95 * height;
    if (width !== this.width || height !== this.height || ratio !== this.ratio) {
      Object.assign(this, { width, height, ratio });
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      [this.flat.width, this.flat.height] = [width * ratio, height * ratio];
    }
    const n = this.panes.length;
    const size = this.stacked ? { width, height: height / n } : { width: width / n, height };
    this.panes.forEach((pane, i) => {
      pane.area = { ...size, x: this.stacked ? 0 : i * size.width, y: this.stacked ? i * size.height : 0 };
    });
    this.element.classList.toggle('stacked', this.stacked);
  }

  linesOnStage() {
    if (!this.state.lines || !this.match) return [];
    const [model, data] = this.panes;
    return this.pairs.map((pair) => ({
      from: model.project(model.balls.list[pair.model].centre.toArray()),
      to: data.project(data.balls.list[pair.data].centre.toArray()),
      confidence: pair.confidence,
      pair: pair.index,
    }));
  }

  drawFlat() {
    const context = this.flat.getContext('2d');
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    const { pair, ball, hovered } = this.state;
    for (const { side, index } of this.chosenBalls(pair, ball)) drawRing(context, this.panes[side].ballOnStage(index));
    drawLines(context, this.linesOnStage(), { chosen: pair, hovered }, this.stacked);
  }

  chosenBalls(pair, ball) {
    if (ball) return [ball];
    const chosen = this.match?.pairs[pair];
    return chosen ? [{ side: 0, index: chosen.model }, { side: 1, index: chosen.data }] : [];
  }

  /// What lies under a pixel: { pair } or { ball: { side, index } } or nothing.
  pick(x, y) {
    const side = this.panes.findIndex((pane) => pane.contains(x, y));
    if (side < 0) return {};
    const index = this.panes[side].pick(x, y);
    const pair = index < 0 ? pickLine(this.linesOnStage(), x, y, this.stacked) : this.pairOf(side, index);
    if (pair >= 0) return { pair };
    return index < 0 ? {} : { ball: { side, index } };
  }

  pairOf(side, index) {
    return this.pairs.find((pair) => (side ? pair.data : pair.model) === index)?.index ?? -1;
  }

  /// The whole picture with its lines, as a PNG.
  toBlob() {
    const whole = document.createElement('canvas');
    [whole.width, whole.height] = [this.picture.width, this.picture.height];
    this.draw();
    const context = whole.getContext('2d');
    context.drawImage(this.picture, 0, 0);
    context.drawImage(this.flat, 0, 0);
    return new Promise((resolve) => whole.toBlob(resolve, 'image/png'));
  }
}
