#include "tool/drawing/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include "plumb/arith/error.hpp"
#include "tool/drawing/log_axis.hpp"
#include "tool/terminal/utf8.hpp"

namespace plumb::tool {
namespace {

constexpr double kWidth = 840, kHeight = 520, kLeft = 84, kRight = 28, kTop = 104, kBottom = 66;
constexpr double kBand = 60, kBreak = 8;                    // height of the band of zeros and of the gap above it
constexpr double kCrowd = 6, kRow = 9, kTallestBand = 150;  // more zeros than these make the band taller
constexpr double kMarker = 6.5, kLabelHeight = 17;
constexpr std::size_t kShapes = 7;

/// An upper estimate of a 13 pixel sans-serif text's width: the widest of the usual fonts, so that no font overlaps.
double text_width(std::string_view text) {
  double em = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) continue;  // the rest of a UTF-8 sequence
    if (byte >= 0x80U || std::string_view("mwMW@%").find(c) != std::string_view::npos)
      em += 1;
    else if (std::string_view("iljtfrI.,:;'|!()[] ").find(c) != std::string_view::npos)
      em += 0.42;
    else
      em += byte >= 'A' && byte <= 'Z' ? 0.74 : 0.64;
  }
  return 13 * em + 6;
}

/// The label, cut at a character's end where it is too wide for the chart.
std::string shown_label(const std::string& label) {
  std::string shown = label;
  while (text_width(shown) > (kWidth - kLeft - kRight) / 2) {
    std::size_t end = shown.size() - (shown.size() > label.size() || shown.ends_with("…") ? 3 : 0);
    do --end;
    while (end > 0 && (static_cast<unsigned char>(shown[end]) & 0xC0U) == 0x80U);
    shown = shown.substr(0, end) + "…";
  }
  return shown;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : in_utf8(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;  // XML 1.0 has no control characters
    }
  }
  return out;
}

namespace {

struct Scales {
  Box plot;
  bool has_zeros;
  double break_at;  // top of the band of zeros
  LogAxis x, y;

  [[nodiscard]] double y_at(double value) const { return value == 0 ? (break_at + plot.bottom) / 2 : y.at(value); }
};

Scales make_scales(std::span<const ChartPoint> points, double height) {
  double x_low = 1, x_high = 1000, y_low = 1e-6, y_high = 1;
  bool any_x = false, any_y = false;
  double zeros = 0;
  for (const ChartPoint& p : points) {
    if (!(p.x > 0) || !std::isfinite(p.x) || !(p.y >= 0) || !std::isfinite(p.y) || !(p.most >= 0) ||
        !std::isfinite(p.most)) {
      throw Error(fmt::format("chart: the point \"{}\" ({}, {}) has no place on logarithmic axes", p.label, p.x, p.y));
    }
    x_low = any_x ? std::min(x_low, p.x) : p.x;
    x_high = any_x ? std::max(x_high, p.x) : p.x;
    any_x = true;
    zeros += p.y == 0 ? 1 : 0;
    for (const double y : {p.y, p.most}) {
      if (y == 0) continue;
      y_low = any_y ? std::min(y_low, y) : y;
      y_high = any_y ? std::max(y_high, y) : y;
      any_y = true;
    }
  }
  const Box plot{kLeft, kTop, kWidth - kRight, height - kBottom};
  const bool has_zeros = zeros > 0;
  const double band = std::clamp(kBand + kRow * (zeros - kCrowd), kBand, kTallestBand);
  const double break_at = has_zeros ? plot.bottom - band : plot.bottom;
  const double low_end = has_zeros ? break_at - kBreak : plot.bottom;
  return {plot, has_zeros, break_at, LogAxis(x_low, x_high, LogAxis::Ends::padded, plot.left, plot.right),
          LogAxis(y_low, y_high, LogAxis::Ends::whole_decades, low_end - 10, plot.top + 10)};
}

ChartLayout lay_out(std::span<const ChartPoint> points, const Scales& scales, double height, bool& fits) {
  ChartLayout layout{kWidth, height, scales.plot, scales.break_at, {}, {}};
  std::vector<LabelRequest> requests;
  for (const ChartPoint& p : points) {
    const double x = scales.x.at(p.x), y = scales.y_at(p.y);
    layout.markers.push_back({x - kMarker, y - kMarker, x + kMarker, y + kMarker});
    Box home = scales.plot;
    (p.y == 0 ? home.top : home.bottom) = scales.break_at;
    requests.push_back({x, y, text_width(shown_label(p.label)), kLabelHeight, home});
  }
  auto labels = place_labels(requests, scales.plot, kMarker);
  fits = labels.has_value();
  if (fits) layout.labels = std::move(*labels);
  return layout;
}

/// Height by height until every label has room.
double fitting_height(std::span<const ChartPoint> points, ChartLayout& layout) {
  for (double height = kHeight;; height *= 1.25) {
    bool fits = false;
    layout = lay_out(points, make_scales(points, height), height, fits);
    if (fits) return height;
  }
}

}  // namespace

const std::string_view chart_style = R"(<style>
  text { font-family: system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif; fill: #1f2328; }
  .paper { fill: #ffffff; } .band { fill: #eef3f7; } .muted { fill: #59636e; }
  .grid { stroke: #dde2e7; stroke-width: 1; } .fine { stroke: #f0f2f4; stroke-width: 1; }
  .axis { stroke: #8b949e; stroke-width: 1; fill: none; } .leader { stroke: #8b949e; stroke-width: 1; }
  .whisker { stroke: #8b949e; stroke-width: 1.2; fill: none; }
  .label { font-size: 13px; paint-order: stroke; stroke: #ffffff; stroke-width: 3px; stroke-linejoin: round; }
  .marker { stroke: #ffffff; stroke-width: 1.2; } .partial { fill-opacity: 0.45; }
  .frontier { stroke: #8b949e; stroke-width: 1.5; stroke-dasharray: 5 4; fill: none; }
  .s0 { fill: #0072b2; } .s1 { fill: #d55e00; } .s2 { fill: #009e73; } .s3 { fill: #cc79a7; }
  .s4 { fill: #e69f00; } .s5 { fill: #56b4e9; } .s6 { fill: #4d4d4d; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3; } .paper { fill: #0d1117; } .band { fill: #161d27; } .muted { fill: #9ba4ae; }
    .grid { stroke: #29303a; } .fine { stroke: #171c24; } .axis, .leader, .whisker { stroke: #717982; }
    .label { stroke: #0d1117; } .marker { stroke: #0d1117; } .frontier { stroke: #717982; }
    .s0 { fill: #4aa8e0; } .s1 { fill: #ff8340; } .s2 { fill: #2bc79a; } .s3 { fill: #e39ac4; }
    .s4 { fill: #f2b632; } .s5 { fill: #8fd0f7; } .s6 { fill: #c4cad1; }
  }
</style>
)";

namespace {

std::string marker_shape(std::size_t shape, double x, double y) {
  const auto polygon = [&](std::initializer_list<std::array<double, 2>> corners) {
    std::string path;
    for (const auto& c : corners) path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x + c[0], y + c[1]);
    return fmt::format("<path d=\"{}Z\"", path);
  };
  switch (shape) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"", x, y);
    case 1:
      return polygon({{-5.4, -5.4}, {5.4, -5.4}, {5.4, 5.4}, {-5.4, 5.4}});
    case 2:
      return polygon({{0, -6.5}, {6.3, 5}, {-6.3, 5}});
    case 3:
      return polygon({{0, -6.5}, {6.5, 0}, {0, 6.5}, {-6.5, 0}});
    case 4:
      return polygon({{0, 6.5}, {6.3, -5}, {-6.3, -5}});
    case 5:
      return polygon({{-2.2, -6.3},
                      {2.2, -6.3},
                      {2.2, -2.2},
                      {6.3, -2.2},
                      {6.3, 2.2},
                      {2.2, 2.2},
                      {2.2, 6.3},
                      {-2.2, 6.3},
                      {-2.2, 2.2},
                      {-6.3, 2.2},
                      {-6.3, -2.2},
                      {-2.2, -2.2}});
    default:
      return polygon({{-3.2, -5.8}, {3.2, -5.8}, {6.4, 0}, {3.2, 5.8}, {-3.2, 5.8}, {-6.4, 0}});
  }
}

class Drawing {
 public:
  Drawing(const ChartText& text, std::span<const ChartPoint> points) : text_(text), points_(points) {}

  std::string draw() {
    const double height = fitting_height(points_, layout_);
    const Scales scales = make_scales(points_, height);
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n",
        kWidth, height);
    put("<title>{}</title>\n<desc>{}; {} against {}</desc>\n", escaped(text_.title), escaped(text_.subtitle),
        escaped(text_.y_axis), escaped(text_.x_axis));
    out_ += chart_style;
    put("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", kWidth, height);
    draw_axes(scales);
    draw_text(height);
    if (text_.frontier) draw_frontier();
    for (std::size_t i = 0; i < points_.size(); ++i) draw_whisker(i, scales);
    for (std::size_t i = 0; i < points_.size(); ++i) draw_leader(i);
    for (std::size_t i = 0; i < points_.size(); ++i) draw_point(i);
    for (std::size_t i = 0; i < points_.size(); ++i) draw_label(i);
    return out_ + "</svg>\n";
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(values)...);
  }

  void line(std::string_view kind, double x1, double y1, double x2, double y2) {
    put("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", kind, x1, y1, x2, y2);
  }

  void draw_axes(const Scales& s) {
    const Box& plot = s.plot;
    const double log_bottom = s.has_zeros ? s.break_at - kBreak : plot.bottom;
    if (s.has_zeros) {
      put("<rect class=\"band\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", plot.left,
          s.break_at, plot.right - plot.left, plot.bottom - s.break_at);
    }
    const std::vector<Tick> xs = s.x.ticks(), ys = s.y.ticks();
    for (const bool labeled : {false, true}) {  // the fine grid lies below the other
      for (const Tick& t : xs) {
        if (t.labeled != labeled) continue;
        line(labeled ? "grid" : "fine", t.at, plot.top, t.at, log_bottom);
        if (s.has_zeros) line(labeled ? "grid" : "fine", t.at, s.break_at, t.at, plot.bottom);
      }
      for (const Tick& t : ys) {
        if (t.labeled == labeled) line(labeled ? "grid" : "fine", plot.left, t.at, plot.right, t.at);
      }
    }
    for (const Tick& t : xs) {
      if (t.labeled) tick_label(t.at, plot.bottom + 20, "middle", tick_text(t, xs));
    }
    for (const Tick& t : ys) {
      if (t.labeled) tick_label(plot.left - 10, t.at + 4.5, "end", tick_text(t, ys));
    }
    line("axis", plot.left, plot.bottom, plot.right, plot.bottom);
    line("axis", plot.left, plot.top, plot.left, log_bottom);
    if (!s.has_zeros) return;
    tick_label(plot.left - 10, s.y_at(0) + 4.5, "end", "0");
    line("axis", plot.left, s.break_at, plot.left, plot.bottom);
    for (const double y : {log_bottom, s.break_at}) line("axis", plot.left - 5, y + 3, plot.left + 5, y - 3);
  }

  void tick_label(double x, double y, std::string_view anchor, const std::string& svg_text) {
    put("<text class=\"muted\" font-size=\"12\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
        svg_text);
  }

  void draw_text(double height) {
    put("<text x=\"24\" y=\"36\" font-size=\"19\" font-weight=\"600\">{}</text>\n", escaped(text_.title));
    put("<text class=\"muted\" x=\"24\" y=\"58\" font-size=\"13\">{}</text>\n", escaped(text_.subtitle));
    put("<text x=\"24\" y=\"{:.0f}\" font-size=\"12.5\">{}</text>\n", kTop - 14, escaped(text_.y_axis));
    put("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"12.5\" text-anchor=\"end\">{}</text>\n", kWidth - kRight,
        height - kBottom + 46, escaped(text_.x_axis));
  }

  /// Steps: what can be had in so much time.
  void draw_frontier() {
    std::string path;
    for (const std::size_t i : frontier_of(points_)) {
      const auto [x, y] = center(i);
      path += path.empty() ? fmt::format("M{:.1f} {:.1f}", x, y) : fmt::format("H{:.1f}V{:.1f}", x, y);
    }
    if (!path.empty()) put("<path class=\"frontier\" d=\"{}\"/>\n", path);
  }

  [[nodiscard]] std::array<double, 2> center(std::size_t i) const {
    const Box& m = layout_.markers[i];
    return {(m.left + m.right) / 2, (m.top + m.bottom) / 2};
  }

  [[nodiscard]] std::string key_of(std::size_t i) const {
    return points_[i].key.empty() ? "" : fmt::format(" data-key=\"{}\"", escaped(points_[i].key));
  }

  [[nodiscard]] std::string place_of(std::size_t i) const {
    const auto [x, y] = center(i);
    return points_[i].key.empty() ? "" : fmt::format("{} data-at=\"{:.1f} {:.1f}\"", key_of(i), x, y);
  }

  void draw_whisker(std::size_t i, const Scales& scales) {
    if (!(points_[i].most > points_[i].y)) return;
    const auto [x, y] = center(i);
    const double top = scales.y_at(points_[i].most);
    put("<path class=\"whisker\"{} d=\"M{:.1f} {:.1f}V{:.1f}M{:.1f} {:.1f}H{:.1f}\"/>\n", key_of(i), x, y, top, x - 4,
        top, x + 4);
  }

  void draw_leader(std::size_t i) {
    const LabelPlace& p = layout_.labels[i];
    if (!p.leader) return;
    put("<line class=\"leader\"{} x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", key_of(i), p.from_x,
        p.from_y, p.to_x, p.to_y);
  }

  /// No two of the first 49 points have both color and shape in common.
  void draw_point(std::size_t i) {
    const ChartPoint& p = points_[i];
    const auto [x, y] = center(i);
    const std::string hint = p.hint.empty() ? fmt::format("{}: {:.4g}, {:.4g}", p.label, p.x, p.y) : p.hint;
    put("{} class=\"marker s{}{}\"{}><title>{}</title></{}>\n", marker_shape(i % kShapes, x, y),
        (i + i / kShapes) % kShapes, p.complete ? "" : " partial", place_of(i), escaped(hint),
        i % kShapes == 0 ? "circle" : "path");
  }

  void draw_label(std::size_t i) {
    const Box& b = layout_.labels[i].box;
    put("<text class=\"label\"{} x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", key_of(i),
        (b.left + b.right) / 2, b.bottom - 4.5, escaped(shown_label(points_[i].label)));
  }

  const ChartText& text_;
  std::span<const ChartPoint> points_;
  ChartLayout layout_{};
  std::string out_;
};

}  // namespace

std::vector<std::size_t> frontier_of(std::span<const ChartPoint> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].complete) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) {
    return std::pair(points[i].x, points[i].y) < std::pair(points[j].x, points[j].y);
  });
  double least = std::numeric_limits<double>::infinity();
  std::erase_if(order,
                [&](std::size_t i) { return !(points[i].y < std::exchange(least, std::min(least, points[i].y))); });
  return order;
}

ChartLayout lay_out_chart(std::span<const ChartPoint> points) {
  ChartLayout layout{};
  fitting_height(points, layout);
  return layout;
}

std::string scatter_chart(const ChartText& text, std::span<const ChartPoint> points) {
  return Drawing(text, points).draw();
}

}  // namespace plumb::tool
