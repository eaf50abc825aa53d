#include "plumb/query/separation/separation.hpp"

#include "arith/exact_number.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/vectors.hpp"
#include "query/closest/flat_box.hpp"
#include "query/convex/core.hpp"
#include "query/convex/search.hpp"
#include "query/separation/aligned_boxes.hpp"
#include "query/separation/cores.hpp"
#include "query/separation/edge_sums.hpp"
#include "query/separation/quick.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

std::string_view name_in_pair(const FigureView& figure, const FigureView& other, std::string_view name) {
  return figure.kind == other.kind ? name : spoken(figure);
}

void require_one(std::string_view function, std::string_view name, const FigureView& figure) {
  require_figure(function, name, figure);
  with_figure(figure, [&](const auto& s) {
    const auto look = [&](std::span<const Point3> all) { require_planar(function, name, plane_of_points(all)); };
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, Quadrilateral3>) {
      look(std::array{s.a, s.b, s.c, s.d});
    } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, Polygon3>) {
      look(s.vertices);
    } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, HoledPolygon3>) {
      std::vector<Point3> all = s.outer.vertices;
      for (const Polygon3& hole : s.holes) all.insert(all.end(), hole.vertices.begin(), hole.vertices.end());
      look(all);
    }
  });
}

[[noreturn]] void throw_nothing_there(std::string_view function, std::string_view name) {
  throw InvalidShape(std::string(function).append(": ").append(name).append(
      " is empty, and nothing is nearest; give one that has a point"));
}

/// What is nearest, of figures that are some.
NearestPair sound_pair(std::string_view function, const FigureAt& at_a, const FigureAt& at_b, WhichPair which) {
  const FigureView &a = at_a.figure, &b = at_b.figure;
  const std::string_view name_a = name_in_pair(a, b, "a"), name_b = name_in_pair(b, a, "b");
  require_one(function, name_a, a), require_one(function, name_b, b);
  auto pair = nearest_of_cores(at_a, at_b, which);
  if (!pair) throw_nothing_there(function, is_polygon(a) || core_of(a).points.empty() ? name_a : name_b);
  return std::move(*pair);
}

mpq_class both_radii(const FigureView& a, const FigureView& b) {
  return mpq_class(radius_of(a)) + mpq_class(radius_of(b));
}

}  // namespace

Closest closest_points_of(const FigureView& a, const FigureView& b, WhichPair common) {
  if (const auto f = facing_points(a, b)) {
    const auto feature = [&](const Aabb3& box, const Point3& p) {
      return a.dimension == 2 ? of_flat_box(voronoi_region(box, p)) : voronoi_region(box, p);
    };
    return {told(f->on_a), told(f->on_b), distance(f->on_a, f->on_b), feature(f->a, f->on_a), feature(f->b, f->on_b)};
  }
  if (const auto c = closest_of_sums({a}, {b})) return *c;
  if (const auto c = closest_by_search({a}, {b}, common)) return *c;
  const NearestPair pair = sound_pair("closest_points", a, b, WhichPair::first);  // a radius is a number after this
  return told_pair(pair, {a, radius_of(a)}, {b, radius_of(b)});
}

double distance_at(const FigureAt& a, const FigureAt& b, std::string_view function) {
  if (const auto quick = QuickPair::of(a, b)) {
    const auto d = quick->distance();
    return d ? *d : rounded_distance(quick->square(), both_radii(a.figure, b.figure));
  }
  const mpq_class square = sound_pair(function, a, b, WhichPair::any).square;
  return rounded_distance(square, both_radii(a.figure, b.figure));
}

double distance_of(const FigureView& a, const FigureView& b, Question question) {
  if (const auto f = facing_points(a, b)) return distance(f->on_a, f->on_b);
  if (const auto d = distance_of_sums({a}, {b})) return *d;
  if (const auto d = distance_by_search({a}, {b})) return *d;
  return distance_at(a, b, name_of(question));
}

double distance_of_moved(const FigureView& a, const Vector3& by_a, const FigureView& b, const Vector3& by_b,
                         double time, std::string_view function) {
  return distance_at({a, by_a, time}, {b, by_b, time}, function);
}

ExactDistance exact_distance_of(const FigureView& a, const FigureView& b, Question question) {
  if (const auto f = facing_points(a, b)) return exact_distance(f->on_a, f->on_b);
  if (const auto quick = QuickPair::of(a, b)) return {exact_number(quick->square()), exact_number(both_radii(a, b))};
  return {exact_number(sound_pair(name_of(question), a, b, WhichPair::any).square), exact_number(both_radii(a, b))};
}

}  // namespace plumb::query
