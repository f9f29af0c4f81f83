// SPDX-License-Identifier: MIT
// match.json, and parts.json behind a NUL byte; the first match then carries two points there and back, which must end.
#include "homolog/outputs/match_json.h"

#include "fuzz/target.h"
#include "homolog/outputs/parts.h"
#include "homolog/outputs/read_match.h"
#include "outputs/match_fixture.h"

namespace homolog::fuzz {
namespace {

std::string both_files() {
  Shape model = fixtures::shape("model.off", 1);
  const Shape data = fixtures::shape("data.off", 2);
  model.surface = {{{0.1, 0.2, 0.3}, Vec3::UnitX()}, {{1, 2, 3}, Vec3::UnitX()}};
  const Mesh mesh{{{0, 0, 0}}, {}};
  const MatchParts part{{{1}, {1, 0.25f}}, {{0}, {}}};
  return match_json(model, data, fixtures::family(model, data), {}) + '\0' + text_of([&](const Sink& sink) {
           write_parts_json({mesh, model}, {mesh, data}, {part}, sink);
         });
}

std::string smallest() {
  return R"({"format":"homolog-match","version":1,"model":{"file":"a","diagonal":1,"points":[{"position":[0,0,0]}]},)"
         R"("data":{"file":"b","diagonal":2,"points":[{"position":[0,0,1]}]},"matches":[)"
         R"({"confidence":1,"pairs":[{"model":0,"data":0,"confidence":0.5}],"scale":2,"data_from_model":[[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]],)"
         R"("warp":{"kernel":"r3","centres":[[0,0,0],[1,0,0]],"weights":[[0,0,1],[0,0,-1]],)"
         R"("affine":[[2,0,0,0],[0,2,0,0],[0,0,2,1e-300]]}},{"confidence":0,"pairs":[{"model":0,"data":0,"confidence":1}],"scale":1,)"
         R"("data_from_model":[[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]],"warp":{"kernel":"r","centres":[],"weights":[],)"
         R"("affine":[[1,0,0,0],[0,1,0,0],[0,0,1,0]]}}]})";
}

/// What is read as a whole can be written.
void run_whole(const NamedText& match, const std::optional<NamedText>& parts) {
  ReadResult read;
  try {
    read = read_result(match, parts);
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  homolog::match_json(read.model, read.data, read.family, read.params);
  if (!read.parts) return;
  const Mesh mesh;
  text_of([&](const Sink& sink) { write_parts_json({mesh, read.model}, {mesh, read.data}, *read.parts, sink); });
}

void run(const std::string& bytes) {
  const std::size_t end = bytes.find('\0');
  std::optional<NamedText> parts;
  if (end != bytes.npos) parts = {bytes.substr(end + 1), "parts"};
  run_whole({bytes.substr(0, end), "match"}, parts);
  StoredFamily family;
  try {
    family = read_family({bytes.substr(0, end), "match"}, parts);
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  if (family.matches.empty()) return;
  const std::vector<Vec3> points{{0, 0, 0}, {0.5, -3, 7}};
  for (const Direction direction : {Direction::data_from_model, Direction::model_from_data}) {
    require(carry_points(family.matches[0], points, direction).size() == points.size(), "every point is carried");
  }
}

}  // namespace

Target match_json() { return {"match_json", {both_files(), smallest(), smallest() + '\0' + "{}"}, run}; }

}  // namespace homolog::fuzz
