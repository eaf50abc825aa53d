#include "house/overloads.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>

namespace plumb::house {
namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Without comments, texts in quotes and what is the preprocessor's.
std::string bare(const std::string& text) {
  static const std::regex noise(R"(//[^\n]*|/\*[^]*?\*/|"(\\.|[^"\\\n])*"|#([^\n\\]|\\\n|\\.)*)");
  return std::regex_replace(text, noise, " ");
}

std::string trimmed(const std::string& s) {
  const auto from = s.find_first_not_of(" \n"), to = s.find_last_not_of(" \n");
  return from == std::string::npos ? "" : s.substr(from, to - from + 1);
}

/// The type of an argument.
std::string type_of(std::string argument) {
  argument = argument.substr(0, argument.find('='));
  argument = std::regex_replace(argument, std::regex(R"(\bconst\b|\btypename\b|&)"), " ");
  argument = trimmed(std::regex_replace(argument, std::regex(R"(\s+)"), " "));
  argument = std::regex_replace(argument, std::regex(R"(([<(]) )"), "$1");
  return std::regex_replace(argument, std::regex(R"(^(.*[^\s:])\s+\w+$)"), "$1");
}

/// The types between these parentheses.
std::vector<std::string> types_of(const std::string& text, std::size_t open) {
  std::vector<std::string> types(1);
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ')' && depth == 1) break;
    if (c == '(' || c == '<' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == '>' || c == ']' || c == '}') --depth;
    if (i == open) continue;
    if (c == ',' && depth == 1) {
      types.emplace_back();
    } else {
      types.back() += c;
    }
  }
  for (std::string& t : types) t = type_of(t);
  return types;
}

/// Is what stands before a name the end of a type?
bool follows_a_type(const std::string& text, std::size_t name) {
  const std::size_t before = text.find_last_not_of(" \n", name == 0 ? 0 : name - 1);
  return before != std::string::npos && before < name && (is_letter(text[before]) || text[before] == '>');
}

}  // namespace

std::vector<Overload> overloads_in(const std::string& given, const std::string& header,
                                   const std::vector<std::string>& functions) {
  static const std::regex opens_namespace(R"(\bnamespace\s+([\w:]+)\s*$)");
  const std::string text = bare(given);
  std::vector<Overload> all;
  std::vector<std::string> scopes;  // the name of a namespace, or nothing
  std::size_t statement = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '{') {
      std::smatch m;
      const std::string before = text.substr(statement, i - statement);
      scopes.push_back(std::regex_search(before, m, opens_namespace) ? m[1].str() : "");
    }
    if (c == '}' && !scopes.empty()) scopes.pop_back();
    if (c == '{' || c == '}' || c == ';') statement = i + 1;
    if (!is_letter(c) || (i > 0 && is_letter(text[i - 1]))) continue;
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string name = text.substr(i, end - i);
    const bool is_asked = std::ranges::find(functions, name) != functions.end();
    if (!is_asked || end == text.size() || text[end] != '(') continue;
    if (scopes != std::vector<std::string>{"plumb"} || !follows_a_type(text, i)) continue;
    std::vector<std::string> types = types_of(text, end);
    types.resize(std::max<std::size_t>(types.size(), 2));
    all.push_back({name, types[0], types[1], header});
  }
  return all;
}

std::vector<Overload> overloads_of(const std::filesystem::path& tree, const std::vector<std::string>& functions) {
  std::vector<Overload> all;
  const auto root = tree / "include/plumb";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".hpp") continue;
    std::ifstream in(entry.path());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto more = overloads_in(text, entry.path().lexically_relative(root).generic_string(), functions);
    all.insert(all.end(), more.begin(), more.end());
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace plumb::house
