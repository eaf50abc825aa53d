#include "lab/stability/picture_head.hpp"

#include <fmt/format.h>

#include "tool/drawing/chart.hpp"

namespace plumb::lab::stability {

std::string picture_head(double width, double height, const std::string& title, const std::string& subtitle) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\">\n"
      "<title>{2}</title>\n<desc>{3}</desc>\n",
      width, height, escaped(title), escaped(subtitle));
  svg.append(chart_style);
  return svg + fmt::format(
                   "<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n"
                   "<text x=\"24\" y=\"36\" font-size=\"19\" font-weight=\"600\">{}</text>\n"
                   "<text class=\"muted\" x=\"24\" y=\"58\" font-size=\"13\">{}</text>\n",
                   width, height, escaped(title), escaped(subtitle));
}

}  // namespace plumb::lab::stability
