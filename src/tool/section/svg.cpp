// The contours of sections, drawn: what is inside is filled, as winding numbers say; chains that are open are red.
//
// Lines are as wide as a pixel where the drawing is shown at its own size, in the drawing's unit: few renderers know
// strokes that do not scale.  All is said in attributes, as some know no style sheets either.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "tool/drawing/chart.hpp"
#include "tool/section/command.hpp"

namespace plumb::tool {
namespace {

constexpr double pixels = 900;  // along the larger side

/// The part of the paper that all sections together need.
struct Frame {
  double left = 0, bottom = 0, right = 1, top = 1;

  explicit Frame(const SectionReport& report) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double u0 = infinity, v0 = infinity, u1 = -infinity, v1 = -infinity;
    for (const auto& section : report.drawn) {
      for (const auto& contour : section) {
        for (const Point2& p : contour) {
          u0 = std::min(u0, p.x), u1 = std::max(u1, p.x);
          v0 = std::min(v0, p.y), v1 = std::max(v1, p.y);
        }
      }
    }
    if (u0 > u1) return;
    const double margin = std::max({(u1 - u0) / 50, (v1 - v0) / 50, 1e-300});
    left = u0 - margin, right = u1 + margin, bottom = v0 - margin, top = v1 + margin;
  }
};

std::string layer(const SectionReport& report, std::size_t plane, double opacity) {
  const Section& section = report.sections[plane];
  std::string closed, open;
  for (std::size_t i = 0; i < section.contours.size(); ++i) {
    std::string& path = section.contours[i].closed ? closed : open;
    char command = 'M';
    for (const Point2& p : report.drawn[plane][i]) {
      fmt::format_to(std::back_inserter(path), "{}{},{}", command, p.x, p.y);
      command = command == 'M' ? 'L' : ' ';
    }
    path += section.contours[i].closed ? "Z\n" : "\n";
  }
  const std::string name = escaped(report.planes[plane].name);
  std::string text = fmt::format(
      "<g id=\"section-{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\">\n<title>{}"
      "</title>\n",
      plane + 1, name, name);
  if (!closed.empty()) {
    text += fmt::format(
        "<path class=\"closed\" fill=\"#4477aa\" fill-opacity=\"{}\" fill-rule=\"nonzero\" stroke=\"#224466\" "
        "d=\"{}\"/>\n",
        opacity, closed);
  }
  if (!open.empty()) text += fmt::format("<path class=\"open\" fill=\"none\" stroke=\"#cc3311\" d=\"{}\"/>\n", open);
  return text + "</g>\n";
}

std::string document(const SectionReport& report, std::size_t from, std::size_t to) {
  const Frame f(report);
  const double width = f.right - f.left, height = f.top - f.bottom, pixel = std::max(width, height) / pixels;
  // Upward is up: the layers are mirrored, so that their numbers are those of the plane.
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "viewBox=\"{} {} {} {}\" width=\"{:.0f}\" height=\"{:.0f}\">\n<title>{}</title>\n"
      "<g transform=\"scale(1,-1)\" stroke-width=\"{}\" stroke-linejoin=\"round\">\n",
      f.left, -f.top, width, height, std::max(width / pixel, 1.0), std::max(height / pixel, 1.0),
      escaped(report.mesh_name), pixel);
  for (std::size_t i = from; i < to; ++i) text += layer(report, i, to - from == 1 ? 0.35 : 0.08);
  return text + "</g>\n</svg>\n";
}

}  // namespace

std::string section_svg(const SectionReport& report) { return document(report, 0, report.planes.size()); }
std::string section_svg(const SectionReport& report, std::size_t plane) { return document(report, plane, plane + 1); }

}  // namespace plumb::tool
