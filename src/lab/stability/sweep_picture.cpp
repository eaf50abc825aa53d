#include "lab/stability/sweep_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lab/stability/picture_head.hpp"
#include "plumb/query.hpp"

namespace plumb::lab::stability {
namespace {

constexpr double kWidth = 840, kHeight = 560, kLeft = 48, kRight = 792, kTop = 112, kBottom = 536;

/// From the segments' box to the picture, on each axis by itself.
class Frame {
 public:
  explicit Frame(std::span<const Segment2> segments) {
    for (const Segment2& s : segments) {
      for (const Point2& p : {s.a, s.b}) {
        least_ = {std::min(least_.x, p.x), std::min(least_.y, p.y)};
        most_ = {std::max(most_.x, p.x), std::max(most_.y, p.y)};
      }
    }
  }
  [[nodiscard]] double x(const Point2& p) const { return kLeft + share(p.x, least_.x, most_.x) * (kRight - kLeft); }
  [[nodiscard]] double y(const Point2& p) const { return kBottom - share(p.y, least_.y, most_.y) * (kBottom - kTop); }

 private:
  static double share(double x, double least, double most) {
    const double extent = most / 2 - least / 2;  // which the doubles hold
    return extent > 0 ? (x / 2 - least / 2) / extent : 0.5;
  }

  static constexpr double kLargest = std::numeric_limits<double>::max();
  Point2 least_{kLargest, kLargest}, most_{-kLargest, -kLargest};
};

}  // namespace

std::string sweep_picture(const std::string& title, const std::string& subtitle, std::span<const Segment2> segments,
                          const Pairs& lost) {
  const Frame frame(segments);
  std::string svg = picture_head(kWidth, kHeight, title, subtitle);
  svg +=
      "<circle class=\"s1\" cx=\"32\" cy=\"83\" r=\"5\"/>"
      "<text x=\"46\" y=\"88\" font-size=\"13\">two segments meet here, and the sweep did not find it</text>\n";
  for (const Segment2& s : segments) {
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#0072b2\" "
        "stroke-width=\"1.4\"/>\n",
        frame.x(s.a), frame.y(s.a), frame.x(s.b), frame.y(s.b));
  }
  for (const auto& [i, j] : lost) {
    const Point2 at = approximate(intersection(segments[i], segments[j]).vertices[0]);
    svg += fmt::format("<circle class=\"s1\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/>\n", frame.x(at), frame.y(at));
  }
  return svg + "</svg>\n";
}

}  // namespace plumb::lab::stability
