// The page's own arithmetic on the data of a real page: node warp_test.mjs FOLDER
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { nearest } from '../../viewer/src/colour_transfer.js';
import { planeCorners } from '../../viewer/src/mirror_plane.js';
import { phaseOf, shareAt } from '../../viewer/src/play.js';
import { readReport } from '../../viewer/src/report.js';
import { between, journey } from '../../viewer/src/warp.js';

const page = readFileSync(join(process.argv[2], 'match.html'), 'utf8');
const report = readReport(page.match(/<script type="application\/json" id="report">([^]*?)<\/script>/)[1]);
const [model, data] = report.shapes;
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

for (const [index, match] of report.matches.entries()) {
  test(`match ${index + 1} (kernel ${match.warp.kernel}): the warp carries model points onto their partners`, () => {
    const places = Float32Array.from(match.pairs.flatMap((pair) => model.points[pair.model].place));
    const { aligned, warped, home } = journey(match, places, model.mesh.centre, data.mesh.centre);
    match.pairs.forEach((pair, i) => {
      const goal = data.points[pair.data].place;
      assert.ok(distance(warped.subarray(3 * i, 3 * i + 3), goal) < 1e-4 * data.mesh.radius);
      assert.ok(distance(aligned.subarray(3 * i, 3 * i + 3), goal) < 0.35 * data.mesh.radius);
    });
    const again = journey(match, home, model.mesh.centre, data.mesh.centre).aligned;
    assert.ok(again.every((x, i) => Math.abs(x - warped[i]) < 1e-4 * data.mesh.radius), 'home is warped seen from the model');
  });
}

test('positions are read relative to the centre of the box', () => {
  assert.ok(data.mesh.centre[0] > 900, 'the fixture lies far out');
  assert.ok(data.mesh.positions.every((x) => Math.abs(x) <= data.mesh.radius));
  assert.ok(data.points.every(({ place }) => Math.hypot(...place) < data.mesh.radius));
  assert.ok(data.mesh.indices.every((i) => 3 * i < data.mesh.positions.length));
});

test('between leads from the start to the end', () => {
  assert.deepEqual([...between(new Float32Array([0, 2]), new Float32Array([4, 2]), 0.25)], [1, 2]);
});

test('playing leads to the data and back, from where the slider is', () => {
  for (const [phase, share] of [[0, 0], [0.5, 0.5], [1, 1], [1.5, 0.5], [2, 0], [3, 1]]) assert.ok(Math.abs(shareAt(phase) - share) < 1e-12);
  for (const share of [0, 0.01, 0.3, 1]) assert.ok(Math.abs(shareAt(phaseOf(share)) - share) < 1e-12);
});

test('every match says of every drawn vertex how surely it is covered', () => {
  assert.equal(report.parts.length, report.matches.length);
  for (const weights of report.parts) {
    report.shapes.forEach(({ mesh }, side) => {
      assert.equal(3 * weights[side].length, mesh.positions.length);
      assert.ok(weights[side].every((w) => w >= 0 && w <= 1));
    });
  }
  const mean = (weights) => weights.reduce((sum, w) => sum + w / weights.length, 0);
  assert.ok(mean(report.parts[0][0]) > mean(report.parts[2][0]), 'the whole animal covers more than its head');
});

test('the nearest point is found across cells, and none out of reach', () => {
  const { index, share } = nearest(new Float32Array([0, 0, 0, 0.9, 0, 0]), new Float32Array([1.1, 0, 0, -0.1, -0.1, 0, 5, 5, 5]), 1);
  assert.deepEqual([...index], [1, 0, -1]);
  assert.deepEqual([...share], [1, 1, 0]);
});

test('the rectangle of a mirror plane lies in it and is as large as the shape', () => {
  const normal = [2 / 3, -1 / 3, 2 / 3];
  const dot = (p) => p.reduce((sum, x, k) => sum + x * normal[k], 0);
  const offset = dot(data.mesh.centre) + 0.1 * data.mesh.radius;
  const corners = planeCorners(data.mesh, { normal, offset });
  for (const corner of corners) assert.ok(Math.abs(dot(corner) - 0.1 * data.mesh.radius) < 1e-6 * data.mesh.radius);
  const sides = corners.map((corner, i) => corners[(i + 1) % 4].map((x, k) => x - corner[k]));
  for (const [i, side] of sides.entries()) {
    const next = sides[(i + 1) % 4];
    assert.ok(Math.abs(side.reduce((sum, x, k) => sum + x * next[k], 0)) < 1e-6 * data.mesh.radius ** 2, 'right angles');
    const along = (p) => p.reduce((sum, x, k) => sum + x * side[k], 0);
    const [from, to] = [along(corners[i]), along(corners[(i + 1) % 4])];
    for (let k = 0; k < data.mesh.positions.length; k += 3) {
      const here = along(data.mesh.positions.subarray(k, k + 3));
      assert.ok(here > from && here < to);
    }
  }
});
