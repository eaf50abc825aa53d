#include "tool/inside/point_list.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "plumb/arith/error.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

/// The words of a line with one comma between any two of them.
std::string with_commas(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::string words;
  line = line.substr(0, line.find('#'));
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    const bool beside_comma =
        words.empty() || words.back() == ',' || words.back() == ';' || line[at] == ',' || line[at] == ';';
    if (!beside_comma) words += ',';
    words += line.substr(at, end - at);
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

}  // namespace

NamedPoint read_point(const std::string& words, const std::string& what) {
  const auto [x, exact] = read_decimals(words, what);
  if (x.size() != 3) throw Error(fmt::format("{}: this has {} numbers; a point has three: X,Y,Z", what, x.size()));
  return {words, {x[0], x[1], x[2]}, exact};
}

std::vector<NamedPoint> read_points(std::istream& lines, const std::string& name) {
  std::vector<NamedPoint> points;
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::string words = with_commas(line);
    if (!words.empty()) points.push_back(read_point(words, fmt::format("{}, line {}", name, number)));
  }
  return points;
}

std::vector<NamedPoint> read_points(const std::string& file) {
  const std::string name = printable(name_of_input(file));
  errno = 0;
  std::ifstream opened;
  if (file != "-") opened.open(file);
  std::istream& lines = file == "-" ? std::cin : opened;
  const auto require_good = [&](bool good) {
    if (!good) throw Error(fmt::format("cannot read {}: {}", name, std::strerror(errno)));
  };
  require_good(file == "-" || opened.is_open());
  std::vector<NamedPoint> points = read_points(lines, name);
  require_good(!lines.bad());
  return points;
}

}  // namespace plumb::tool
