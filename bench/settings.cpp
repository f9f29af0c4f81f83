// SPDX-License-Identifier: MIT
#include "settings.h"

#include <fmt/format.h>

#include "homolog/base/errors.h"

namespace homolog::bench {

void set_parameters(Params& params, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw ParamError(fmt::format("'--param {}': expected NAME=VALUE", setting));
    set_parameter(params, setting.substr(0, equals), setting.substr(equals + 1));
  }
}

}  // namespace homolog::bench
