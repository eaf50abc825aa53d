#include "lab/stability/space_hull_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/stability/picture_head.hpp"

namespace plumb::lab::stability {
namespace {

using Index = std::uint32_t;

constexpr double kWidth = 840, kHeight = 560, kLeft = 40, kRight = 800, kTop = 116, kBottom = 532;

struct Place {
  double x, y;
};

/// Where the points are: the box of the extreme ones is a cube, seen from in front, above and the right; what is seen
/// of them fills the picture.
std::vector<Place> places_of(const SpaceHullJudge& judge) {
  const auto halves = [](const Point3& p) { return std::array{p.x / 2, p.y / 2, p.z / 2}; };  // so that none overflows
  std::array<double, 3> low = halves(judge.points()[judge.extreme().front()]), high = low;
  for (const Index p : judge.extreme()) {
    const std::array at = halves(judge.points()[p]);
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
  }
  std::vector<Place> places;
  for (const Point3& p : judge.points()) {
    std::array<double, 3> u = halves(p);
    for (std::size_t k = 0; k < 3; ++k) u[k] = high[k] > low[k] ? (u[k] - low[k]) / (high[k] - low[k]) : 0;
    places.push_back({0.91 * u[0] + 0.42 * u[1], -0.9 * u[2] - 0.44 * (0.91 * u[1] - 0.42 * u[0])});
  }
  const auto [left, right] = std::ranges::minmax(places, {}, &Place::x);
  const auto [top, bottom] = std::ranges::minmax(places, {}, &Place::y);
  const double scale = std::min((kRight - kLeft) / (right.x - left.x), (kBottom - kTop) / (bottom.y - top.y));
  for (Place& p : places) {
    p = {(kLeft + kRight) / 2 + scale * (p.x - (left.x + right.x) / 2),
         (kTop + kBottom) / 2 + scale * (p.y - (top.y + bottom.y) / 2)};
  }
  return places;
}

std::string circle(const Place& at, double radius, std::string_view look) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" class=\"{}\"/>\n", at.x, at.y, radius, look);
}

std::string outline(const std::vector<Place>& places, const std::vector<Index>& face) {
  std::string path;
  for (const Index c : face) path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', places[c].x, places[c].y);
  return path + "Z";
}

/// Twice the area in the picture, whose second axis points down: negative for faces that are seen from outside.
double area(const std::vector<Place>& places, const std::vector<Index>& face) {
  double sum = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Place &a = places[face[i]], &b = places[face[(i + 1) % face.size()]];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace

std::string space_hull_picture(const std::string& title, const std::string& subtitle, const SpaceHullJudge& judge,
                               const Faces& faces) {
  const SpaceHullFlaws flaws = judge.flaws(faces);
  const std::vector<Place> places = places_of(judge);
  std::string svg = picture_head(kWidth, kHeight, title, subtitle);
  svg +=
      "<rect class=\"s0\" x=\"24\" y=\"76\" width=\"22\" height=\"14\" fill-opacity=\"0.3\"/>"
      "<text x=\"54\" y=\"88\" font-size=\"13\">the computed hull</text>\n"
      "<rect class=\"s4\" x=\"196\" y=\"76\" width=\"22\" height=\"14\" fill-opacity=\"0.6\"/>"
      "<text x=\"226\" y=\"88\" font-size=\"13\">a face with points outside</text>\n"
      "<line x1=\"424\" y1=\"83\" x2=\"452\" y2=\"83\" stroke=\"#d55e00\" stroke-width=\"3.5\"/>"
      "<text x=\"460\" y=\"88\" font-size=\"13\">an edge not of two faces</text>\n"
      "<circle class=\"s1\" cx=\"648\" cy=\"83\" r=\"5.5\"/>"
      "<text x=\"660\" y=\"88\" font-size=\"13\">an extreme point, lost</text>\n";
  for (const bool front : {false, true}) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if ((area(places, faces[f]) < 0) != front) continue;
      const bool seen = std::ranges::binary_search(flaws.seen, f);
      svg += fmt::format(
          "<path class=\"{}\" d=\"{}\" fill-opacity=\"{}\" stroke=\"#0072b2\" stroke-width=\"1.2\" "
          "stroke-opacity=\"{}\"/>\n",
          seen ? "s4" : "s0", outline(places, faces[f]),
          seen    ? 0.6
          : front ? 0.2
                  : 0.06,
          front ? 0.8 : 0.25);
    }
  }
  for (const Place& p : places) svg += circle(p, 2, "s6");
  for (const auto& [a, b] : flaws.torn) {
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#d55e00\" stroke-width=\"3.5\" "
        "stroke-linecap=\"round\"/>\n",
        places[a].x, places[a].y, places[b].x, places[b].y);
  }
  for (const Index p : flaws.lost) svg += circle(places[p], 5.5, "s1");
  return svg + "</svg>\n";
}

}  // namespace plumb::lab::stability
