// The k-d tree over its points: the planes that divide them, level by level, the queries, and what was found for them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "tool/drawing/data_view.hpp"
#include "tool/nearest/command.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view kAxes = "xyz";
constexpr std::string_view kTreeStyle =
    "  .point { fill: #4d4d4d; } .query { fill: #d55e00; stroke: #d55e00; }\n"
    "  .found { stroke: #d55e00; } .ball { stroke: #d55e00; fill: #d55e00; fill-opacity: 0.06; }\n"
    "  .plane { stroke: #0072b2; fill: #0072b2; }\n"
    "  @media (prefers-color-scheme: dark) { .point { fill: #c4cad1; } .plane { stroke: #4aa8e0; fill: #4aa8e0; } }\n";

using Place = std::array<double, 3>;
Place place_of(const Point2& p) { return {p.x, p.y, 0}; }
Place place_of(const Point3& p) { return {p.x, p.y, p.z}; }

struct Extent {
  Place min, max;
};

template <class Point>
class TreeView {
 public:
  TreeView(std::span<const Point> points, std::span<const Point> queries, const NearestReport& report,
           const NearestPicture& most)
      : points_(points), queries_(queries), report_(report), most_(most), tree_(build_kd_tree(points)) {
    constexpr double largest = std::numeric_limits<double>::max();
    all_ = {{largest, largest, largest}, {-largest, -largest, -largest}};
    for (const std::span<const Point> set : {points, queries}) {
      for (const Point& p : set) include(place_of(p));
    }
    if (all_.min[0] > all_.max[0]) all_ = {};
    for (std::size_t k = 0; KdTree<Point>::dimension == 3 && k < 3; ++k) {
      if (length(k) < length(hidden_)) hidden_ = k;
    }
    right_ = hidden_ == 0 ? 1 : 0;
    up_ = hidden_ == 2 ? 1 : 2;
  }

  std::string draw() {
    const auto axis = [&](std::size_t k) { return DataAxis{std::string(1, kAxes[k]), all_.min[k], all_.max[k]}; };
    DataView view("The k-d tree of " + report_.points.name, kTreeStyle, axis(right_), axis(up_));
    const unsigned levels = std::min(tree_.levels, most_.levels);
    const std::size_t every = every_of(points_.size(), most_.points);
    const std::size_t asked = std::min(queries_.size(), most_.queries);
    std::string counts = fmt::format("{} in {} of a tree of {}", plural(points_.size(), "point", "points"),
                                     plural(tree_.leaves(), "leaf", "leaves"), plural(tree_.levels, "level", "levels"));
    if (KdTree<Point>::dimension == 3)
      counts += fmt::format("; seen along {0}: planes square to {0} are not seen", kAxes[hidden_]);
    view.say(counts);
    view.say(what_is_left_out(levels, every, asked));
    view.explain("plane", "a plane of the tree");
    view.explain("point", "a point");
    view.explain("query", report_.radius ? "a query, and its ball" : "a query, and the way to what is nearest");
    if (tree_.count != 0) add_planes(view, levels);
    view.begin_group("points", 0);
    for (std::size_t i = 0; i < points_.size(); i += every) view.dot("point", seen(points_[i]), 1.3);
    view.end_group();
    add_queries(view, asked);
    return view.text();
  }

 private:
  static std::size_t every_of(std::size_t many, std::size_t most) {
    return most == 0 ? many + 1 : std::max<std::size_t>((many + most - 1) / most, 1);
  }
  void include(const Place& p) {
    for (std::size_t k = 0; k < 3; ++k)
      all_.min[k] = std::min(all_.min[k], p[k]), all_.max[k] = std::max(all_.max[k], p[k]);
  }
  [[nodiscard]] double length(std::size_t k) const { return all_.max[k] / 2 - all_.min[k] / 2; }
  [[nodiscard]] std::array<double, 2> seen(const Point& p) const { return {place_of(p)[right_], place_of(p)[up_]}; }

  [[nodiscard]] std::string what_is_left_out(unsigned levels, std::size_t every, std::size_t asked) const {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    if (levels < tree_.levels) add(fmt::format("the planes of the first {} levels are drawn", levels));
    if (every > 1) add(fmt::format("one of {} points is drawn", every));
    if (asked < queries_.size())
      add(fmt::format("the first {} of {} queries are drawn", asked, grouped(queries_.size())));
    if (report_.first[asked] > most_.lines)
      add(fmt::format("so are lines to the first {} points", grouped(most_.lines)));
    return text.empty() ? "all planes, points and queries are drawn" : text;
  }

  void add_planes(DataView& view, unsigned levels) {
    std::vector<Extent> cells{all_};
    for (unsigned level = 0; level < levels; ++level) {
      view.begin_group(fmt::format("level-{}", level), std::max(2.2 - 0.25 * level, 0.4));
      std::vector<Extent> children;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t node = (std::size_t{1} << level) - 1 + i, axis = tree_.axes[node];
        Extent lower = cells[i], upper = cells[i];
        lower.max[axis] = upper.min[axis] = tree_.planes[node];
        if (axis != hidden_ || KdTree<Point>::dimension == 2)
          view.line(
              "plane", {upper.min[right_], upper.min[up_]},
              {axis == right_ ? upper.min[right_] : upper.max[right_], axis == up_ ? upper.min[up_] : upper.max[up_]});
        children.insert(children.end(), {lower, upper});
      }
      view.end_group();
      cells = std::move(children);
    }
  }

  void add_queries(DataView& view, std::size_t asked) {
    view.begin_group("queries", 0.8);
    for (std::size_t q = 0; q < asked; ++q) {
      if (report_.radius) view.circle("ball", seen(queries_[q]), *report_.radius);
      for (std::size_t i = report_.first[q]; i < std::min(report_.first[q + 1], most_.lines); ++i)
        view.line("found", seen(queries_[q]), seen(points_[report_.found[i].index]));
      view.dot("query", seen(queries_[q]), 2.6);
    }
    view.end_group();
  }

  std::span<const Point> points_, queries_;
  const NearestReport& report_;
  NearestPicture most_;
  KdTree<Point> tree_;
  Extent all_{};
  std::size_t hidden_ = 2, right_ = 0, up_ = 1;
};

}  // namespace

std::string nearest_svg(const NearestReport& r, const NearestPicture& most) {
  if (r.is_planar()) return TreeView<Point2>(r.points.plane, r.queries.plane, r, most).draw();
  return TreeView<Point3>(r.points.space, r.queries.space, r, most).draw();
}

}  // namespace plumb::tool
