#include "query/gjk/met_at_once.hpp"

#include <algorithm>
#include <cmath>

#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/convex/search.hpp"
#include "query/gjk/quick_nearest.hpp"

namespace plumb::query {
namespace {

Meeting meeting_of(const ProvedCorners& proved) {
  return !proved.meets ? Meeting::apart : proved.corners.size == 4 ? Meeting::overlap : Meeting::meet;
}

DifferenceCorners corners_of(const GjkSimplex& simplex) {
  DifferenceCorners corners;
  for (std::uint32_t i = 0; i < simplex.size; ++i) corners.add(simplex.corners[i]);
  return corners;
}

void keep(GjkCache& found, const QuickNearest& n) {
  const DifferenceCorners& corners = n.proved.corners;
  found.direction = {n.way.x, n.way.y, n.way.z}, found.simplex.size = static_cast<std::uint32_t>(corners.size);
  for (std::size_t i = 0; i < corners.size; ++i) found.simplex.corners[i] = corners.ends[i];
}

}  // namespace

Meeting met_at_once(const QuickBody& a, const QuickBody& b, GjkCache& found) {
  std::uint32_t steps = 0;
  const Told told = quickly_told(a, b, found, steps);
  if (told == Told::apart) return Meeting::apart;
  if (!a.hull.is_finite_but_of_solid() || !b.hull.is_finite_but_of_solid()) return Meeting::unsure;
  if (told == Told::meet) return found.simplex.size == 4 ? Meeting::overlap : Meeting::meet;
  if (!a.hull.is_given() || !b.hull.is_given()) return Meeting::unsure;
  const DifferenceCorners corners = corners_of(found.simplex);
  auto n = certainly_proved(a.hull, b.hull, corners);
  if (!n) n = finely_nearest(a.hull, b.hull, corners);
  if (!n) return Meeting::unsure;
  keep(found, *n);
  return meeting_of(n->proved);
}

namespace {

/// Of a line or ray a part that goes beyond the solid along an axis: it meets the solid as the whole does.  Nothing where
/// doubles do not tell.
std::optional<CoreCorners> cut_to(const ConvexPolyhedron3& solid, const FigureView& straight) {
  const auto cut = [&](const Point3& from, const Vector3& along, bool both_sides) -> std::optional<CoreCorners> {
    const double x = std::fabs(along.x), y = std::fabs(along.y), z = std::fabs(along.z);
    const auto part = [&](const auto& v) { return x >= y && x >= z ? v.x : y >= z ? v.y : v.z; };
    double reach = 0;
    for (const Point3& v : solid.mesh.vertices) reach = std::max(reach, std::fabs(part(v) - part(from)));
    const double length = 2 * reach / std::max({x, y, z}) + 1;
    const CoreCorners c = CoreCorners::straight(from, along, length, both_sides);
    const Running first = part(c.at<Running>(0)), last = part(c.at<Running>(1));
    const bool is_forward = part(along) > 0;
    for (const Point3& v : solid.mesh.vertices) {
      const Running at(part(v));
      if (certain_sign(is_forward ? last - at : at - last) <= 0) return {};
      if (both_sides && certain_sign(is_forward ? at - first : first - at) <= 0) return {};
    }
    return c;
  };
  return with_figure(straight, [&](const auto& s) -> std::optional<CoreCorners> {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, Ray3>) {
      return cut(s.origin, s.direction, false);
    } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, Line3>) {
      return cut(s.point, s.direction, true);
    } else {
      return {};
    }
  });
}

/// `other`: what lines and rays are cut to.
bool set(QuickBody& body, std::optional<CoreCorners>& cut, const FigureView& figure, const FigureView& other) {
  if (!is_one_of(figure.kind, {FigureKind::line, FigureKind::ray})) return body.hull.set(body.view);
  if (other.kind != FigureKind::convex_polyhedron) return false;
  cut = cut_to(*static_cast<const ConvexPolyhedron3*>(other.shape), figure);
  body.core = cut ? &*cut : nullptr;
  return cut && body.hull.set(*cut);
}

/// Two figures, of which one is a polyhedron.
struct FigurePair {
  BodyView view_of_a, view_of_b;
  QuickBody a{view_of_a}, b{view_of_b};
  std::optional<CoreCorners> part_of_a = {}, part_of_b = {};
  GjkCache found = {};

  Meeting met() {
    const FigureView &p = view_of_a.figure, &q = view_of_b.figure;
    // A corner that is no number is the farthest one nowhere, and might never be asked.
    const bool are_numbers = set(a, part_of_a, p, q) && set(b, part_of_b, q, p) && a.hull.is_finite_but_of_solid() &&
                             b.hull.is_finite_but_of_solid();
    return are_numbers ? met_at_once(a, b, found) : Meeting::unsure;
  }
};

}  // namespace

std::optional<Relation> relate_by_search(const FigureView& a, const FigureView& b) {
  FigurePair pair{.view_of_a{.figure = a}, .view_of_b{.figure = b}};
  switch (pair.met()) {
    case Meeting::apart:
      return Relation::disjoint;
    case Meeting::overlap:
      return Relation::overlapping;
    case Meeting::meet:
      if (pair.a.hull.is_given() && pair.b.hull.is_given() &&
          are_parted(pair.a.hull, pair.b.hull, corners_of(pair.found.simplex)))
        return Relation::touching;
      return {};
    default:
      return {};
  }
}

std::optional<bool> meet_by_search(const FigureView& a, const FigureView& b) {
  FigurePair pair{.view_of_a{.figure = a}, .view_of_b{.figure = b}};
  const Meeting met = pair.met();
  if (met == Meeting::unsure) return {};
  return met != Meeting::apart;
}

}  // namespace plumb::query
