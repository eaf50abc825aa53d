// Along a direction an affine image reaches as far as the figure does along what the transpose makes of it.  A figure is the
// hull of points, balls and disks (query/convex/round_parts.hpp), of which each reaches as far as a root says; rounding
// keeps order, so that the greatest of the rounded ones is the greatest one rounded.
#include "plumb/query/convex/posed_support.hpp"

#include <algorithm>

#include "arith/root_sign.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/cap_relation.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/round_parts.hpp"
#include "query/convex/rounded_root.hpp"

namespace plumb::query {
namespace {

/// base + share times the root of the square; from the origin.
struct PartReach {
  mpq_class base, share, square;
};

mpq_class squared_length(const Exact3& v) { return dot(v, v); }

PartReach reach_of_part(const RoundPart& part, const Exact3& d) {
  if (!part.is_disk) return {dot(part.at, d), part.radius, squared_length(d)};
  return {dot(part.at, d), part.radius, squared_length(cross(d, part.axis)) / squared_length(part.axis)};
}

/// Of a cap with an inside: of its ball where that is farthest within the halfspace, else of the circle in the plane.
PartReach reach_of_cap(const SphericalCap3& cap, const Exact3& d) {
  const Exact3 center = exact3(cap.sphere.center), normal = exact_way(cap.halfspace.normal);
  const mpq_class radius = cap.sphere.radius, depth = mpq_class(cap.halfspace.offset) - dot(normal, center);
  const mpq_class square = squared_length(d), across = squared_length(normal);
  // center + radius d / |d| is within where radius normal . d <= depth |d|.
  if (sign_of_root(mpq_class(radius * dot(normal, d)), mpq_class(-depth), square) != Sign::positive)
    return {dot(center, d), radius, square};
  const Exact3 foot = center + mpq_class(depth / across) * normal;
  const mpq_class circle = radius * radius - depth * depth / across;
  return {dot(foot, d), 1, circle * squared_length(cross(d, normal)) / across};
}

/// Which parts a figure is the hull of, under the map.
struct PosedReach {
  PosedReach(std::string_view asked, const PosedView& v) : function(asked), figure(v.figure) {
    require_posed(function, spoken(v.figure), v);
    map = exact_map(v.pose);
    if (figure.kind == FigureKind::spherical_cap) {
      const auto& whole = *static_cast<const SphericalCap3*>(figure.shape);
      if (const auto thin = thin_cap(whole)) {
        for (const Exact3& p : thin->points) parts.parts.push_back({p, 0, false, {}});
      } else {
        cap = &whole;
      }
    } else {
      parts = round_parts(figure);
    }
  }
  [[nodiscard]] bool is_nothing() const { return parts.parts.empty() && cap == nullptr; }
  [[noreturn]] void refuse(std::string_view why) const {
    throw InvalidShape(std::string(function).append(": ").append(spoken(figure)).append(" ").append(why));
  }

  /// Along a direction, of a figure that has a point.
  [[nodiscard]] double along(const Exact3& direction, Rounding rounding) const {
    const auto& [u, v, w] = map.columns;
    const Exact3 d{dot(u, direction), dot(v, direction), dot(w, direction)};
    const mpq_class moved = dot(map.translation, direction);
    const auto rounded = [&](const PartReach& r) {
      return rounded_with_root(rounding, mpq_class(r.base + moved), r.share, r.square);
    };
    if (cap != nullptr) return rounded(reach_of_cap(*cap, d));
    if (std::ranges::any_of(parts.directions, [&](const Exact3& way) { return sgn(dot(way, d)) > 0; }) ||
        std::ranges::any_of(parts.lines, [&](const Exact3& line) { return sgn(dot(line, d)) != 0; }))
      refuse("is unbounded; give directions that span all of space");
    double most = rounded(reach_of_part(parts.parts[0], d));
    for (const RoundPart& part : parts.parts) most = std::max(most, rounded(reach_of_part(part, d)));
    return most;
  }

  std::string_view function;
  FigureView figure;
  ExactMap map;
  RoundParts parts;
  const SphericalCap3* cap = nullptr;
};

}  // namespace

double posed_support_value(const PosedView& figure, const Vector3& direction, Rounding rounding) {
  require_finite_parts("support_value", {"direction"}, direction);
  const PosedReach reach("support_value", figure);
  if (reach.is_nothing()) reach.refuse("is empty; it has no farthest point");
  return reach.along(exact_way(direction), rounding);
}

Aabb3 posed_box(const PosedView& figure) {
  const PosedReach reach("fit_aabb", figure);
  if (reach.is_nothing()) {
    if (figure.figure.kind == FigureKind::k_dop) return {{1, 1, 1}, {-1, -1, -1}};
    reach.refuse("is empty; it has no box");
  }
  const auto bound = [&](int x, int y, int z) {
    return figure::box::require_bound(reach.along({x, y, z}, Rounding::up)) + 0.0;
  };
  return {{0.0 - bound(-1, 0, 0), 0.0 - bound(0, -1, 0), 0.0 - bound(0, 0, -1)},
          {bound(1, 0, 0), bound(0, 1, 0), bound(0, 0, 1)}};
}

}  // namespace plumb::query
