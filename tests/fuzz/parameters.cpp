// SPDX-License-Identifier: MIT
// Lines of a parameter's name and value; a value taken is in range, and as text gives itself again.
#include "homolog/base/parameters.h"

#include "fuzz/target.h"

namespace homolog::fuzz {
namespace {

void run(const std::string& bytes) {
  Params params;
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const std::string name(line.substr(0, line.find(' '))), value(line.substr(std::min(name.size() + 1, line.size())));
    try {
      set_parameter(params, name, value);
    } catch (const ParamError&) {
      continue;
    }
    check(params);
    const ParameterValue taken = get_parameter(params, name);
    set_parameter(params, name, to_text(taken));
    require(get_parameter(params, name) == taken, "a value as text gives itself again");
  }
}

}  // namespace

Target parameters() {
  Target target{"parameters", {"resolution 64.0\nmirror only\nresolution nan\nsigma0 1e300\nnone 1\n"}, run};
  for (const ParameterInfo& info : parameter_table()) {
    target.seeds.push_back(info.name + ' ' + to_text(get_parameter({}, info.name)) + '\n');
  }
  return target;
}

}  // namespace homolog::fuzz
