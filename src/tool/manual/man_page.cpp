#include "tool/manual/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plumb::tool {
namespace {

constexpr std::size_t kWidth = 80;

std::string indented(std::string_view text, int columns) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    out += line.empty() ? "\n" : fmt::format("{:{}}{}\n", "", columns, line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// Broken at blanks so that no line passes the width.
std::string filled(std::string_view text, std::size_t columns) {
  std::string out, line;
  const auto end_line = [&] {
    out += fmt::format("{:{}}{}\n", "", columns, line);
    line.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (!line.empty() && columns + line.size() + 1 + end > kWidth) end_line();
    line.append(line.empty() ? "" : " ").append(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  end_line();
  return out;
}

std::string option_entry(const ShownOption& option, const Style& style) {
  std::string names;
  for (const std::string& name : option.names) names.append(names.empty() ? "" : ", ").append(style.bold(name));
  names += option.shown_value();
  return indented(names, 7) + filled(option.description, 14);
}

std::string section(const ManualSection& s, const Style& style) {
  std::string_view text = s.text;
  if (text.starts_with('\n')) text.remove_prefix(1);
  return fmt::format("\n{}\n{}", style.bold(s.title), indented(text, 7));
}

}  // namespace

std::string ShownOption::shown_value() const {
  if (value.empty()) return "";
  return value_optional ? fmt::format(" [{}]", value) : " " + value;
}

std::string manual_page(const Manual& manual, std::span<const ShownOption> options, const Style& style) {
  std::string page =
      fmt::format("{}\n{}", style.bold("NAME"), indented(fmt::format("{} - {}", manual.name, manual.purpose), 7));
  page += fmt::format("\n{}\n", style.bold("SYNOPSIS"));
  for (const std::string_view s : manual.synopsis) page += indented(s, 7);
  for (const ManualSection& s : manual.before_options) page += section(s, style);
  page += fmt::format("\n{}\n", style.bold("OPTIONS"));
  for (const ShownOption& option : options) page += option_entry(option, style);
  for (const ManualSection& s : manual.after_options) page += section(s, style);
  return page;
}

}  // namespace plumb::tool
