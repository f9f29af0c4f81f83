// One shape in its pane: surface, balls at the salient points, mirror plane, and (on the side of the data) the warped model laid over it.
import {
  BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, PerspectiveCamera, Quaternion, Raycaster, Scene, Vector2, Vector3,
} from 'three';
import { Balls } from './balls.js';
import { surfaceMaterial } from './materials.js';
import { MirrorPlane } from './mirror_plane.js';

const fieldOfView = 26;

/// Clearing needs leave to write depth, which the ball drawn before may have taken away.
function clearDepth(renderer) {
  renderer.state.buffers.depth.setMask(true);
  renderer.clearDepth();
}

/// A surface as glass over everything drawn before: depth first, then the colour of the layer nearest to the viewer.
export class Surface {
  constructor({ positions, indices }, order) {
    this.geometry = new BufferGeometry();
    this.geometry.setIndex(new BufferAttribute(indices, 1));
    this.geometry.setAttribute('position', new BufferAttribute(positions.slice(), 3));
    this.geometry.setAttribute('tint', new BufferAttribute(new Float32Array(positions.length), 3));
    this.geometry.setAttribute('part', new BufferAttribute(new Float32Array(positions.length / 3), 1));
    this.geometry.computeVertexNormals();
    this.material = surfaceMaterial();
    const depth = new Mesh(this.geometry, new MeshBasicMaterial({ colorWrite: false, transparent: true, side: DoubleSide }));
    const colour = new Mesh(this.geometry, this.material);
    depth.renderOrder = order;
    colour.renderOrder = order + 1;
    depth.onBeforeRender = clearDepth;
    this.group = new Group().add(depth, colour);
    for (const mesh of [depth, colour]) mesh.frustumCulled = false;
  }

  place(positions) {
    this.geometry.attributes.position.copyArray(positions).needsUpdate = true;
    this.geometry.computeVertexNormals();
  }

  paint(tint, part) {
    this.geometry.attributes.tint.copyArray(tint).needsUpdate = true;
    this.geometry.attributes.part.copyArray(part).needsUpdate = true;
  }

  set opacity(value) { this.material.uniforms.opacity.value = value; }
}

export class Pane {
  constructor(shape) {
    this.shape = shape;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.1, 100);
    this.turned = new Group();
    this.frame = new Group();
    this.frame.scale.setScalar(1 / shape.mesh.radius);
    this.scene.add(this.turned.add(this.frame));
    this.surface = new Surface(shape.mesh, 10);
    this.balls = new Balls(shape.points.length);
    this.plane = new MirrorPlane(shape.mesh);
    this.frame.add(this.surface.group, this.balls.group, this.plane.group);
    this.area = { x: 0, y: 0, width: 1, height: 1 };
    this.fit = 1;
  }

  /// Lays the model over this pane's shape, in this shape's frame.
  layOver(mesh) {
    this.overlay = new Surface(mesh, 20);
    this.frame.add(this.overlay.group);
  }

  /// Sets camera and turn; `aligned` is the rotation that makes this shape face as the other does.
  look(view, aligned = new Quaternion()) {
    const { width, height } = this.area;
    this.turned.quaternion.copy(view.turn);
    this.frame.quaternion.copy(aligned);
    const half = Math.tan((fieldOfView * Math.PI) / 360);
    const distance = this.fit / Math.sin((fieldOfView * Math.PI) / 360) / view.zoom / Math.min(1, width / height);
    this.turned.position.set(view.shift.x * half * distance, view.shift.y * half * distance, 0);
    this.camera.aspect = width / height;
    this.camera.position.z = distance;
    this.camera.near = Math.max(0.01, distance - 5);
    this.camera.far = distance + 5;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.scene.updateMatrixWorld();
    this.balls.arrange(this.frame.worldToLocal(this.camera.position.clone()));
  }

  /// Where a point of the shape (relative to its centre) lies on the stage, in pixels.
  project(place) {
    const p = new Vector3(...place).applyMatrix4(this.frame.matrixWorld).project(this.camera);
    return { x: this.area.x + (p.x + 1) * 0.5 * this.area.width, y: this.area.y + (1 - p.y) * 0.5 * this.area.height };
  }

  ballOnStage(index) {
    const ball = this.balls.list[index];
    const centre = this.project(ball.centre.toArray());
    const world = ball.radius * this.frame.scale.x;
    const depth = this.camera.position.z - this.frame.localToWorld(ball.centre.clone()).z;
    const radius = ((world / depth / Math.tan((fieldOfView * Math.PI) / 360)) * this.area.height) / 2;
    return { ...centre, radius };
  }

  contains(x, y) {
    const { area } = this;
    return x >= area.x && x < area.x + area.width && y >= area.y && y < area.y + area.height;
  }

  /// The index of the ball under a pixel of the stage, or -1.
  pick(x, y) {
    const { area } = this;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * (x - area.x)) / area.width - 1, 1 - (2 * (y - area.y)) / area.height), this.camera);
    return this.balls.pick(ray.ray.applyMatrix4(this.frame.matrixWorld.clone().invert()));
  }
}
