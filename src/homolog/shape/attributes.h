// SPDX-License-Identifier: MIT
// What files say of a mesh beside its form.
#pragma once

#include <string>
#include <vector>

#include "homolog/shape/mesh.h"
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
  Texturing texturing;               ///< empty if there is none
  std::vector<std::string> missing;  ///< files that the file names and that are not there
};

/// "colours, values depth, labels part, UVs, 2 materials"; empty if there are none.
std::string told_attributes(const AttributedMesh& mesh);

}  // namespace homolog
