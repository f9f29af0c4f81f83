// SPDX-License-Identifier: MIT
#include "homolog/outputs/sink.h"

#include <utility>

namespace homolog {

Writing whole(std::string text) {
  return [text = std::move(text)](const Sink& sink) { sink(text); };
}

std::string text_of(const Writing& writing) {
  std::string text;
  writing([&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace homolog
