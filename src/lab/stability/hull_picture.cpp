#include "lab/stability/hull_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/stability/picture_head.hpp"

namespace plumb::lab::stability {
namespace {

constexpr double kWidth = 840, kHeight = 520, kLeft = 60, kRight = 780, kTop = 116, kBottom = 470;

using Places = std::vector<std::array<double, 2>>;

double x_of(const Places& places, std::uint32_t p) { return kLeft + places[p][0] * (kRight - kLeft); }
double y_of(const Places& places, std::uint32_t p) { return kBottom - places[p][1] * (kBottom - kTop); }

std::string outline(const Places& places, const std::vector<std::uint32_t>& corners) {
  std::string path;
  for (const std::uint32_t c : corners) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x_of(places, c), y_of(places, c));
  }
  return path + "Z";
}

std::string dot(const Places& places, std::uint32_t p, double radius, std::string_view look) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n", x_of(places, p), y_of(places, p), radius,
                     look);
}

}  // namespace

std::string hull_picture(const HullPictureText& text, const HullJudge& judge,
                         const std::vector<std::uint32_t>& claimed) {
  const Places places = judge.stretched();
  std::string svg = picture_head(kWidth, kHeight, text.title, text.subtitle);
  svg +=
      "<rect class=\"s0\" x=\"24\" y=\"76\" width=\"22\" height=\"14\" fill-opacity=\"0.3\"/>"
      "<text x=\"54\" y=\"88\" font-size=\"13\">the hull that was computed</text>\n"
      "<line class=\"frontier\" x1=\"264\" y1=\"83\" x2=\"292\" y2=\"83\"/>"
      "<text x=\"300\" y=\"88\" font-size=\"13\">the true hull</text>\n"
      "<circle class=\"s1\" cx=\"434\" cy=\"83\" r=\"5.5\"/>"
      "<text x=\"448\" y=\"88\" font-size=\"13\">a corner that was lost</text>\n";
  svg += fmt::format(
      "<path class=\"s0\" d=\"{0}\" fill-opacity=\"0.3\" "
      "stroke=\"#0072b2\" stroke-width=\"2\" stroke-opacity=\"0.8\"/>\n",
      outline(places, claimed));
  svg += fmt::format("<path class=\"frontier\" d=\"{}\"/>\n", outline(places, judge.corners()));
  for (std::uint32_t p = 0; p < places.size(); ++p) svg += dot(places, p, 2.5, "class=\"s6\"");
  for (const std::uint32_t p : claimed) svg += dot(places, p, 4, "class=\"s0\"");
  for (const std::uint32_t c : judge.corners()) {
    const bool kept = std::ranges::any_of(claimed, [&](std::uint32_t p) { return places[p] == places[c]; });
    if (!kept) svg += dot(places, c, 5.5, "class=\"s1\"");
  }
  return svg + "</svg>\n";
}

}  // namespace plumb::lab::stability
