#include "query/convex/round_parts.hpp"

#include <algorithm>

#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"
#include "query/convex/core.hpp"

namespace plumb::query {
namespace {

/// At both ends of an axis, or a ball where they are one.
void add_disk(RoundParts& all, const Exact3& at, const Exact3& axis, double radius) {
  all.parts.push_back({at, mpq_class(radius), !is_zero(axis), axis});
}

mpq_class squared(const Exact3& v) { return dot(v, v); }

mpq_class squared_distance(const Exact3& p, const Exact3& from, const Exact3& along) {
  const Exact3 w = p - from;
  const mpq_class square = squared(along);
  if (square == 0) return squared(w);
  const mpq_class t = std::clamp(mpq_class(dot(w, along) / square), mpq_class(0), mpq_class(1));
  return squared(w - t * along);
}

}  // namespace

mpq_class squared_distance(const Exact3& p, const Exact3& corner, const Exact3& e, const Exact3& f) {
  const Exact3 w = p - corner, n = cross(e, f);
  const mpq_class square = squared(n);
  if (square != 0) {
    const mpq_class s = dot(cross(w, f), n) / square, t = dot(cross(e, w), n) / square;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
      const mpq_class height = dot(w, n);
      return height * height / square;
    }
  }
  return std::min({squared_distance(p, corner, e), squared_distance(p, corner, f), squared_distance(p, corner + f, e),
                   squared_distance(p, corner + e, f)});
}

RoundParts round_parts(const FigureView& v) {
  RoundParts all;
  with_figure(v, [&]<class Shape>(const Shape& s) {
    if constexpr (requires { s.apex; }) {
      all.parts.push_back({exact3(s.apex), 0, false, {}});
      add_disk(all, exact3(s.base), exact3(s.base) - exact3(s.apex), s.radius);
    } else if constexpr (std::is_same_v<Shape, Cylinder3>) {
      const Exact3 a = exact3(s.a), b = exact3(s.b);
      add_disk(all, a, b - a, s.radius);
      add_disk(all, b, b - a, s.radius);
    } else if constexpr (has_boundary<Shape> && (!FlatFigure<Shape> || is_one_of(figure_kind<Shape>, polygon_kinds))) {
      const mpq_class radius = radius_of(v);
      for_each_corner<mpq_class>(s, [&](const arith::Vec<mpq_class>& p) {
        all.parts.push_back({{p.x, p.y, p.z}, radius, false, {}});
      });
    } else {
      FlatSet flat = flat_set(v);
      for (const Exact3& p : flat.points) all.parts.push_back({p, mpq_class(0), false, {}});
      all.directions = std::move(flat.directions);
      all.lines = std::move(flat.lines);
    }
  });
  return all;
}

}  // namespace plumb::query
