#include "tool/section/plane_words.hpp"

#include <fmt/format.h>

#include "plumb/arith/error.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/decimal_range.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view forms_of_planes = "a plane is z=HEIGHT, NX,NY,NZ,OFFSET or three points (nine numbers)";

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string_view::npos) return parts;
    from = to + 1;
  }
}

NamedPlane at_height(char axis, const Decimal& height) {
  const Vector3 normal{axis == 'x' ? 1.0 : 0.0, axis == 'y' ? 1.0 : 0.0, axis == 'z' ? 1.0 : 0.0};
  return {fmt::format("{}={}", axis, height.text), Plane3{normal, height.value}, height.exact};
}

}  // namespace

std::vector<NamedPlane> planes_of(std::string_view words) {
  const std::string what = fmt::format("--plane {}", printable(words));
  if (words.find('=') != std::string_view::npos) {
    if (words.size() < 3 || words[1] != '=' || words[0] < 'x' || words[0] > 'z')
      throw Error(fmt::format("{}: the axis is x, y or z; {}", what, forms_of_planes));
    const auto heights = split(words.substr(2), ':');
    std::vector<NamedPlane> planes;
    if (heights.size() == 1) {
      planes.push_back(at_height(words[0], read_decimal(heights[0], what)));
      return planes;
    }
    if (heights.size() != 3)
      throw Error(fmt::format("{}: a range is start:stop:step, such as {}=0:10:0.2", what, words[0]));
    for (const Decimal& h : decimal_range(heights[0], heights[1], heights[2], what, most_planes))
      planes.push_back(at_height(words[0], h));
    return planes;
  }
  const auto [x, exact] = read_decimals(words, what);
  const std::string name(words);
  if (x.size() == 4) return {{name, Plane3{{x[0], x[1], x[2]}, x[3]}, exact}};
  if (x.size() == 9)
    return {{name, ThreePointPlane3{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}}, exact}};
  throw Error(fmt::format("{}: this has {} numbers; {}", what, x.size(), forms_of_planes));
}

}  // namespace plumb::tool
