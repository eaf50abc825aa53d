#include "tool/manual/parsed_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tool/terminal/suggestion.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

/// "METHOD:{float32,double}": the checks follow the colon.
std::vector<std::string> listed_choices(std::string_view type) {
  std::vector<std::string> choices;
  const std::size_t open = type.find(":{");
  if (open == std::string_view::npos) return choices;
  std::string_view list = type.substr(open + 2);
  list = list.substr(0, list.find('}'));
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    choices.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return choices;
}

}  // namespace

std::vector<ShownOption> shown_options(const CLI::App& parser) {
  std::vector<ShownOption> options;
  for (const CLI::Option* const option : parser.get_options()) {
    ShownOption& shown = options.emplace_back();
    shown.description = option->get_description();
    shown.repeats = option->get_expected_max() > 1;
    const std::string type = option->get_type_name();
    shown.choices = listed_choices(type);
    if (option->get_positional()) {
      shown.names.push_back(option->get_name(true));
      continue;
    }
    for (const std::string& name : option->get_snames()) shown.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) shown.names.push_back("--" + name);
    if (option->get_items_expected_max() > 0) shown.value = type.substr(0, type.find(':'));
    shown.value_optional = !shown.value.empty() && option->get_expected_min() == 0;
  }
  return options;
}

CommandShape shape_of(const Command& command) {
  CommandShape shape{command.parser->get_name(), command.parser->get_description(), shown_options(*command.parser)};
  for (ShownOption& o : shape.options) {
    if (!o.names.front().starts_with('-')) o.value = o.names.front();
  }
  for (const auto& [name, choices] : command.choices) {
    const auto at = std::ranges::find_if(shape.options, [&wanted = name](const ShownOption& o) {
      return std::ranges::find(o.names, wanted) != o.names.end();
    });
    if (at != shape.options.end()) {
      at->choices = choices();
    } else {  // of a command that takes its arguments as they come
      shape.options.push_back({{name}, name, "", choices()});
    }
  }
  return shape;
}

std::vector<CommandShape> shapes_of(const CLI::App& program, const std::vector<Command>& commands) {
  std::vector<CommandShape> shapes{{"", "", shown_options(program)}};
  for (const Command& c : commands) shapes.push_back(shape_of(c));
  return shapes;
}

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& c : commands) names.push_back(c.parser->get_name());
  return names;
}

std::string why_not_taken(const CLI::App& parser, const std::vector<std::string>& words,
                          const std::vector<Command>& commands, std::string (*instead)(const std::string& word)) {
  const bool of_program = parser.get_parent() == nullptr;
  const std::string word = words.front().substr(0, words.front().find('='));
  if (word.starts_with('-')) {
    std::vector<std::string> names;
    for (const ShownOption& o : shown_options(parser)) {
      for (const std::string& name : o.names) {
        if (name.starts_with("--")) names.push_back(name);
      }
    }
    return fmt::format("there is no option {}{}", printable(word), suggestion(word, names));
  }
  if (of_program) {
    if (const std::string other = instead(words.front()); !other.empty())
      return fmt::format("there is no command {}: {}", printable(words.front()), other);
    return fmt::format("there is no command {}{}", printable(words.front()), suggestion(word, names_of(commands)));
  }
  return fmt::format("{} takes no argument {}", parser.get_name(), printable(words.front()));
}

}  // namespace plumb::tool
