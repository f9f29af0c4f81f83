// SPDX-License-Identifier: MIT
#include "homolog/outputs/json_text.h"

#include <gtest/gtest.h>

namespace homolog {
namespace {

using nlohmann::ordered_json;

TEST(JsonText, PutsWhatFitsOnOneLine) {
  EXPECT_EQ(json_text(ordered_json::parse(R"({"b":[1,0.1],"a":{}})")), "{\"b\":[1,0.1],\"a\":{}}\n");
}

TEST(JsonText, BreaksWhatIsTooLong) {
  const std::string word(100, 'x');
  ordered_json json;
  json["first"] = {word, word};
  json["second"] = 2;
  EXPECT_EQ(json_text(json), "{\n \"first\": [\n  \"" + word + "\",\n  \"" + word + "\"\n ],\n \"second\": 2\n}\n");
}

TEST(JsonText, ReadsBackTheSame) {
  ordered_json json = ordered_json::array();
  for (int i = 1; i < 200; ++i) json.push_back({{"share", 1.0 / i}, {"list", {i, 1e300 / i, "a\n\"b"}}});
  EXPECT_EQ(ordered_json::parse(json_text(json)), json);
}

}  // namespace
}  // namespace homolog
