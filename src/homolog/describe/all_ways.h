// SPDX-License-Identifier: MIT
// The shortest ways between all nodes of a body, from many sources at once.
#pragma once

#include <Eigen/Core>

#include "homolog/describe/body.h"

namespace homolog {

/// Column s is shortest_ways(body, {s}).
Eigen::MatrixXd all_ways(const Body& body);

}  // namespace homolog
