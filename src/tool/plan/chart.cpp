// What a plan saves on each lattice, and what each bounding volume costs, in one picture.
#include "tool/drawing/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "certify/catalog.hpp"
#include "tool/drawing/log_axis.hpp"
#include "tool/plan/command.hpp"

namespace plumb::tool {
namespace {

constexpr double kWidth = 1120, kLeft = 118, kTop = 124, kRow = 44, kPanel = 158, kGap = 18;
constexpr double kDamage = kLeft + classic_count * (kPanel + kGap), kRight = kWidth - 24;
constexpr double kBoundsLeft = 230;

struct Column {
  double end;  // of its text
  std::string_view title;
};
constexpr std::array<Column, 4> damage_columns{{{68, "move"}, {134, "merged"}, {206, "collapsed"}, {264, "turned"}}};

/// The least and the largest of what is positive and finite.
class Range {
 public:
  void include(double x) {
    if (!(x > 0) || !std::isfinite(x)) return;
    low_ = any_ ? std::min(low_, x) : x;
    high_ = any_ ? std::max(high_, x) : x;
    any_ = true;
  }
  [[nodiscard]] LogAxis axis(double from, double to) const {
    return LogAxis(low_, high_, LogAxis::Ends::padded, from, to);
  }

 private:
  bool any_ = false;
  double low_ = 1, high_ = 10;
};

class PlanChart {
 public:
  explicit PlanChart(const ScenePlan& scene) : scene_(scene) {
    rows_bottom_ = kTop + kRow * static_cast<double>(scene.rows.size());
    bounds_top_ = rows_bottom_ + 118;
    bottom_ = bounds_top_ + kRow * static_cast<double>(scene.bounds.size());
  }

  std::string draw() {
    const double height = bottom_ + 44;
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>What a scene needs</title>\n",
        kWidth, height);
    out_ += chart_style;
    put("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", kWidth, height);
    const std::string scene =
        scene_.names.size() == 1 ? escaped(scene_.names[0]) : fmt::format("a scene of {} meshes", scene_.names.size());
    text(24, 36, "font-size=\"19\" font-weight=\"600\"", "What a scene needs: " + scene);
    text(24, 58, "class=\"muted\" font-size=\"13\"",
         "nanoseconds a decision on each lattice: circle, decide; square, the plan, with its arithmetic. On the right, "
         "the greatest move and what snapping does.");
    draw_lattices();
    draw_bounds();
    return out_ + "</svg>\n";
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(values)...);
  }
  /// Text as XML holds it.
  void text(double x, double y, std::string_view attributes, std::string_view words) {
    put("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, words);
  }
  void band(std::size_t row, double y) {
    if (row % 2 == 0)
      put("<rect class=\"band\" x=\"24\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\"/>\n", y - kRow / 2,
          kRight - 24, kRow);
  }
  void grid(const LogAxis& axis, double top, double bottom) {
    const auto ticks = axis.ticks();
    double last = -1e9;
    for (const Tick& t : ticks) {
      if (!t.labeled || t.at - last < 24) continue;
      put("<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\"/>\n", t.at, top, bottom);
      text(t.at, bottom + 18, "class=\"muted\" font-size=\"12\" text-anchor=\"middle\"", tick_text(t, ticks));
      last = t.at;
    }
  }
  void circle(double x, double y, std::string_view hint) {
    put("<circle class=\"s1 marker\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"><title>{}</title></circle>\n", x, y, hint);
  }
  void square(double x, double y, std::string_view hint) {
    put("<rect class=\"s0 marker\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"10\" height=\"10\"><title>{}</title></rect>\n",
        x - 5, y - 5, hint);
  }

  [[nodiscard]] static double row_at(std::size_t row) { return kTop + kRow * (static_cast<double>(row) + 0.5); }

  void draw_lattices() {
    for (std::size_t row = 0; row < scene_.rows.size(); ++row) {
      const ScenePlanRow& r = scene_.rows[row];
      band(row, row_at(row));
      text(34, row_at(row) - 2, "font-size=\"14\"", fmt::format("{} bits", r.bits));
      text(34, row_at(row) + 15, "class=\"muted\" font-size=\"12\"",
           row == 0 ? std::string("as given")
                    : fmt::format("of 2<tspan dy=\"-5\" font-size=\"9\">{}{}</tspan>", r.exponent < 0 ? "−" : "",
                                  std::abs(r.exponent)));
      draw_damage(r, row_at(row) + 5);
    }
    for (const Column& c : damage_columns)
      text(kDamage + c.end, kTop - 16, "font-size=\"12\" font-weight=\"600\" text-anchor=\"end\"", c.title);
    for (std::size_t k = 0; k < classic_count; ++k) draw_predicate(k);
  }

  void draw_damage(const ScenePlanRow& r, double y) {
    if (r.damage.empty()) return;
    const std::array numbers{fmt::format("{:.3g}", r.greatest_move()), std::to_string(r.merged()),
                             std::to_string(r.collapsed()), std::to_string(r.turned_over())};
    for (std::size_t i = 0; i < numbers.size(); ++i)
      text(kDamage + damage_columns[i].end, y, "font-size=\"12\" text-anchor=\"end\"", numbers[i]);
  }

  void draw_predicate(std::size_t k) {
    const double left = kLeft + static_cast<double>(k) * (kPanel + kGap);
    text(left, kTop - 16, "font-size=\"13\" font-weight=\"600\"", classics()[k].name);
    Range range;
    for (const ScenePlanRow& r : scene_.rows) {
      range.include(r.times[k].decide);
      range.include(r.times[k].plan);
    }
    const LogAxis axis = range.axis(left, left + kPanel);
    grid(axis, kTop, rows_bottom_);
    for (std::size_t row = 0; row < scene_.rows.size(); ++row) {
      const DecisionTimes& t = scene_.rows[row].times[k];
      const Arithmetic a = scene_.rows[row].arithmetic[k];
      const double y = row_at(row) + 6;
      double x = left + kPanel / 2;
      if (t.decide > 0 && t.plan > 0) {
        put("<line class=\"axis\" x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\"/>\n", axis.at(t.decide),
            y, axis.at(t.plan));
        circle(axis.at(t.decide), y, fmt::format("decide: {:.2f} ns", t.decide));
        square(axis.at(t.plan), y, fmt::format("plan, {}: {:.2f} ns", to_string(a), t.plan));
        x = std::clamp(axis.at(t.plan), left + 24, left + kPanel - 24);
      }
      text(x, y - 10, "class=\"label\" style=\"font-size:11px\" text-anchor=\"middle\"", short_name(a));
    }
  }

  void draw_bounds() {
    text(24, bounds_top_ - 46, "font-size=\"16\" font-weight=\"600\"", "Bounding volumes");
    text(24, bounds_top_ - 24, "class=\"muted\" font-size=\"13\"",
         "nanoseconds a query is expected to take behind each kind (circles), behind the chosen one (square), and "
         "without a volume (bar)");
    Range range;
    for (const BoundPlan& b : scene_.bounds) {
      range.include(b.without_ns());
      for (std::size_t k = 0; k < bound_kinds.size(); ++k) range.include(b.rated.expected_ns(k));
    }
    const LogAxis axis = range.axis(kBoundsLeft, kRight - 16);
    const auto row = [&](std::size_t i) { return bounds_top_ + kRow * (static_cast<double>(i) + 0.5); };
    for (std::size_t i = 0; i < scene_.bounds.size(); ++i) band(i, row(i));
    grid(axis, bounds_top_, bottom_);
    for (std::size_t i = 0; i < scene_.bounds.size(); ++i) {
      const BoundPlan& b = scene_.bounds[i];
      const double y = row(i) + 6;
      text(34, y, "font-size=\"13\"", escaped(last_of(b.rated.name)));
      for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
        const double ns = b.rated.expected_ns(k);
        if (k != b.chosen && ns > 0) circle(axis.at(ns), y, fmt::format("{}: {:.1f} ns", name_of(bound_kinds[k]), ns));
      }
      if (b.without_ns() > 0)
        put("<rect class=\"s6\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"2.4\" height=\"20\"/>\n",
            axis.at(b.without_ns()) - 1.2, y - 10);
      const std::string_view chosen = name_of(bound_kinds[b.chosen]);
      if (b.with_ns() <= 0) continue;
      square(axis.at(b.with_ns()), y, fmt::format("{}: {:.1f} ns", chosen, b.with_ns()));
      text(axis.at(b.with_ns()), y - 10, "class=\"label\" style=\"font-size:11px\" text-anchor=\"middle\"", chosen);
    }
  }

  /// A path's end, which tells files apart.
  static std::string last_of(const std::string& name) {
    std::string shown = printable(name.substr(name.rfind('/') + 1));
    return shown.size() > 26 ? shown.substr(0, 23) + "..." : shown;
  }

  const ScenePlan& scene_;
  double rows_bottom_, bounds_top_, bottom_;
  std::string out_;
};

}  // namespace

std::string plan_chart(const ScenePlan& scene) { return PlanChart(scene).draw(); }

}  // namespace plumb::tool
