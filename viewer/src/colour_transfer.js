// How the colours of a surface travel.

/// 1 up to `full`, 0 from `none`, smooth between.
function fade(distance, full, none) {
  const s = Math.min(1, Math.max(0, (none - distance) / (none - full)));
  return s * s * (3 - 2 * s);
}

/// A smooth colour for every place of a shape.
export function positionColours(positions) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3], x);
    max[i % 3] = Math.max(max[i % 3], x);
  });
  return positions.map((x, i) => 0.2 + 0.72 * ((x - min[i % 3]) / (max[i % 3] - min[i % 3] || 1)));
}

/// For every query point the nearest of `positions` within `reach`, found by a grid of cells, and a share that fades with its distance.
export function nearest(positions, queries, reach) {
  // Cells that collide under one key do no harm: distances decide.
  const key = (i, j, k) => (i * 73856093) ^ (j * 19349663) ^ (k * 83492791);
  const cell = (x) => Math.floor(x / reach);
  const cells = new Map();
  for (let i = 0; i < positions.length; i += 3) {
    const name = key(cell(positions[i]), cell(positions[i + 1]), cell(positions[i + 2]));
    const list = cells.get(name);
    if (list) list.push(i);
    else cells.set(name, [i]);
  }
  const index = new Int32Array(queries.length / 3).fill(-1);
  const share = new Float32Array(index.length);
  for (let q = 0; q < index.length; ++q) {
    const [x, y, z] = queries.subarray(3 * q, 3 * q + 3);
    let best = reach * reach;
    for (let n = 0; n < 27; ++n) {
      const list = cells.get(key(cell(x) + (n % 3) - 1, cell(y) + (Math.floor(n / 3) % 3) - 1, cell(z) + Math.floor(n / 9) - 1));
      for (const i of list ?? []) {
        const d = (positions[i] - x) ** 2 + (positions[i + 1] - y) ** 2 + (positions[i + 2] - z) ** 2;
        if (d < best) [best, index[q]] = [d, i / 3];
      }
    }
    share[q] = fade(Math.sqrt(best), reach / 2, reach);
  }
  return { index, share };
}
