// SPDX-License-Identifier: MIT
// The program `homolog`: reads the command line, runs one verb, and turns every error into one sentence and an exit code.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "console.h"
#include "exit_codes.h"
#include "homolog/base/errors.h"
#include "memory_limit.h"
#include "suggestion.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

constexpr const char* kExamples = R"(Examples:
  # Find one bear in the other and look at bears/report.html
  homolog match bear.off bear_bis.off --out bears
  # Carry landmarks from the first to the second by that match
  homolog transfer bears/match.json --points landmarks.csv --out carried.csv
  # The place of every vertex of each on the other, and both in matching colours
  homolog dense bears/match.json --out bears/dense
  # An animated glTF in which the first turns into the second
  homolog morph bears/match.json --out morph.glb
  # Its symmetries; its salient points; all parameters
  homolog symmetry bear.off
  homolog points bear.off
  homolog params

Exit codes: 0 found, 1 nothing found, 2 wrong usage or parameter, 3 unreadable or unusable shape, 4 result cannot be written.
'homolog VERB --help' tells more.)";

/// The first word that nobody understood, with what may have been meant.
[[noreturn]] void reject_word(const CLI::App& app, const std::vector<std::string>& extras) {
  const bool is_verb = app.get_parent() == nullptr;
  std::vector<std::string> words;
  for (const CLI::App* verb : app.get_subcommands({})) words.push_back(verb->get_name());
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  auto extra = std::find_if(extras.begin(), extras.end(), [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
  if (extra == extras.end()) extra = extras.begin();
  const std::string word = extra->substr(0, extra->find('='));
  const char* kind = word[0] == '-' ? "unknown option" : is_verb ? "unknown verb" : "one file too many:";
  const std::string hint = suggestion(word, words);
  const std::string help = fmt::format("; 'homolog {}--help' lists all", is_verb ? "" : app.get_name() + " ");
  throw UsageError(fmt::format("{} '{}'{}", kind, word, hint.empty() ? help : hint));
}

/// An option that took the name of the next one for its value.
void reject_swallowed(const CLI::App& verb) {
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.starts_with("--") && verb.get_option_no_throw(value) != nullptr)
        throw UsageError(fmt::format("{} needs a value, but {} follows", option->get_name(), value));
    }
  }
}

void reject_extras(const CLI::App& program) {
  for (const CLI::App* verb : program.get_subcommands()) reject_swallowed(*verb);
  const auto reject_those_of = [](const CLI::App& app) {
    std::vector<std::string> extras = app.remaining();
    const bool only_files = std::erase(extras, "--") > 0;
    if (only_files && !extras.empty()) throw UsageError(fmt::format("behind '--' stand files; put '{}' before it", extras.front()));
    if (!extras.empty()) reject_word(app, extras);
  };
  reject_those_of(program);
  for (const CLI::App* verb : program.get_subcommands()) reject_those_of(*verb);
}

/// The text that --help or --version asked for.
int answer(const CLI::App& program, const CLI::Success& asked) {
  const bool version = dynamic_cast<const CLI::CallForVersion*>(&asked) != nullptr;
  print_result(version ? std::string(asked.what()) + "\n" : program.help());
  return kFound;
}

/// A flag said twice says no more than once; of two values one would be lost.
void allow_repeated_flags(CLI::App& verb) {
  for (CLI::Option* option : verb.get_options()) {
    if (option->get_items_expected_max() == 0) option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }
}

void reject_repeated(const CLI::App& verb) {
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_multi_option_policy() != CLI::MultiOptionPolicy::Throw || option->count() < 2) continue;
    throw UsageError(fmt::format("{} is given {} times, but takes one value; give it once", option->get_name(), option->count()));
  }
}

/// What CLI11 objects to, as one sentence. A mistyped option is the likelier cause of whatever else is missing, so it goes first.
[[noreturn]] void reject(const CLI::App& program, const CLI::ParseError& error) {
  reject_extras(program);
  const auto verbs = program.get_subcommands();
  for (const CLI::App* verb : verbs) reject_repeated(*verb);
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) throw UsageError(fmt::format("{} needs a value", text.substr(0, text.find(':'))));
  throw UsageError(fmt::format("{}; 'homolog {}--help' tells more", text, verbs.empty() ? "" : verbs.front()->get_name() + " "));
}

int run(int argc, char** argv) {
  CLI::App program("Finds corresponding parts of 3D shapes.", "homolog");
  program.set_version_flag("--version", "homolog " HOMOLOG_VERSION, "Print the version.");
  program.footer(kExamples);
  program.get_formatter()->column_width(32);
  program.allow_extras();  // so that we can say which word is wrong, and what may have been meant
  const Verb verbs[] = {add_match(program), add_symmetry(program), add_points(program), add_transfer(program),
                        add_dense(program), add_morph(program),    add_params(program), add_generate(program)};
  for (const Verb& verb : verbs) {
    verb.app->allow_extras();
    allow_repeated_flags(*verb.app);
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return answer(program, asked);
  } catch (const CLI::ParseError& error) {
    reject(program, error);
  }
  reject_extras(program);
  for (const Verb& verb : verbs) {
    if (verb.app->parsed()) return verb.run();
  }
  throw UsageError("say what to do: match, symmetry, points, transfer, dense, morph or params; 'homolog --help' tells more");
}

// Memory ends for all threads at once: the first one tells it, the others wait for the end of the process.
void claim_the_end() {
  static std::atomic_flag claimed;
  thread_local bool is_ours = false;
  while (!is_ours && claimed.test_and_set()) pause();
  is_ours = true;
}

int report(int code, const std::string& sentence) {
  claim_the_end();
  print_message(sentence);
  return code;
}

constexpr const char* kNoMemory = "not enough memory for this; a lower --resolution needs less, and --max-memory may allow more";

// Where memory ends while something is destroyed, as JSON is by a list of what is left, nothing can be caught any more.
[[noreturn]] void end_abruptly() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    claim_the_end();
    std::fprintf(stderr, "homolog: %s\n", kNoMemory);  // which takes no memory
    std::_Exit(kUnusableShape);
  } catch (...) {
  }
  std::abort();
}

}  // namespace
}  // namespace homolog::cli

int main(int argc, char** argv) {
  using namespace homolog;
  using namespace homolog::cli;
  std::set_terminate(end_abruptly);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of writing, told as such
  limit_memory_to_free();
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return report(kWrongUsage, error.what());
  } catch (const ParamError& error) {
    return report(kWrongUsage, error.what());
  } catch (const OutputError& error) {
    return report(kNotWritten, error.what());
  } catch (const Error& error) {
    return report(kUnusableShape, error.what());
  } catch (const std::bad_alloc&) {
    return report(kUnusableShape, kNoMemory);
  } catch (const std::exception& error) {
    return report(
        kUnusableShape,
        fmt::format("something failed inside, which is a mistake of the program; please report it with the command and its files: {}",
                    error.what()));
  }
}
