// SPDX-License-Identifier: MIT
#include "part.h"

#include "exit_codes.h"
#include "fuzz/target.h"

namespace homolog::fuzz {
namespace {

void run(const std::string& bytes) {
  try {
    const Box box = cli::parse_part(bytes);
    for (int axis = 0; axis < 3; ++axis) {
      require(box.min[axis] >= 0 && box.min[axis] < box.max[axis] && box.max[axis] <= 1, "a part is a box of shares");
    }
  } catch (const cli::UsageError&) {
    return;
  }
}

}  // namespace

Target part() { return {"part", {"y>0.5", "x<0.3,z>.2", "y=0.4..0.8,x=0..1", "z>1e-3,z<5E-1", "y>nan", "y>0.6,y<0.5", ","}, run}; }

}  // namespace homolog::fuzz
