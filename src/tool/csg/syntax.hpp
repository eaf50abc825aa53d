// What does the text of a solid say? Calls with arguments and children, as OpenSCAD writes them into .csg files.
//
//   difference() { cube(size = [4, 4, 4], center = true); multmatrix([[1, 0, 0, 2], ...]) { import("bore.stl"); } }
//
// Laws: (1) a number is the double nearest to its decimal.  (2) Calls marked * or % are left out, # means nothing.
// (3) What cannot be read throws Error, which names the text, the line, and what was expected; so does a text whose
// brackets are nested deeper than deepest_nesting.
// Source: OpenSCAD's manual for the language; its export has no variables, functions or loops.
// Cost: linear.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace plumb::tool {

inline constexpr int deepest_nesting = 400;

struct CsgValue {
  std::variant<std::monostate, bool, double, std::string, std::vector<CsgValue>> is;  // none: undef
};

struct CsgCall {
  std::string name;
  std::vector<std::pair<std::string, CsgValue>> arguments;  // their names are empty where none is given
  std::vector<CsgCall> children;
  std::uint64_t line;
};

/// The calls of a text of this name.
std::vector<CsgCall> parse_csg(std::string_view text, const std::string& name);

/// Throws Error: "part.csg:12: " and the text.
[[noreturn]] void fail_at(const std::string& name, std::uint64_t line, const std::string& text);

}  // namespace plumb::tool
