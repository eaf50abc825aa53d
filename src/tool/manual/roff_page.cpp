#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "tool/manual/man_page.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view kParagraph = ".PP\n";

/// As text of troff: no character of it is a request or an escape.
std::string escaped(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out = "\\&";
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\'')
      out += "\\(aq";
    else if (c == '`')
      out += "\\(ga";
    else if (c == '^')
      out += "\\(ha";
    else if (c == '~')
      out += "\\(ti";
    else
      out += c;
  }
  return out;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", escaped(text)); }

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

constexpr std::size_t indent = 7;  // of what a term means

/// Neither columns nor lines that stand for themselves: the words may flow.
bool flows(std::string_view line) { return line.substr(indent_of(line)).find("  ") == std::string_view::npos; }

std::string as_it_stands(std::span<const std::string_view> lines) {
  std::string text = fmt::format("{}.nf\n", kParagraph);
  for (const std::string_view line : lines) text += escaped(line) + "\n";
  return text + ".fi\n";
}

/// Lines between blank ones: a paragraph, terms with what they mean, or a table.
std::string block(std::span<const std::string_view> lines) {
  const bool flowing = std::ranges::all_of(lines, flows) && indent_of(lines.front()) == 0 &&
                       std::ranges::all_of(lines, [](std::string_view line) {
                         return indent_of(line) == 0 || indent_of(line) == indent;
                       });
  if (!flowing) return as_it_stands(lines);
  std::string text;
  bool paragraph = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const bool meaning = indent_of(lines[k]) == indent;
    const bool term = !meaning && k + 1 < lines.size() && indent_of(lines[k + 1]) == indent;
    if (term) {
      text += fmt::format(".TP\n{}\n", bold(lines[k]));
    } else {
      if (!meaning && !paragraph) text += kParagraph;
      text += escaped(lines[k].substr(indent_of(lines[k]))) + "\n";
    }
    paragraph = !meaning && !term;
  }
  return text;
}

std::string section(const ManualSection& s) {
  std::string text;
  const std::vector<std::string_view> lines = lines_of(s.text);
  for (std::size_t begin = 0; begin < lines.size();) {
    if (lines[begin].empty()) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < lines.size() && !lines[end].empty()) ++end;
    text += block(std::span(lines).subspan(begin, end - begin));
    begin = end;
  }
  if (text.starts_with(kParagraph)) text.erase(0, kParagraph.size());  // a section begins one by itself
  return fmt::format(".SH {}\n{}", s.title, text);
}

std::string option_entry(const ShownOption& option) {
  std::string names;
  for (const std::string& name : option.names) names.append(names.empty() ? "" : ", ").append(bold(name));
  if (!option.value.empty()) {
    const std::string value = fmt::format("\\fI{}\\fR", escaped(option.value));
    names += option.value_optional ? " [" + value + "]" : " " + value;
  }
  return fmt::format(".TP\n{}\n{}\n", names, escaped(option.description));
}

}  // namespace

std::string roff_page(const Manual& manual, std::span<const ShownOption> options, std::string_view version,
                      std::span<const std::string> see_also) {
  std::string name(manual.name), title;
  std::ranges::replace(name, ' ', '-');
  for (const char c : name) title += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string page =
      fmt::format(".TH {} 1 \"\" \"plumb {}\" \"User Commands\"\n.nh\n.ad l\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
                  title, version, escaped(name), escaped(manual.purpose));
  page += ".nf\n";
  for (const std::string_view s : manual.synopsis) page += escaped(s) + "\n";
  page += ".fi\n";
  for (const ManualSection& s : manual.before_options) page += section(s);
  page += ".SH OPTIONS\n";
  for (const ShownOption& option : options) page += option_entry(option);
  for (const ManualSection& s : manual.after_options) page += section(s);
  page += ".SH SEE ALSO\n";
  for (std::size_t k = 0; k < see_also.size(); ++k)
    page += fmt::format(".BR {} (1){}\n", escaped(see_also[k]), k + 1 < see_also.size() ? "," : "");
  return page;
}

}  // namespace plumb::tool
