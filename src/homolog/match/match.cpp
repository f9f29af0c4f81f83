// SPDX-License-Identifier: MIT
#include "homolog/match/match.h"

namespace homolog {

const char* handedness_name(Handedness handedness) {
  switch (handedness) {
    case Handedness::proper:
      return "proper";
    case Handedness::mirrored:
      return "mirrored";
    case Handedness::ambiguous:
      break;
  }
  return "ambiguous";
}

}  // namespace homolog
