// From where to look: a first view of a shape, and the turn that makes the model face as the data does.
import { Matrix3, Matrix4, Quaternion, Vector3 } from 'three';

const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/// How far the points reach along the axes of a frame turned by `turn`.
function extents(positions, turn) {
  const min = new Vector3(Infinity, Infinity, Infinity);
  const max = new Vector3(-Infinity, -Infinity, -Infinity);
  const p = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    p.fromArray(positions, i).applyQuaternion(turn);
    min.min(p);
    max.max(p);
  }
  return max.sub(min).toArray();
}

/// Shapes stand straight in the axes of their file, mostly. Of the data's own axes and those of the matched model, the ones whose
/// box is clearly smaller are the straighter; then looks along the thinnest side of the box, a little from the side and above.
export function firstTurn(positions, modelFromData = new Quaternion()) {
  const own = extents(positions, new Quaternion());
  const other = extents(positions, modelFromData);
  const volume = ([x, y, z]) => x * y * z;
  return volume(other) < 0.85 * volume(own) ? lookAlongThinnest(other).multiply(modelFromData) : lookAlongThinnest(own);
}

/// With y up, or z where y is the line of sight.
function lookAlongThinnest(extent) {
  const sight = extent.indexOf(Math.min(...extent));
  const [toward, up] = [axes[sight], axes[sight === 1 ? 2 : 1]];
  const right = new Vector3().crossVectors(up, toward);
  const front = new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(right, up, toward).transpose());
  const side = new Quaternion().setFromAxisAngle(axes[1], -0.45);
  const above = new Quaternion().setFromAxisAngle(axes[0], 0.22);
  return above.multiply(side).multiply(front);
}

/// The rotation of a similarity. A mirrored one is first reflected across the plane in which the model comes nearest to being its own
/// mirror image: then it looks as if it were merely turned.
export function turnOf(rows, positions) {
  const m = new Matrix3().set(...rows.slice(0, 3).flatMap((row) => row.slice(0, 3)));
  const mirrored = m.determinant() < 0;
  m.multiplyScalar(1 / Math.cbrt(Math.abs(m.determinant()) || 1));
  if (mirrored) m.multiply(reflection(mirrorNormal(positions)));
  return new Quaternion().setFromRotationMatrix(new Matrix4().setFromMatrix3(m));
}

/// Of the axes and some hundred directions besides, the one along which a reflection moves a sample of points least off the shape.
function mirrorNormal(positions) {
  const count = positions.length / 3;
  const every = (n) => Array.from({ length: Math.min(n, count) }, (_, i) => new Vector3().fromArray(positions, 3 * Math.floor((i * count) / Math.min(n, count))));
  const [few, many] = [every(150), every(700)];
  const centre = many.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(many.length);
  const cost = (normal) => few.reduce((sum, p) => {
    const image = p.clone().addScaledVector(normal, -2 * normal.dot(p.clone().sub(centre)));
    return sum + Math.sqrt(Math.min(...many.map((q) => q.distanceToSquared(image))));
  }, 0);
  return [...axes, ...halfSphere(100)].map((normal) => [cost(normal), normal]).reduce((a, b) => (b[0] < a[0] ? b : a))[1];
}

/// Evenly spread directions (a Fibonacci lattice).
function halfSphere(count) {
  return Array.from({ length: count }, (_, i) => {
    const z = (i + 0.5) / count;
    const angle = 2.399963 * i;
    return new Vector3(Math.cos(angle) * Math.sqrt(1 - z * z), Math.sin(angle) * Math.sqrt(1 - z * z), z);
  });
}

function reflection({ x, y, z }) {
  return new Matrix3().set(1 - 2 * x * x, -2 * x * y, -2 * x * z, -2 * x * y, 1 - 2 * y * y, -2 * y * z, -2 * x * z, -2 * y * z, 1 - 2 * z * z);
}
