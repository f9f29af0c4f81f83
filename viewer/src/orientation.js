// From where to look: a first view of a shape, and the turn that makes the model face as the data does.
import { Matrix3, Matrix4, Quaternion, Vector3 } from 'three';

/// Looks along the thinnest side of the bounding box, with y up (z where y is the line of sight), a little from the side and above.
export function firstTurn(positions) {
  const extent = [0, 1, 2].map((k) => {
    let [min, max] = [Infinity, -Infinity];
    for (let i = k; i < positions.length; i += 3) [min, max] = [Math.min(min, positions[i]), Math.max(max, positions[i])];
    return max - min;
  });
  const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
  const sight = extent.indexOf(Math.min(...extent));
  const [toward, up] = [axes[sight], axes[sight === 1 ? 2 : 1]];
  const right = new Vector3().crossVectors(up, toward);
  const front = new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(right, up, toward).transpose());
  const side = new Quaternion().setFromAxisAngle(axes[1], -0.45);
  const above = new Quaternion().setFromAxisAngle(axes[0], 0.22);
  return above.multiply(side).multiply(front);
}

/// The rotation of a similarity. A mirrored one is first reflected across the plane that leaves the least to turn.
export function turnOf(rows) {
  const m = new Matrix3().set(...rows.slice(0, 3).flatMap((row) => row.slice(0, 3)));
  const mirrored = m.determinant() < 0;
  m.multiplyScalar(1 / Math.cbrt(Math.abs(m.determinant()) || 1));
  if (mirrored) m.multiply(reflection(mirrorAxis(m)));
  return new Quaternion().setFromRotationMatrix(new Matrix4().setFromMatrix3(m));
}

/// The axis n with Q n = -n of an orthogonal Q with determinant -1: orthogonal to all rows of Q + I.
function mirrorAxis(q) {
  const rows = [0, 1, 2].map((i) => new Vector3(q.elements[i], q.elements[3 + i], q.elements[6 + i]).add(new Vector3().setComponent(i, 1)));
  const crossed = [[0, 1], [1, 2], [2, 0]].map(([i, j]) => new Vector3().crossVectors(rows[i], rows[j]));
  const axis = crossed.reduce((a, b) => (a.lengthSq() >= b.lengthSq() ? a : b));
  return axis.lengthSq() > 1e-12 ? axis.normalize() : new Vector3(1, 0, 0);
}

function reflection({ x, y, z }) {
  return new Matrix3().set(1 - 2 * x * x, -2 * x * y, -2 * x * z, -2 * x * y, 1 - 2 * y * y, -2 * y * z, -2 * x * z, -2 * y * z, 1 - 2 * z * z);
}
