// SPDX-License-Identifier: MIT
// Beyond the paper: the model's body laid over the data like a stiff cloth. Nodes keep the local shape of the body (as rigid as
// possible, Sorkine & Alexa 2007) while soft two-way assignment draws the skin on to the data's skin.
// In: a start for every node. Out: refined nodes and the dense evidence that ranks matches.
#pragma once

#include <optional>
#include <vector>

#include "homolog/describe/body.h"
#include "homolog/describe/sample_blocks.h"
#include "homolog/match/thin_plate_spline.h"

namespace homolog {

/// Where the nodes of the model's body lie in the data.
struct Cloth {
  std::vector<Vec3> nodes;      ///< mapped Body::nodes, data coordinates
  std::vector<Mat3> rotations;  ///< local, of the wanted chirality
  std::vector<double> scales;   ///< local
  std::vector<Mat3> rest;       ///< how the body's edges are stretched when nothing draws them, in the model's coordinates
  std::vector<Mat3> frames;     ///< how they lie there: rotation times stretch, which lies between the rest and the measured one
  Chirality chirality = Chirality::proper;
  double scale = 1;  ///< of the whole
};

/// A node that shall lie at a place.
struct Anchor {
  std::size_t node;
  Vec3 place;
};

/// Limb places of the model's skin and of the data's samples; both empty where limbs do not count.
struct LimbPlaces {
  std::vector<LimbPlace> model, data;
};

/// Share of the measured stretch that the body's edges take over from one step to the next, so that limbs can get longer.
inline constexpr double usual_give = 0.5;

/// The part of the skin that is drawn: what lies within a way inside from a node. The rest follows stiffly.
struct Front {
  std::size_t node;
  double way;  ///< model units
};

/// From wide to narrow and from stiff to soft, in geometric steps; lengths in data diagonals.
struct ClothSchedule {
  int iterations;
  double first_reach, last_reach;
  double first_stiffness, last_stiffness;
  double give = usual_give;
  std::optional<Front> front = {};  ///< all of the skin, if none
};

/// The steps of a schedule from `begin` up to `end`, as a schedule of their own.
ClothSchedule steps_of(const ClothSchedule& schedule, int begin, int end);

/// Lays the body by the spline, without looking at the data.
Cloth lay_cloth(const Body& model, const ThinPlateSpline& data_from_model, Chirality chirality);

/// The same with every node at a place of its own, about as the similarity has them.
Cloth lay_cloth(const Body& model, std::vector<Vec3> places, const Similarity& similarity, Chirality chirality);

/// The body's surface samples where the cloth lays them.
std::vector<SurfaceSample> mapped_skin(const Cloth& cloth, const Body& model);

/// Draws the cloth on to the data's surface samples, along the limbs if their places are told.
void draw_cloth(Cloth& cloth, const Body& model, const std::vector<SurfaceSample>& data, double data_diagonal,
                const std::vector<Anchor>& anchors, const ClothSchedule& schedule, const LimbPlaces& limbs = {});

}  // namespace homolog
