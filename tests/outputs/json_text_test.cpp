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

TEST(JsonText, FillsLinesWithPlainValues) {
  const std::string text = json_text(ordered_json(std::vector<int>(100, 7)));
  const std::size_t end = text.find('\n', 2);
  EXPECT_EQ(text.substr(0, 6), "[\n 7,7");
  EXPECT_GT(end, 150u);
  EXPECT_LE(end, 162u);
  EXPECT_EQ(ordered_json::parse(text).size(), 100u);
}

TEST(JsonText, ReadsBackTheSame) {
  ordered_json json = ordered_json::array();
  for (int i = 1; i < 200; ++i) json.push_back({{"share", 1.0 / i}, {"list", {i, 1e300 / i, "a\n\"b"}}});
  EXPECT_EQ(ordered_json::parse(json_text(json)), json);
}

}  // namespace
}  // namespace homolog
