// SPDX-License-Identifier: MIT
// What files say of a mesh beside its form.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "homolog/shape/mesh.h"
#include "homolog/shape/rig.h"
#include "homolog/shape/texturing.h"

namespace homolog {

/// A number for every vertex. Between two values lie others; between two labels, such as the numbers of parts, lies none.
struct Field {
  enum class Kind { value, label };
  std::string name;
  Kind kind = Kind::value;
  std::vector<double> values;  ///< NaN: none
  double no_label = -1;        ///< what stands for none in files; no label of the field is that
};

struct AttributedMesh {
  Mesh mesh;                  ///< as read_mesh() reads it
  std::vector<Rgba> colours;  ///< of every vertex; empty if there are none
  std::vector<Field> fields;
  Texturing texturing;  ///< empty if there is none
  Rig rig;              ///< without joints if there is none
  std::vector<ShapeKey> shape_keys;
  std::vector<Animation> animations;
  std::vector<std::filesystem::path> files;  ///< that it was read from: the one that was named and those that this names
  std::vector<std::string> missing;          ///< files that the file names and that are not there
  std::vector<std::string> left_out;         ///< what else the file holds and is not read, as "textures by a second set of UVs"
};

/// The bytes of a file that another one names; none if it is not there.
using FindOther = std::function<std::optional<std::string>(const std::string& name)>;

/// "colours, values depth, labels part, UVs, 2 materials, weights of 25 joints, 3 shape keys, 1 animation"; empty if there are none.
std::string told_attributes(const AttributedMesh& mesh);

}  // namespace homolog
