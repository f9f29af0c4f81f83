// SPDX-License-Identifier: MIT
#include "homolog/shape/xml.h"

#include <expat.h>
#include <fmt/format.h>

#include <exception>
#include <memory>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 20;  // bytes

using Parser = std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)>;

struct Reading {
  const XmlEvents& events;
  XML_Parser parser;
  XmlElement element = {};
  bool wants_more = true;
  std::exception_ptr thrown = {};  // expat is C: nothing may be thrown through it

  template <class Event>
  void guard(const Event& event) {
    if (!wants_more || thrown) return;
    try {
      event();
    } catch (...) {
      thrown = std::current_exception();
    }
    if (!wants_more || thrown) XML_StopParser(parser, XML_FALSE);
  }
  std::size_t place() const { return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser)); }
};

std::string_view without_prefix(std::string_view name) { return name.substr(name.find(':') + 1); }

void begin(void* reading, const char* name, const char** attributes) {
  auto& self = *static_cast<Reading*>(reading);
  self.guard([&] {
    self.element.name = without_prefix(name);
    self.element.attributes.clear();
    for (; attributes[0]; attributes += 2) self.element.attributes.emplace_back(without_prefix(attributes[0]), attributes[1]);
    self.element.inside = self.place() + static_cast<std::size_t>(XML_GetCurrentByteCount(self.parser));
    self.element.line = XML_GetCurrentLineNumber(self.parser);
    self.wants_more = self.events.begin(self.element);
  });
}

void end(void* reading, const char* name) {
  auto& self = *static_cast<Reading*>(reading);
  self.guard([&] {
    if (self.events.end) self.events.end(without_prefix(name), self.place());
  });
}

}  // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
  for (const auto& [given, value] : attributes) {
    if (given == key) return value;
  }
  return {};
}

void read_xml(std::string_view text, const std::string& file, const XmlEvents& events) {
  const Parser parser(XML_ParserCreate(nullptr), &XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Reading reading{events, parser.get()};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin, end);
  bool whole = true;
  do {  // piece by piece, for expat keeps a copy of what it is given at once
    const std::string_view piece = text.substr(0, most_at_once);
    text.remove_prefix(piece.size());
    whole = XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), text.empty()) == XML_STATUS_OK;
  } while (whole && !text.empty());
  if (reading.thrown) std::rethrow_exception(reading.thrown);
  if (!whole && reading.wants_more) {
    const std::string reason = XML_ErrorString(XML_GetErrorCode(parser.get()));
    if (reason.find("amplification") != reason.npos) {  // the code of which older versions do not have
      throw FileError(fmt::format("{}, line {}: its entities unfold to far more than the file; export it again without any", file,
                                  XML_GetCurrentLineNumber(parser.get())));
    }
    throw FileError(fmt::format("{}, line {}: it stops being XML here ({}); the file is truncated or damaged, export it again", file,
                                XML_GetCurrentLineNumber(parser.get()), reason));
  }
}

}  // namespace homolog
