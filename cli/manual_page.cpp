// SPDX-License-Identifier: MIT
#include "manual_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "option_list.h"

namespace homolog::cli {
namespace {

constexpr const char* common_group = "Options";

/// Text as roff reads it: no escapes, no macro at the start of a line.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool starts = result.empty() || result.back() == '\n';
    if (starts && (c == '.' || c == '\'')) result += "\\&";
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : std::string(1, c);
  }
  return result;
}

std::vector<std::string> paragraphs(const std::string& text) {
  std::vector<std::string> found(1);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      found.emplace_back();
    } else {
      found.back() += line + "\n";
    }
  }
  found.erase(std::remove(found.begin(), found.end(), ""), found.end());
  return found;
}

bool is_listing(const std::string& paragraph) { return paragraph.find("\n  ") != std::string::npos; }

/// A listing keeps its lines, under its first one; other text is filled.
std::string roff_paragraph(const std::string& paragraph) {
  if (!is_listing(paragraph)) return ".PP\n" + roff(paragraph);
  const std::size_t head = paragraph.find('\n') + 1;
  return ".PP\n" + roff(paragraph.substr(0, head)) + ".PP\n.nf\n" + roff(paragraph.substr(head)) + ".fi\n";
}

std::string roff_option(const ListedOption& option) {
  const std::string value = option.value.empty() || option.is_positional() ? "" : fmt::format(" \\fI{}\\fR", roff(option.value));
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(option.name), value, roff(option.sentence));
}

std::string roff_verb(const ListedVerb& verb, std::vector<ListedOption>& shared, std::set<std::string>& seen) {
  std::string usage = "homolog " + verb.name, rows;
  std::set<std::string> groups;
  for (const ListedOption& option : verb.options) {
    if (option.is_positional()) usage += option.required ? " " + option.name : " [" + option.name + "]";
    if (option.is_positional() || option.group == common_group) {
      rows += roff_option(option);
    } else {
      groups.insert(option.group);
      if (seen.insert(option.name).second) shared.push_back(option);
    }
  }
  std::string text = fmt::format(".SS {} [options]\n{}\n{}", roff(usage), roff(verb.sentence), rows);
  for (const std::string& group : groups) text += fmt::format(".PP\nAnd the options under {}.\n", roff(group));
  for (const std::string& paragraph : paragraphs(verb.footer)) text += roff_paragraph(paragraph);
  return text;
}

std::string roff_groups(std::vector<ListedOption> shared) {
  std::string text;
  while (!shared.empty()) {
    const std::string group = shared.front().group;
    std::string title = group;
    std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    text += fmt::format(".SH {}\n", roff(title));
    for (const ListedOption& option : shared) {
      if (option.group == group) text += roff_option(option);
    }
    shared.erase(std::remove_if(shared.begin(), shared.end(), [&](const ListedOption& o) { return o.group == group; }), shared.end());
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& program) {
  std::string text = fmt::format(".TH HOMOLOG 1 \"\" \"homolog {}\" \"User Commands\"\n", HOMOLOG_VERSION);
  text += ".SH NAME\nhomolog \\- finds corresponding parts of 3D shapes\n";
  text += ".SH SYNOPSIS\n\\fBhomolog\\fR \\fIVERB\\fR [options]\n.SH DESCRIPTION\n" + roff(program.get_description()) + "\n";
  for (const std::string& paragraph : paragraphs(program.get_footer())) text += roff_paragraph(paragraph);
  for (const ListedOption& option : listed_options(program)) text += roff_option(option);
  std::vector<ListedOption> shared;
  std::set<std::string> seen;
  text += ".SH VERBS\n";
  for (const ListedVerb& verb : listed_verbs(program)) text += roff_verb(verb, shared, seen);
  return text + roff_groups(std::move(shared));
}

}  // namespace homolog::cli
