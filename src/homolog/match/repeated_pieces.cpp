// SPDX-License-Identifier: MIT
#include "homolog/match/repeated_pieces.h"

#include <algorithm>

#include "homolog/match/contact.h"

namespace homolog {
namespace {

constexpr double one_movement = 0.05;  // diagonals
constexpr double same_place = 0.05;    // matched extents

}  // namespace

bool is_one_movement(const Match& match, const Shape& shape) {
  if (match.model_coverage < 0.5) return false;
  double sum = 0;
  for (std::size_t i = 0; i < shape.body.surface_count; ++i) {
    sum += (match.data_from_model(shape.body.nodes[i]) - match.similarity(shape.body.nodes[i])).norm();
  }
  return sum < one_movement * shape.diagonal * static_cast<double>(shape.body.surface_count);
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
