// SPDX-License-Identifier: MIT
// XML element by element, by expat: what stands in memory is what the caller keeps.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace homolog {

/// An element as it begins. Views hold until its event ends; names are without the prefixes of namespaces.
struct XmlElement {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  std::size_t inside;  ///< the byte of the text behind its first tag
  std::size_t line;    ///< in which that tag begins

  /// Empty if there is none.
  std::string_view attribute(std::string_view key) const;
};

struct XmlEvents {
  std::function<bool(const XmlElement&)> begin;                      ///< false: what follows is not read
  std::function<void(std::string_view name, std::size_t)> end = {};  ///< at the byte where its last tag begins
};

/// Throws FileError for what is no XML, with the line, and passes on what the events throw.
void read_xml(std::string_view text, const std::string& file, const XmlEvents& events);

}  // namespace homolog
