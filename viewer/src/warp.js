// Carries points of the model into the data: by the warp of a match, and by the similarity nearest to it.

/// f(x) = affine [x; 1] + sum_k weights_k phi(|x - centres_k|), in the coordinates of the two files.
function warpFunction({ kernel, centres, weights, affine }) {
  const c = Float64Array.from(centres.flat());
  const w = Float64Array.from(weights.flat());
  const cubic = kernel === 'r3';
  return (x, y, z) => {
    const out = affine.map((row) => row[0] * x + row[1] * y + row[2] * z + row[3]);
    for (let k = 0; k < c.length; k += 3) {
      const r = Math.sqrt((x - c[k]) ** 2 + (y - c[k + 1]) ** 2 + (z - c[k + 2]) ** 2);
      const phi = cubic ? r * r * r : r;
      out[0] += w[k] * phi;
      out[1] += w[k + 1] * phi;
      out[2] += w[k + 2] * phi;
    }
    return out;
  };
}

const similarityFunction = (rows) => (x, y, z) =>
  [0, 1, 2].map((i) => rows[i][0] * x + rows[i][1] * y + rows[i][2] * z + rows[i][3]);

/// The inverse of a similarity: the transposed linear part over the square of the scale.
function inverse(rows) {
  const square = rows[0][0] ** 2 + rows[0][1] ** 2 + rows[0][2] ** 2;
  return [0, 1, 2].map((i) => {
    const row = [0, 1, 2].map((j) => rows[j][i] / square);
    return [...row, -(row[0] * rows[0][3] + row[1] * rows[1][3] + row[2] * rows[2][3])];
  });
}

/// Applies f to points given relative to one centre; the result is relative to the other.
function mapAll(f, positions, from, to) {
  const out = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const y = f(positions[i] + from[0], positions[i + 1] + from[1], positions[i + 2] + from[2]);
    for (let k = 0; k < 3; ++k) out[i + k] = y[k] - to[k];
  }
  return out;
}

/// Where given model points go: aligned and warped in the frame of the data, and the warped ones seen from the model's own frame.
export function journey(match, positions, model, data) {
  const aligned = mapAll(similarityFunction(match.data_from_model), positions, model, data);
  const warped = mapAll(warpFunction(match.warp), positions, model, data);
  const back = similarityFunction(inverse(match.data_from_model));
  return { aligned, warped, home: mapAll(back, warped, data, model) };
}

export function between(start, end, share, out = new Float32Array(start.length)) {
  for (let i = 0; i < start.length; ++i) out[i] = start[i] + share * (end[i] - start[i]);
  return out;
}
