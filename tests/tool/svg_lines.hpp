// How wide are the lines of an SVG picture, and how large is it?
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

struct SvgLines {
  double larger_side = 0;      // in the picture's unit
  bool in_pixels = false;      // its unit is a pixel of the size that it asks for
  std::vector<double> widths;  // that are stated
};

/// The numbers of an attribute of the first element; none where it has no such attribute.
inline std::vector<double> svg_numbers(std::string_view svg, const std::string& attribute) {
  const std::string_view head = svg.substr(0, svg.find('>'));
  const std::size_t at = head.find(" " + attribute + "=\"");
  if (at == head.npos) return {};
  std::istringstream in{std::string(head.substr(at + attribute.size() + 3))};
  std::vector<double> numbers;
  for (double x = 0; in >> x;) numbers.push_back(x);
  return numbers;
}

inline SvgLines svg_lines(std::string_view svg) {
  const auto width = svg_numbers(svg, "width"), height = svg_numbers(svg, "height"), box = svg_numbers(svg, "viewBox");
  SvgLines lines;
  if (box.size() == 4) {
    lines.larger_side = std::max(box[2], box[3]);
    lines.in_pixels = width == std::vector{box[2]} && height == std::vector{box[3]};
  } else if (width.size() == 1 && height.size() == 1) {
    lines.larger_side = std::max(width[0], height[0]);
    lines.in_pixels = true;
  }
  constexpr std::string_view name = "stroke-width";
  for (std::size_t at = 0; (at = svg.find(name, at)) != svg.npos; at += name.size()) {
    const std::size_t number = svg.find_first_not_of(":=\" ", at + name.size());
    std::istringstream in{std::string(svg.substr(number, 40))};
    if (double w = 0; in >> w) lines.widths.push_back(w);
  }
  return lines;
}

}  // namespace plumb::tool
