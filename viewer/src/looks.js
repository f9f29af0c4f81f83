// What one match looks like: colours of both surfaces, where the warp carries the model, how the model turns. Computed once a match.
import { mix, overlayColour, partColour, surfaceColour } from './colours.js';
import { turnOf } from './orientation.js';
import { nearest, positionColours } from './colour_transfer.js';
import { journey } from './warp.js';

export function confidentPairs(match, least) {
  return match ? match.pairs.map((pair, index) => ({ ...pair, index })).filter((pair) => pair.confidence >= least) : [];
}

function fill(count, colourOf) {
  const out = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) out.set(colourOf(i), 3 * i);
  return out;
}

const paint = (weights, colour) => fill(weights.length, (i) => mix(surfaceColour, colour, weights[i]));

/// The model's position colours pulled to the data, as far as the warped model comes to lie on it.
function pullColours(colours, warped, data) {
  const { index, share } = nearest(warped, data.positions, 0.08 * data.radius);
  return fill(index.length, (i) => {
    const source = 3 * index[i];
    return index[i] < 0 ? surfaceColour : mix(surfaceColour, colours.subarray(source, source + 3), share[i]);
  });
}

export class Looks {
  constructor(report) {
    this.report = report;
    this.cache = new Map();
  }

  of(index) {
    if (!this.cache.has(index)) this.cache.set(index, this.make(this.report.matches[index], this.report.parts[index]));
    return this.cache.get(index);
  }

  make(match, weights) {
    const [model, data] = this.report.shapes;
    const travel = (positions) => journey(match, positions, model.mesh.centre, data.mesh.centre);
    const look = {
      turn: turnOf(match.data_from_model, model.mesh.positions),
      weights,
      surface: travel(model.mesh.positions),
      balls: travel(Float32Array.from(model.points.flatMap((point) => point.place))),
      colours: {},
    };
    look.overlay = paint(look.weights[0], overlayColour);
    return look;
  }

  /// Colours of both surfaces in the given way: 'part', 'position' or 'plain'.
  colours(look, colouring) {
    look.colours[colouring] ??= this.makeColours(look, colouring);
    return look.colours[colouring];
  }

  makeColours({ weights, surface }, colouring) {
    if (colouring === 'plain') return weights.map((w) => fill(w.length, () => surfaceColour));
    if (colouring === 'part') return weights.map((w) => paint(w, partColour));
    const [model, data] = this.report.shapes;
    const colours = positionColours(model.mesh.positions);
    return [colours, pullColours(colours, surface.warped, data.mesh)];
  }
}

/// Both surfaces when there is no match to show.
export function plainColours(shape) {
  return fill(shape.mesh.positions.length / 3, () => surfaceColour);
}
