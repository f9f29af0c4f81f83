// SPDX-License-Identifier: MIT
#include "homolog/match/repeated_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "homolog/base/parallel.h"
#include "homolog/match/contact.h"
#include "homolog/match/rigid_draw.h"

namespace homolog {
namespace {

constexpr double same_place = 0.05;   // matched extents
constexpr double most_missed = 0.1;   // diagonals of the laid piece
constexpr double exact_piece = 0.01;  // what voxels leave of the smallest copies
constexpr double exact_whole = 0.03;  // copies that change places lie farther off, most of them a tenth

std::vector<SurfaceSample> moved(const std::vector<SurfaceSample>& samples, const Similarity& movement) {
  std::vector<SurfaceSample> laid;
  for (const SurfaceSample& s : samples) laid.push_back({movement(s.position), movement.rotation * s.normal});
  return laid;
}

/// How far a place lies from a skin along the normal there, nothing if the skin that is nearest within `reach` does not face its way.
std::optional<Vec3> way_to(const SurfaceSample& sample, const Skin& skin, double reach) {
  const NearestSample found = nearest_sample(skin.blocks, sample.position, reach + skin.spacing);
  if (!reaches(sample, found, skin, reach)) return {};
  const SurfaceSample& there = skin.samples[found.sample];
  return there.normal.dot(there.position - sample.position) * there.normal;
}

/// Mean square of how far those samples that lie about a skin miss it.
double square_missed(const std::vector<SurfaceSample>& samples, const Skin& skin, double reach, bool all) {
  std::vector<double> squares(samples.size(), -1);
  parallel_for(squares.size(), [&](std::size_t i) {
    const auto way = way_to(samples[i], skin, reach);
    if (way || all || nearest_sample(skin.blocks, samples[i].position, reach).sample >= 0)
      squares[i] = way ? way->squaredNorm() : reach * reach;
  });
  double sum = 0, count = 0;
  for (const double square : squares) {
    if (square >= 0) sum += square, ++count;
  }
  return count > 0 ? sum / count : reach * reach;
}

}  // namespace

double repetition_error(const Similarity& start, const std::vector<SurfaceSample>& piece, double diagonal, const Shape& whole) {
  const Skin skin{whole.surface, whole.surface_blocks, whole.surface_spacing};
  const double extent = matched_extent(diagonal, start.scale, whole.diagonal), reach = most_missed * extent;
  std::vector<SurfaceSample> samples = moved(piece, settled_rigidly(start, piece, whole.surface));
  const LaidSkin laid = laid_skin(samples, block_order(positions_of(samples)));
  return std::sqrt((square_missed(samples, skin, reach, true) + square_missed(whole.surface, laid.view(), reach, false)) / 2) / extent;
}

bool moves_all(const Match& match, const std::vector<std::vector<int>>& surfaces, const Shape& whole) {
  return std::all_of(surfaces.begin(), surfaces.end(), [&](const std::vector<int>& numbers) {
    std::vector<SurfaceSample> piece;
    for (const int i : numbers) piece.push_back(whole.surface[i]);
    return repetition_error(match.similarity, piece, diagonal_of(piece), whole) < exact_whole;
  });
}

void believe_exact(std::vector<Match>& matches, const Shape& piece, const Shape& whole) {
  for (Match& match : matches) {
    const double error = repetition_error(match.similarity, piece.surface, piece.diagonal, whole);
    const double odds = std::pow(exact_piece / std::max(error, exact_piece), 2);
    match.confidence *= odds / (match.confidence * odds + 1 - match.confidence);
  }
}

bool is_known(const Match& match, const Shape& piece, const std::vector<Match>& of_whole) {
  return std::any_of(of_whole.begin(), of_whole.end(), [&](const Match& other) {
    double sum = 0;
    for (const SurfaceSample& s : piece.surface) sum += (match.similarity(s.position) - other.similarity(s.position)).norm();
    return (match.similarity.rotation.determinant() < 0) == (other.similarity.rotation.determinant() < 0) &&
           sum < same_place * piece.diagonal * match.similarity.scale * static_cast<double>(piece.surface.size());
  });
}

void mark_reached(const Match& match, const Shape& piece, const Shape& whole, std::vector<char>& reached) {
  if (match.confidence < 0.5) return;
  std::vector<SurfaceSample> laid;
  for (const SurfaceSample& s : piece.surface) laid.push_back({match.data_from_model(s.position), match.similarity.rotation * s.normal});
  const LaidSkin skin = laid_skin(laid, block_order(positions_of(laid)));
  const double reach = same_place * matched_extent(piece.diagonal, match.similarity.scale, whole.diagonal);
  for (std::size_t i = 0; i < whole.surface.size(); ++i) reached[i] |= static_cast<char>(reaches(whole.surface[i], skin.view(), reach));
}

void add_matches(Family& family, Family of_piece, const Piece& piece, const Shape& whole) {
  const auto before = static_cast<int>(family.followed.size()), own = static_cast<int>(whole.points.size());
  const double share = static_cast<double>(piece.shape.surface.size()) / static_cast<double>(whole.surface.size());
  for (Match& match : of_piece.matches) {
    for (Correspondence& c : match.pairs) {
      c.model = piece.points[c.model];
      if (c.data >= own) c.data += before;
    }
    match.model_coverage *= share;
    family.matches.push_back(std::move(match));
  }
  family.followed.insert(family.followed.end(), of_piece.followed.begin(), of_piece.followed.end());
}

void keep_surest(Family& family, int most) {
  auto& matches = family.matches;
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) { return a.confidence > b.confidence; });
  if (std::ssize(matches) > most) matches.resize(most);
}

}  // namespace homolog
