// SPDX-License-Identifier: MIT
// The promises of the one table: every parameter is reachable by name, survives text, and is refused out of its range.
#include "homolog/base/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& name, const std::string& value) {
  Params params;
  try {
    set_parameter(params, name, value);
  } catch (const ParamError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Parameters, DefaultsAndThePapersPresetAreInRange) {
  EXPECT_NO_THROW(check({}));
  EXPECT_NO_THROW(check(paper_preset()));
  EXPECT_EQ(paper_preset().match.seeds, Seeds::quadruples);
}

TEST(Parameters, NamesAreUniqueAndExplained) {
  std::set<std::string> names;
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(info.sentence.back(), '.') << info.name;
    EXPECT_LT(info.min, info.max) << info.name;
  }
}

TEST(Parameters, EveryValueSurvivesText) {
  for (const Params& source : {Params(), paper_preset()}) {
    Params copy;
    for (const ParameterInfo& info : parameter_table()) set_parameter(copy, info.name, to_text(get_parameter(source, info.name)));
    for (const ParameterInfo& info : parameter_table()) {
      EXPECT_EQ(get_parameter(copy, info.name), get_parameter(source, info.name)) << info.name;
    }
  }
}

TEST(Parameters, NumbersWithoutAShortFormSurviveText) {
  Params params;
  params.match.bending = 1.0 / 3;
  Params copy;
  set_parameter(copy, "bending", to_text(get_parameter(params, "bending")));
  EXPECT_EQ(copy.match.bending, params.match.bending);
}

TEST(Parameters, LimitsAreIncludedAndBeyondThemIsRefusedByName) {
  for (const ParameterInfo& info : parameter_table()) {
    if (!info.choices.empty()) continue;
    Params params;
    const double step = info.integer ? 1 : 1e-6;
    const auto text = [&](double value) { return info.integer ? to_text(static_cast<long>(value)) : to_text(value); };
    EXPECT_NO_THROW(set_parameter(params, info.name, text(info.min))) << info.name;
    EXPECT_NO_THROW(set_parameter(params, info.name, text(info.max))) << info.name;
    EXPECT_THAT(refusal(info.name, text(info.min - step)), HasSubstr("'" + info.name + "'"));
    EXPECT_THAT(refusal(info.name, text(info.max + step)), HasSubstr("'" + info.name + "'"));
  }
}

TEST(Parameters, WhatIsNoValueIsRefused) {
  for (const char* text : {"", "many", "12x", "nan", "inf", "-inf", " 64", "0x40", "1e999"}) {
    for (const char* name : {"resolution", "bending", "mirror"}) EXPECT_THAT(refusal(name, text), HasSubstr(name)) << text;
  }
  EXPECT_THAT(refusal("resolution", "64.5"), HasSubstr("whole number"));
  EXPECT_THAT(refusal("mirror", "0"), HasSubstr("allow, forbid or only"));  // choices go by their words alone
  EXPECT_THAT(refusal("resolutoin", "64"), HasSubstr("unknown parameter 'resolutoin'"));
  EXPECT_THROW(get_parameter({}, "resolutoin"), ParamError);
}

TEST(Parameters, ARefusedValueChangesNothing) {
  Params params;
  EXPECT_THROW(set_parameter(params, "partners", "0"), ParamError);
  EXPECT_EQ(params.match.partners, Params().match.partners);
}

TEST(Parameters, ValuesSetInCodeAreCheckedToo) {
  Params params;
  params.salient.threshold = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check(params), ParamError);
  params = {};
  params.match.mirror = static_cast<Mirror>(3);
  EXPECT_THROW(check(params), ParamError);
}

}  // namespace
}  // namespace homolog
