// How does a point set look?  A small SVG canvas whose text is the same on every machine.
#pragma once

#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace plumb_test {

struct Dot {
  double x, y;
};

class Picture {
 public:
  Picture(int width, int height) {
    add({"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", std::to_string(width), "\" height=\"",
         std::to_string(height), "\" font-family=\"sans-serif\" font-size=\"11\">\n"});
    rectangle(0, 0, width, height, "#ffffff");
  }

  void rectangle(double x, double y, double width, double height, std::string_view fill) {
    element("rect", {{"x", x}, {"y", y}, {"width", width}, {"height", height}}, "fill", fill);
  }
  void dot(Dot at, double radius = 2.5, std::string_view fill = "#1f5fa8") {
    element("circle", {{"cx", at.x}, {"cy", at.y}, {"r", radius}}, "fill", fill);
  }
  void ring(Dot at, double radius, std::string_view stroke = "#c0c0c0") {
    element("circle", {{"cx", at.x}, {"cy", at.y}, {"r", radius}}, "fill=\"none\" stroke", stroke);
  }
  void line(Dot from, Dot to, std::string_view stroke = "#c0c0c0") {
    element("line", {{"x1", from.x}, {"y1", from.y}, {"x2", to.x}, {"y2", to.y}}, "stroke", stroke);
  }
  void chain(const std::vector<Dot>& dots, std::string_view stroke) {
    add({"<polyline points=\""});
    for (std::size_t i = 0; i < dots.size(); ++i) add({i == 0 ? "" : " ", tenths(dots[i].x), ",", tenths(dots[i].y)});
    add({"\" fill=\"none\" stroke=\"", stroke, "\"/>\n"});
  }
  /// All of one size.
  void scatter(const std::vector<Dot>& dots, double radius) {
    add({"<path stroke-linecap=\"round\" stroke=\"#1f5fa8\" stroke-width=\"", tenths(2 * radius), "\" d=\""});
    for (const Dot& d : dots) add({"M", tenths(d.x), " ", tenths(d.y), "h0"});
    add({"\"/>\n"});
  }
  void words(Dot at, std::string_view what, std::string_view anchor = "start") {
    add({"<text x=\"", tenths(at.x), "\" y=\"", tenths(at.y), "\" text-anchor=\"", anchor, "\">", what, "</text>\n"});
  }

  [[nodiscard]] std::string text() const { return text_ + "</svg>\n"; }

 private:
  struct Attribute {
    std::string_view name;
    double value;
  };
  static std::string tenths(double x) {
    const long rounded = std::lround(10 * x);
    const long whole = std::labs(rounded) / 10, tenth = std::labs(rounded) % 10;
    std::string text = std::to_string(whole);
    if (tenth != 0) text.append(".").append(std::to_string(tenth));
    if (rounded < 0) text.insert(text.begin(), '-');
    return text;
  }
  void add(std::initializer_list<std::string_view> pieces) {
    for (const std::string_view piece : pieces) text_ += piece;
  }
  void element(std::string_view name, const std::vector<Attribute>& attributes, std::string_view paint,
               std::string_view color) {
    add({"<", name});
    for (const Attribute& a : attributes) add({" ", a.name, "=\"", tenths(a.value), "\""});
    add({" ", paint, "=\"", color, "\"/>\n"});
  }

  std::string text_;
};

// A square of a picture onto which a square of the plane is mapped, y upwards.
struct Panel {
  double left, top, size;
  double x_min, y_min, extent;

  static Panel around(const std::vector<Dot>& dots, double left, double top, double size) {
    double x_min = INFINITY, x_max = -INFINITY, y_min = INFINITY, y_max = -INFINITY;
    for (const Dot& d : dots) {
      x_min = std::fmin(x_min, d.x), x_max = std::fmax(x_max, d.x);
      y_min = std::fmin(y_min, d.y), y_max = std::fmax(y_max, d.y);
    }
    const double spread = std::fmax(x_max - x_min, y_max - y_min), extent = spread > 0 ? 1.1 * spread : 1;
    return {left, top, size, (x_min + x_max - extent) / 2, (y_min + y_max - extent) / 2, extent};
  }
  [[nodiscard]] Dot at(Dot d) const {
    return {left + size * ((d.x - x_min) / extent), top + size * (1 - (d.y - y_min) / extent)};
  }
  [[nodiscard]] double length(double r) const { return size * (r / extent); }
};

}  // namespace plumb_test
