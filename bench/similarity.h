// SPDX-License-Identifier: MIT
// Similarities x -> s R x + t of 3-space: fitted to points, or drawn at random. Written here and not taken from the library:
// the bench must not share a mistake with what it measures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "homolog/match/thin_plate_spline.h"
#include "homolog/shape/mesh.h"

namespace homolog::bench {

/// The least-squares similarity model -> data (Umeyama 1991); `mirrored` asks for a reflection instead of a rotation.
/// Without weights all points count alike.
Similarity fit_similarity(const std::vector<Vec3>& model, const std::vector<Vec3>& data, bool mirrored, std::vector<double> weights = {});

/// The mesh where the similarity puts it.
Mesh moved(const Similarity& similarity, Mesh mesh);

/// Root mean square distance of similarity(model) to data.
double residual(const Similarity& similarity, const std::vector<Vec3>& model, const std::vector<Vec3>& data);

/// A random turn, scale (1e-3 to 1e3) and shift (up to ten sizes), the same for the same seed and name on every system.
Similarity random_similarity(std::uint64_t seed, const std::string& name, double size);

}  // namespace homolog::bench
