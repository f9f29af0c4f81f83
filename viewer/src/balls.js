// The balls of one shape, drawn in two strokes: solid ones, then glass ones from far to near.
import { DynamicDrawUsage, Group, InstancedMesh, Matrix4, Sphere, SphereGeometry, Vector3, Color } from 'three';
import { ballMaterial } from './materials.js';

const geometry = new SphereGeometry(1, 32, 20);

function makeSet(count, glass) {
  const set = new InstancedMesh(geometry, ballMaterial(glass), Math.max(1, count));
  set.setColorAt(0, new Color());
  set.instanceMatrix.setUsage(DynamicDrawUsage);
  set.frustumCulled = false;
  return set;
}

export class Balls {
  constructor(count) {
    this.list = Array.from({ length: count }, () => ({ centre: new Vector3(), radius: 0, colour: [0, 0, 0], solid: false, shown: false }));
    this.solid = makeSet(count, false);
    this.glass = makeSet(count, true);
    this.group = new Group().add(this.solid, this.glass);
  }

  set(index, { place, ...ball }) {
    Object.assign(this.list[index], ball).centre.fromArray(place);
  }

  /// Fills both sets for a viewer at `eye`, in the frame of the balls.
  arrange(eye) {
    const shown = this.list.filter((ball) => ball.shown).sort((a, b) => b.centre.distanceToSquared(eye) - a.centre.distanceToSquared(eye));
    for (const [set, balls] of [[this.solid, shown.filter((ball) => ball.solid)], [this.glass, shown.filter((ball) => !ball.solid)]]) {
      set.count = balls.length;
      balls.forEach(({ centre, radius, colour }, i) => {
        set.setMatrixAt(i, new Matrix4().makeScale(radius, radius, radius).setPosition(centre));
        set.setColorAt(i, new Color(...colour));
      });
      set.instanceMatrix.needsUpdate = true;
      set.instanceColor.needsUpdate = true;
    }
  }

  /// The index of the first ball that a ray meets, solid ones before glass, or -1.
  pick(ray) {
    const hits = this.list.map(({ shown, centre, radius, solid }, index) => {
      const hit = shown && ray.intersectSphere(new Sphere(centre, radius), new Vector3());
      return { index, solid, distance: hit ? hit.distanceTo(ray.origin) : Infinity };
    });
    const nearest = (list) => list.reduce((a, b) => (b.distance < a.distance ? b : a), { index: -1, distance: Infinity }).index;
    const solid = nearest(hits.filter((hit) => hit.solid));
    return solid >= 0 ? solid : nearest(hits);
  }
}
