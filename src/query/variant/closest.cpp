#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/separation/posed.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

Closest in_space(const Closest& c) { return c; }
Closest in_space(const Closest2& c) {
  return {{c.on_a.x, c.on_a.y, 0}, {c.on_b.x, c.on_b.y, 0}, c.distance, c.feature_a, c.feature_b};
}

Closest closest_of_posed(const PosedView& a, const PosedView& b) {
  const auto triangle_a = posed_triangle(a), triangle_b = posed_triangle(b);
  if (triangle_a && triangle_b) return posed_closest_points(*triangle_a, *triangle_b);
  const auto is_point = [](const PosedView& v) { return v.figure.kind == FigureKind::point && !is_posed_view(v); };
  const auto point = [](const PosedView& v) { return *static_cast<const Point3*>(v.figure.shape); };
  if (is_point(a) && triangle_b) return posed_closest_points(point(a), *triangle_b);
  if (triangle_a && is_point(b)) return swapped(posed_closest_points(point(b), *triangle_a));
  return posed_closest_points(a, b, WhichPair::any);
}

Closest closest_of_views(const PosedView& a, const PosedView& b) {
  require_answer(closest_pairs, "closest_points", a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) return closest_of_posed(a, b);
  if (b.figure.kind < a.figure.kind) return swapped(closest_of_views(b, a));
  return asked_in_order<PairsOf<closest_pairs>, Closest>(
      "closest_points", a.figure, b.figure, [](const auto& x, const auto& y) requires requires {
        closest_points(x, y);
      } { return in_space(closest_points(x, y)); });
}

}  // namespace

Closest any_closest_points(const PosedView& a, const PosedView& b) {
  return recorded("closest_points", {a, b}, {}, [&] { return closest_of_views(a, b); });
}

}  // namespace plumb::query
