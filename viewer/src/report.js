// Reads the data of the page: the result as in match.json or points.json, a sentence when no match
// is likely, the meshes, the parts that matches cover, and, of a shape
// against itself, what its matches say as in symmetry.json.
// All positions leave here relative to the centre of their own shape, so that single precision is enough to draw them.

function bytes(base64) {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer;
}

function readMesh({ centre, positions, indices, triangles }) {
  const mesh = { centre, positions: new Float32Array(bytes(positions)), indices: new Uint32Array(bytes(indices)), triangles };
  let square = 0;
  for (let i = 0; i < mesh.positions.length; i += 3) {
    square = Math.max(square, mesh.positions[i] ** 2 + mesh.positions[i + 1] ** 2 + mesh.positions[i + 2] ** 2);
  }
  mesh.radius = Math.sqrt(square) || 1;
  return mesh;
}

/// Points after the first `found` are followed ones: only the match that tells them shows them.
function readShape(side, meshData, found) {
  const mesh = readMesh(meshData);
  const points = side.points.map((point, i) => ({ ...point, followed: i >= found, place: point.position.map((x, k) => x - mesh.centre[k]) }));
  return { name: side.file, points, mesh };
}

/// For every vertex of a mesh how surely it lies in the covered part, 0 to 1.
const readWeights = (base64) => Float32Array.from(new Uint8Array(bytes(base64)), (byte) => byte / 255);

export function readReport(text) {
  const { result, doubt, meshes, parts, itself } = JSON.parse(text);
  const sides = result.shape ? [result.shape] : [result.model, result.data];
  return {
    program: result.program,
    parameters: result.parameters,
    counts: result.counts ?? {},
    matches: result.matches ?? [],
    doubt,
    symmetries: itself.symmetries,
    parts: parts.map((sides) => sides.map(readWeights)),
    shapes: sides.map((side, i) => readShape(side, meshes[i], i ? result.counts['data points'] : side.points.length)),
  };
}
