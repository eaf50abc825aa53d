#include "tool/manual/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plumb::tool {
namespace {

enum class Follows : std::uint8_t { nothing, files, folders, words, anything };

Follows what_follows(const ShownOption& o) {
  if (!o.choices.empty()) return Follows::words;
  if (o.value == "FILE" || !o.names.front().starts_with('-')) return Follows::files;
  if (o.value == "DIR") return Follows::folders;
  return o.value.empty() ? Follows::nothing : Follows::anything;
}

bool is_positional(const ShownOption& o) { return !o.names.front().starts_with('-'); }

std::string replaced(std::string_view text, std::string_view from, std::string_view by) {
  std::string out;
  for (const char c : text) from.find(c) == std::string_view::npos ? out += c : out.append(by).append(1, c);
  return out;
}

std::string in_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text) c == '\'' ? out += "'\\''" : out += c;
  return out + '\'';
}

/// The script with the program's name where it leaves room for it.
std::string named(std::string script, std::string_view program) {
  constexpr std::string_view room = "@program";
  for (std::size_t at = script.find(room); at != std::string::npos; at = script.find(room, at + program.size()))
    script.replace(at, room.size(), program);
  return script;
}

constexpr std::string_view bash_begin = R"(# Completion of @program for bash; made by `@program completion bash`.
_@program_files() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$1"); }
_@program_folders() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$1"); }
_@program_words() { mapfile -t COMPREPLY < <(compgen -W "$2" -- "$1"); }
_@program() {
  local now=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} word command= k
  COMPREPLY=()
  # --option=value arrives as three words.
  [[ $now == = ]] && now=
  [[ $before == = ]] && before=${COMP_WORDS[COMP_CWORD - 2]}
  for ((k = 1; k < COMP_CWORD; ++k)); do
    word=${COMP_WORDS[k]}
    [[ $word == -* ]] || { command=$word; break; }
  done
  case "$command $before" in
)";

std::string bash_answer(const ShownOption& o) {
  switch (what_follows(o)) {
    case Follows::files:
      return "_@program_files \"$now\"";
    case Follows::folders:
      return "_@program_folders \"$now\"";
    case Follows::words:
      return fmt::format("_@program_words \"$now\" {}", in_quotes(fmt::to_string(fmt::join(o.choices, " "))));
    case Follows::nothing:
    case Follows::anything:
      break;
  }
  return ":";
}

std::vector<std::string> option_names(const CommandShape& c) {
  std::vector<std::string> names;
  for (const ShownOption& o : c.options) {
    if (!is_positional(o)) names.insert(names.end(), o.names.begin(), o.names.end());
  }
  return names;
}

/// "_files", "(a b)": what zsh completes a value by.
std::string zsh_action(const ShownOption& o) {
  switch (what_follows(o)) {
    case Follows::files:
      return "_files";
    case Follows::folders:
      return "_files -/";
    case Follows::words:
      return fmt::format("({})", fmt::join(o.choices, " "));
    case Follows::nothing:
    case Follows::anything:
      break;
  }
  return " ";
}

std::string zsh_specs(const CommandShape& c) {
  std::string specs;
  for (const ShownOption& o : c.options) {
    if (is_positional(o)) {
      specs +=
          " \\\n        " + in_quotes(fmt::format("{}:{}:{}", o.repeats ? "*" : "", o.names.front(), zsh_action(o)));
      continue;
    }
    const std::string about = replaced(o.description, "[]:\\", "\\");
    for (const std::string& name : o.names) {
      const bool value = what_follows(o) != Follows::nothing;
      const std::string equals = !value ? "" : name.starts_with("--") ? "=" : "+";
      const std::string rest =
          value ? fmt::format("{}:{}:{}", o.value_optional ? ":" : "", o.value, zsh_action(o)) : "";
      specs +=
          " \\\n        " + in_quotes(fmt::format("{}{}{}[{}]{}", o.repeats ? "*" : "", name, equals, about, rest));
    }
  }
  return specs;
}

std::string fish_line(const std::string& when, const ShownOption& o) {
  std::string line = fmt::format("complete -c @program -n {}", in_quotes(when));
  if (!is_positional(o)) {
    for (const std::string& name : o.names)
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  switch (what_follows(o)) {
    case Follows::files:
      line += is_positional(o) || o.value_optional ? " -F" : " -r -F";
      break;
    case Follows::folders:
      line += " -x -a '(__fish_complete_directories)'";
      break;
    case Follows::words:
      line += fmt::format("{} -a {}", is_positional(o) ? " -f" : " -x",
                          in_quotes(fmt::to_string(fmt::join(o.choices, " "))));
      break;
    case Follows::anything:
      line += " -x";
      break;
    case Follows::nothing:
      line += " -f";
  }
  return is_positional(o) ? line + "\n" : fmt::format("{} -d {}\n", line, in_quotes(o.description));
}

}  // namespace

std::string bash_completion(std::string_view program, std::span<const CommandShape> commands) {
  std::string by_option, by_command;
  std::vector<std::string> names;
  for (const CommandShape& c : commands) {
    if (!c.name.empty()) names.push_back(c.name);
    for (const ShownOption& o : c.options) {
      if (is_positional(o) || what_follows(o) == Follows::nothing) continue;
      for (const std::string& name : o.names)
        by_option += fmt::format("    '{} {}') {}; return ;;\n", c.name, name, bash_answer(o));
    }
  }
  for (const CommandShape& c : commands) {
    std::string positional = ":";
    for (const ShownOption& o : c.options) {
      if (is_positional(o)) positional = bash_answer(o);
    }
    if (c.name.empty()) positional = fmt::format("_@program_words \"$now\" '{}'", fmt::join(names, " "));
    by_command += fmt::format("    '{}') if [[ $now == -* ]]; then _@program_words \"$now\" '{}'; else {}; fi ;;\n",
                              c.name, fmt::join(option_names(c), " "), positional);
  }
  return named(fmt::format("{}{}  esac\n  case \"$command\" in\n{}  esac\n}}\ncomplete -F _@program @program\n",
                           bash_begin, by_option, by_command),
               program);
}

std::string zsh_completion(std::string_view program, std::span<const CommandShape> commands) {
  std::string known, cases, of_program;
  for (const CommandShape& c : commands) {
    if (c.name.empty()) {
      of_program = zsh_specs(c);
      continue;
    }
    known += fmt::format("    {}\n", in_quotes(fmt::format("{}:{}", c.name, replaced(c.about, ":\\", "\\"))));
    cases += fmt::format("    {})\n      _arguments{}\n      ;;\n", c.name, zsh_specs(c));
  }
  return named(fmt::format(R"(#compdef @program
# Completion of @program for zsh; made by `@program completion zsh`.
_@program() {{
  local curcontext=$curcontext state line
  typeset -A opt_args
  local -a commands
  commands=(
{}  )
  _arguments -C{} \
        '1:command:->command' '*::argument:->argument' && return
  case $state in
  command)
    _describe command commands
    ;;
  argument)
    case $words[1] in
{}    esac
    ;;
  esac
}}
if [ "$funcstack[1]" = _@program ]; then
  _@program "$@"
else
  compdef _@program @program
fi
)",
                           known, of_program, cases),
               program);
}

std::string fish_completion(std::string_view program, std::span<const CommandShape> commands) {
  std::string script =
      "# Completion of @program for fish; made by `@program completion fish`.\ncomplete -c @program -f\n";
  for (const CommandShape& c : commands) {
    const std::string when = c.name.empty() ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + c.name;
    if (!c.name.empty()) {
      script +=
          fmt::format("complete -c @program -n '__fish_use_subcommand' -f -a {} -d {}\n", c.name, in_quotes(c.about));
    }
    for (const ShownOption& o : c.options) script += fish_line(when, o);
  }
  return named(std::move(script), program);
}

}  // namespace plumb::tool
