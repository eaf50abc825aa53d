#include "plumb/query/convex/thick_plane.hpp"

#include <algorithm>

#include "query/body/figure_input.hpp"
#include "query/convex/round_parts.hpp"

namespace plumb::query {
namespace {

/// What lies beyond normal . x = offset by more than a distance, whose square is times the normal's.
struct BeyondSlab {
  Exact3 normal;
  mpq_class offset, radius;

  [[nodiscard]] bool has(const RoundPart& part) const {
    const mpq_class rise = dot(normal, part.at) - offset, needed = radius - part.radius;
    const mpq_class square = needed * needed * dot(normal, normal);
    if (sgn(needed) >= 0) return sgn(rise) > 0 && rise * rise > square;
    return sgn(rise) >= 0 || rise * rise < square;
  }
  [[nodiscard]] bool has_some_of(const RoundParts& all) const {
    if (all.parts.empty()) return false;
    const auto rises = [&](const Exact3& d) { return sgn(dot(normal, d)) > 0; };
    return std::ranges::any_of(all.parts, [&](const RoundPart& part) { return has(part); }) ||
           std::ranges::any_of(all.directions, rises) ||
           std::ranges::any_of(all.lines, [&](const Exact3& d) { return sgn(dot(normal, d)) != 0; });
  }
};

}  // namespace

ThickSide side_of_view(const ThickPlane3& plane, const FigureView& figure) {
  require_figure("side_of", "plane", Plane3{plane.normal, plane.offset});
  require_figure("side_of", "plane", Sphere3{{0, 0, 0}, plane.radius});
  require_figure("side_of", spoken(figure), figure);
  const RoundParts parts = round_parts(figure);
  const Vector3& n = plane.normal;
  const BeyondSlab front{{mpq_class(n.x), mpq_class(n.y), mpq_class(n.z)}, plane.offset, plane.radius};
  const BeyondSlab back{mpq_class(-1) * front.normal, -front.offset, front.radius};
  const bool in_front = front.has_some_of(parts), behind = back.has_some_of(parts);
  if (in_front && behind) return ThickSide::straddling;
  return in_front ? ThickSide::in_front : behind ? ThickSide::behind : ThickSide::coplanar;
}

}  // namespace plumb::query
