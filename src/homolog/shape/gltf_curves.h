// SPDX-License-Identifier: MIT
// What glTF animations say of nodes: curves over time.
#pragma once

#include "homolog/shape/gltf_file.h"

namespace homolog {

/// Values over time, `width` numbers at each (glTF: animation sampler).
struct GltfCurve {
  enum class Between { straight, step, cubic };
  Between between = Between::straight;
  bool turns = false;  ///< the values are quaternions x, y, z, w
  std::size_t width = 0;
  std::vector<double> times;   ///< in seconds, from 0 on, ascending
  std::vector<double> values;  ///< of each time; if cubic: its incoming slopes, values and outgoing slopes
};

enum class GltfPath { translation, rotation, scale, weights };

/// A curve, and what of which node it moves.
struct GltfChannel {
  std::size_t node;
  GltfPath path;
  GltfCurve curve;
};

/// The channels of an animation; those that name no node or another path are left out. Throws FileError.
std::vector<GltfChannel> read_gltf_channels(const GltfFile& file, const nlohmann::json& animation);

/// The numbers at a time; before the first and after the last they stand still.
std::vector<double> values_at(const GltfCurve& curve, double time);

/// Times between which straight lines follow the curves, in ascending order, each another float: those of the curves, others between where
/// one is cubic (30 a second), and just before each step. Not all of them where there are more than `most`.
std::vector<double> times_of(const std::vector<GltfChannel>& channels, std::size_t most);

}  // namespace homolog
