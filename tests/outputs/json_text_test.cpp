// SPDX-License-Identifier: MIT
#include "homolog/outputs/json_text.h"

#include <gtest/gtest.h>

#include "outputs/message_of.h"

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

TEST(ReadJson, SaysInOurWordsWhatIsWrong) {
  const auto message = [](const std::string& text) {
    return message_of([&] {
      read_json(text, "a.json", "matches", [](const ordered_json& json) {
        json.at("list").at(1);
        return json.at("number").get<double>();
      });
    });
  };
  const auto told = [](const std::string& what) {
    return "a.json: this is not a file of matches (" + what + "); it is another one or damaged";
  };
  EXPECT_EQ(message("[]"), told("a value in it is of the type array, which does not belong there"));
  EXPECT_EQ(message("{}"), told("key 'list' not found"));
  EXPECT_EQ(message(R"({"list":5})"), told("a value in it is of the type number, which does not belong there"));
  EXPECT_EQ(message(R"({"list":[]})"), told("a list in it is too short"));
  EXPECT_EQ(message(R"({"list":[1,2],"number":"x"})"), told("a value in it is of the type string, which does not belong there"));
  EXPECT_EQ(message(R"({"list":1e999})"), told("a number in it is too large"));
  EXPECT_EQ(message("{\n\"list\":\n  [1,\x1b"), told("it stops being JSON in line 3, at '{?\"list\":?  [1,?'"));
  EXPECT_EQ(message("{\n"), told("it stops being JSON in line 1, at '{?'"));
}

}  // namespace
}  // namespace homolog
