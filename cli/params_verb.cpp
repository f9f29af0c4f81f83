// SPDX-License-Identifier: MIT
// homolog params: every parameter with symbol, value, range, unit and sentence.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "console.h"
#include "exit_codes.h"
#include "options.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

using nlohmann::ordered_json;

struct ParamsOptions {
  ParameterOptions parameters;
  bool json = false;
};

constexpr const char* kExamples = R"(Examples:
  # What can be chosen, and what is chosen if nothing is said
  homolog params
  # The paper's choices, as JSON
  homolog params --preset paper --json)";

std::string params_text(const Params& params) {
  std::string text = fmt::format("{:18}  {:8}  {:12}  {}\n", "name", "symbol", "value", "range");
  for (const ParameterInfo& info : parameter_table()) {
    const std::string value = to_text(get_parameter(params, info.name));
    text += fmt::format("{:18}  {:8}  {:12}  {}", info.name, info.symbol, value, range_text(info));
    text += fmt::format("{}{}\n    {}\n", info.unit.empty() ? "" : " ", info.unit, info.sentence);
  }
  return text;
}

std::string params_json(const Params& params) {
  ordered_json list = ordered_json::array();
  for (const ParameterInfo& info : parameter_table()) {
    ordered_json item = {{"name", info.name}, {"symbol", info.symbol}};
    std::visit([&](const auto& value) { item["value"] = value; }, get_parameter(params, info.name));
    if (info.choices.empty()) {
      item["range"] = {info.min, info.max};
    } else {
      item["choices"] = info.choices;
    }
    item["unit"] = info.unit;
    item["sentence"] = info.sentence;
    list.push_back(std::move(item));
  }
  return list.dump(1) + "\n";
}

}  // namespace

Verb add_params(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("params", "List every parameter with its symbol, value, range, unit and meaning.");
  const auto options = std::make_shared<ParamsOptions>();
  verb->add_flag("--json", options->json, "Print JSON instead of a table.");
  add_preset_option(*verb, options->parameters);
  verb->footer(kExamples);
  return {verb, [options] {
            const Params params = params_of(options->parameters);
            print_result(options->json ? params_json(params) : params_text(params));
            return static_cast<int>(kFound);
          }};
}

}  // namespace homolog::cli
