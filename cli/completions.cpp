// SPDX-License-Identifier: MIT
#include "completions.h"

#include <fmt/format.h>

namespace homolog::cli {
namespace {

bool names_file(const ListedOption& option) { return option.value == "FILE" || option.is_positional(); }

std::string escaped(const std::string& text, const std::string& special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

/// In single quotes, as bash and zsh read them.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

std::string option_names(const std::vector<ListedOption>& options) {
  std::string names;
  for (const ListedOption& option : options) {
    if (!option.is_positional()) names += " " + option.name;
  }
  return names;
}

/// What bash does behind an option: words, folders, files (by its default), or nothing.
std::string bash_values(const std::string& verb, const std::vector<ListedOption>& options) {
  std::string cases;
  for (const ListedOption& option : options) {
    if (option.is_positional() || option.value.empty() || names_file(option)) continue;
    std::string reply = "compopt +o default";
    if (!option.choices.empty()) reply = fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", fmt::join(option.choices, " "));
    if (option.value == "DIR") reply = "COMPREPLY=($(compgen -d -- \"$cur\"))";
    cases += fmt::format("    {}:{}) {}; return ;;\n", verb, option.name, reply);
  }
  return cases;
}

std::string zsh_row(const ListedOption& option) {
  const std::string sentence = escaped(option.sentence, "[]:\\");
  if (option.value.empty()) return quoted(fmt::format("{}[{}]", option.name, sentence));
  std::string action = " ";
  if (!option.choices.empty()) action = fmt::format("({})", fmt::join(option.choices, " "));
  if (option.value == "DIR") action = "_files -/";
  if (names_file(option)) action = "_files";
  if (option.is_positional()) return quoted(fmt::format(":{}:{}", option.name, action));
  return quoted(fmt::format("{}=[{}]:{}:{}", option.name, sentence, option.value, action));
}

std::string fish_row(const std::string& condition, const ListedOption& option) {
  std::string how;
  if (!option.value.empty()) how = names_file(option) ? " -r -F" : " -x";
  if (!option.choices.empty()) how += fmt::format(" -a '{}'", fmt::join(option.choices, " "));
  if (option.value == "DIR") how += " -a '(__fish_complete_directories)'";
  return fmt::format("complete -c homolog -n '{}' -l {}{} -d '{}'\n", condition, option.name.substr(2), how,
                     escaped(option.sentence, "'\\"));
}

}  // namespace

std::string bash_completion(const ListedProgram& program) {
  std::string verbs, values, words;
  for (const ListedVerb& verb : program.verbs) {
    verbs += (verbs.empty() ? "" : "|") + verb.name;
    values += bash_values(verb.name, verb.options);
    words += fmt::format("    {}) words='{}' ;;\n", verb.name, option_names(verb.options));
  }
  std::string names = verbs;
  for (char& c : names) c = c == '|' ? ' ' : c;
  return fmt::format(R"(# bash completion of homolog, made by 'homolog generate bash'
_homolog() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} verb= word words=
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $word in {}) verb=$word; break ;; esac
  done
  COMPREPLY=()
  case $verb:$prev in
{}  esac
  case $verb in
{}    *) words='{}{}' ;;
  esac
  if [[ -z $verb || $cur == -* ]]; then COMPREPLY=($(compgen -W "$words" -- "$cur")); fi
}}
complete -o default -F _homolog homolog
)",
                     verbs, values, words, names, option_names(program.options));
}

std::string zsh_completion(const ListedProgram& program) {
  std::string verbs, cases, options;
  for (const ListedVerb& verb : program.verbs) {
    verbs += fmt::format("    {}\n", quoted(verb.name + ":" + escaped(verb.sentence, ":\\")));
    cases += fmt::format("        {}) _arguments", verb.name);
    for (const ListedOption& option : verb.options) cases += " \\\n          " + zsh_row(option);
    cases += " ;;\n";
  }
  for (const ListedOption& option : program.options) options += zsh_row(option) + " ";
  return fmt::format(R"(#compdef homolog
# zsh completion of homolog, made by 'homolog generate zsh'
_homolog() {{
  local state
  local -a verbs=(
{}  )
  _arguments -C {}'1:verb:->verb' '*::argument:->rest'
  case $state in
    verb) _describe verb verbs ;;
    rest)
      case $words[1] in
{}      esac ;;
  esac
}}
if [[ $funcstack[1] == _homolog ]]; then _homolog "$@"; else compdef _homolog homolog; fi
)",
                     verbs, options, cases);
}

std::string fish_completion(const ListedProgram& program) {
  std::string text = "# fish completion of homolog, made by 'homolog generate fish'\ncomplete -c homolog -n __fish_use_subcommand -f\n";
  for (const ListedOption& option : program.options) text += fish_row("__fish_use_subcommand", option);
  for (const ListedVerb& verb : program.verbs) {
    text += fmt::format("complete -c homolog -n __fish_use_subcommand -a {} -d '{}'\n", verb.name, escaped(verb.sentence, "'\\"));
    for (const ListedOption& option : verb.options) {
      if (!option.is_positional()) text += fish_row("__fish_seen_subcommand_from " + verb.name, option);
    }
  }
  return text;
}

}  // namespace homolog::cli
