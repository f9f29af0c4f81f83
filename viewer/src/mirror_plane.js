// The plane in which a shape is its own mirror image, as a rectangle of blue glass as large as the shape.
import { BufferAttribute, BufferGeometry, DoubleSide, Group, LineBasicMaterial, LineLoop, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { planeColour } from './colours.js';

const margin = 0.06;  // of the shape's radius

/// Two directions in the plane; one is the projection of the axis that lies nearest to the plane, so that the rectangle stands straight.
function directions(normal) {
  const sizes = normal.toArray().map(Math.abs);
  const axis = new Vector3().setComponent(sizes.indexOf(Math.min(...sizes)), 1);
  const u = axis.addScaledVector(normal, -axis.dot(normal)).normalize();
  return [u, new Vector3().crossVectors(normal, u)];
}

function range(positions, direction) {
  let [least, most] = [Infinity, -Infinity];
  const p = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    const along = p.fromArray(positions, i).dot(direction);
    [least, most] = [Math.min(least, along), Math.max(most, along)];
  }
  return [least, most];
}

/// The corners of the rectangle, in turn, relative to the centre of the mesh; the plane is normal . x = offset in the coordinates of the file.
export function planeCorners({ positions, centre, radius }, { normal, offset }) {
  const n = new Vector3(...normal);
  const foot = n.clone().multiplyScalar(offset - n.dot(new Vector3(...centre)));
  const [u, v] = directions(n);
  const [[u0, u1], [v0, v1]] = [u, v].map((direction) => range(positions, direction));
  const gap = margin * radius;
  return [[u0 - gap, v0 - gap], [u1 + gap, v0 - gap], [u1 + gap, v1 + gap], [u0 - gap, v1 + gap]].map(([a, b]) =>
    foot.clone().addScaledVector(u, a).addScaledVector(v, b).toArray());
}

/// Drawn before the surface, through which one sees it, and again after, where it lies in front.
export class MirrorPlane {
  constructor(mesh) {
    this.mesh = mesh;
    this.corners = new BufferAttribute(new Float32Array(12), 3);
    const outline = new BufferGeometry().setAttribute('position', this.corners);
    const rectangle = new BufferGeometry().setAttribute('position', this.corners).setIndex([0, 1, 2, 0, 2, 3]);
    const look = { color: planeColour, transparent: true, depthWrite: false };
    const glass = new MeshBasicMaterial({ ...look, opacity: 0.16, side: DoubleSide });
    const border = new LineBasicMaterial({ ...look, opacity: 0.6 });
    this.group = new Group();
    for (const order of [5, 30]) {
      const drawn = [new Mesh(rectangle, glass), new LineLoop(outline, border)];
      for (const one of drawn) Object.assign(one, { renderOrder: order, frustumCulled: false });
      this.group.add(...drawn);
    }
  }

  /// Nothing without a plane.
  show(plane) {
    this.group.visible = Boolean(plane);
    if (plane) this.corners.copyArray(planeCorners(this.mesh, plane).flat()).needsUpdate = true;
  }
}
