// SPDX-License-Identifier: MIT
#include "console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "homolog/base/errors.h"

namespace homolog::cli {
namespace {

constexpr std::string_view kLayout = "\n\t";  // of tables and JSON

/// Names of files may hold commands for the terminal: such characters become question marks, those of `kept` and other UTF-8 stay.
std::string harmless(std::string_view text, std::string_view kept) {
  std::string safe(text);
  for (std::size_t i = 0; i < safe.size(); ++i) {
    const auto c = static_cast<unsigned char>(safe[i]), next = static_cast<unsigned char>(i + 1 < safe.size() ? safe[i + 1] : ' ');
    if ((c < ' ' && kept.find(safe[i]) == kept.npos) || c == 0x7f) safe[i] = '?';
    if (c == 0xc2 && next >= 0x80 && next <= 0x9f) safe.replace(i, 2, "?");  // U+0080 to U+009F
  }
  return safe;
}

// Whoever cannot hear what is said beside the result still gets that.
void say(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

void print_result(std::string_view result) {
  const std::string text = harmless(result, kLayout);
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw OutputError(fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
  }
}

void print_message(std::string_view sentence) { say(fmt::format("homolog: {}\n", harmless(sentence, ""))); }

Console::Console(bool quiet, bool timing) : quiet_(quiet), timing_(timing), progress_(!quiet && isatty(STDERR_FILENO)) {}

Console::~Console() {
  clear();
  if (timing_) say(timing_table(watch_.stages()));
}

void Console::stage(std::string_view text) {
  if (!progress_) return;
  say(fmt::format("\r\033[K{} ...", harmless(text, "")));
  std::fflush(stderr);
  shown_ = true;
}

void Console::warn(std::string_view sentence) {
  if (quiet_) return;
  clear();
  print_message(fmt::format("warning: {}", sentence));
}

void Console::clear() {
  if (shown_) say("\r\033[K");
  shown_ = false;
}

Tell warnings_of(const std::string& path, Console& console) {
  return [name = std::filesystem::path(path).filename().string(), &console](const std::string& sentence) {
    console.warn(fmt::format("{}: {}", name, sentence));
  };
}

}  // namespace homolog::cli
