#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/separation/posed.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"

namespace plumb::query {
namespace {

Closest in_space(const Closest& c) { return c; }
Closest in_space(const Closest2& c) {
  return {{c.on_a.x, c.on_a.y, 0}, {c.on_b.x, c.on_b.y, 0}, c.distance, c.feature_a, c.feature_b};
}

bool is_triangle(const PosedView& v) { return v.figure.kind == FigureKind::triangle && v.in_space != nullptr; }
bool is_point(const PosedView& v) { return v.figure.kind == FigureKind::point && !is_posed_view(v); }
Posed<Triangle3> triangle_of(const PosedView& v) {
  return {*static_cast<const Triangle3*>(v.figure.shape), *v.in_space};
}

Closest closest_of_posed(const PosedView& a, const PosedView& b) {
  if (is_triangle(a) && is_triangle(b)) return posed_closest_points(triangle_of(a), triangle_of(b));
  const auto point = [](const PosedView& v) { return *static_cast<const Point3*>(v.figure.shape); };
  if (is_point(a) && is_triangle(b)) return posed_closest_points(point(a), triangle_of(b));
  if (is_triangle(a) && is_point(b)) return swapped(posed_closest_points(point(b), triangle_of(a)));
  return posed_closest_points(a, b);
}

}  // namespace

Closest any_closest_points(const PosedView& a, const PosedView& b) {
  require_answer(closest_pairs, "closest_points", a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) return closest_of_posed(a, b);
  if (b.figure.kind < a.figure.kind) return swapped(any_closest_points(b, a));
  return asked_in_order<Closest>(
      "closest_points", a.figure, b.figure, [](const auto& x, const auto& y) requires requires {
        closest_points(x, y);
      } { return in_space(closest_points(x, y)); });
}

}  // namespace plumb::query
