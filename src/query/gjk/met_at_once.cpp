#include "query/gjk/met_at_once.hpp"

#include <algorithm>
#include <cmath>

#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/short_dyadic.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/convex/search.hpp"
#include "query/gjk/quick_nearest.hpp"
#include "query/separation/exact_corners.hpp"

namespace plumb::query {
namespace {

MetAtOnce meeting_of(const ProvedCorners& proved) {
  return !proved.meets ? MetAtOnce::apart : proved.corners.size == 4 ? MetAtOnce::overlap : MetAtOnce::meet;
}

DifferenceCorners corners_of(const GjkSimplex& simplex) {
  DifferenceCorners corners;
  for (std::uint32_t i = 0; i < simplex.size; ++i) corners.add(simplex.corners[i]);
  return corners;
}

void keep(GjkCache& found, const DifferenceCorners& corners, const arith::Plain& way) {
  found.direction = {way.x, way.y, way.z}, found.simplex.size = static_cast<std::uint32_t>(corners.size);
  for (std::size_t i = 0; i < corners.size; ++i) found.simplex.corners[i] = corners.ends[i];
}

/// Has the plane through three corners of the difference, which hold the origin, either hull on a side of its own, and not
/// all of both in it?
template <class T>
std::optional<bool> are_parted_in(const std::array<CoreCorners, 2>& c, const DifferenceCorners& corners) {
  const auto at = differences_of<T>(c[0], c[1], corners);
  const auto n = arith::cross(at[1] - at[0], at[2] - at[0]);
  CertainSigns ask;
  std::array<std::array<bool, 2>, 2> beside{};  // of either hull: is there something ahead, and behind?
  for (std::size_t k = 0; k < 2; ++k) {
    const auto from = c[k].at<T>(corners.ends[0][k]);
    for (std::size_t i = 0; i < c[k].size() && !(beside[k][0] && beside[k][1]) && ask.certain(); ++i) {
      const Sign s = ask(dot(n, c[k].at<T>(i) - from));
      beside[k][0] = beside[k][0] || s == Sign::positive, beside[k][1] = beside[k][1] || s == Sign::negative;
    }
  }
  if (!ask.certain()) return {};
  const auto& [a, b] = beside;
  return !(a[0] && (a[1] || b[0])) && !(b[1] && (b[0] || a[1])) && (a[0] || a[1] || b[0] || b[1]);
}

/// Of corners that are no doubles as given, and no radius.
MetAtOnce met_under_pose(const QuickBody& a, const QuickBody& b, GjkCache& found) {
  const auto c = corners_of(a, b);
  if (!c[0].is_finite() || !c[1].is_finite()) return MetAtOnce::unsure;
  const ProvedCorners proved = certainly_nearest(c[0], c[1], corners_of(found.simplex));
  keep(found, proved.corners, {0, 0, 0});
  if (!proved.meets || proved.corners.size != 3) return meeting_of(proved);
  auto parted = are_parted_in<ShortDyadic>(c, proved.corners);
  if (!parted) parted = are_parted_in<BigDyadic>(c, proved.corners);
  return *parted ? MetAtOnce::touch : MetAtOnce::meet;
}

/// By integers of the width that it takes.
MetAtOnce met_by_reach(const QuickBody& a, const QuickBody& b, GjkCache& found) {
  std::uint32_t steps = 0;
  const Told told = quickly_told_round(a, b, found, steps);
  if (told == Told::apart) return MetAtOnce::apart;
  if (!a.hull.is_finite_but_of_solid() || !b.hull.is_finite_but_of_solid()) return MetAtOnce::unsure;
  if (told == Told::meet) return MetAtOnce::overlap;
  const auto c = corners_of(a, b);
  if (!c[0].is_finite() || !c[1].is_finite() || !figure::is_real(a.radius + b.radius)) return MetAtOnce::unsure;
  const DifferenceCorners corners = corners_of(found.simplex);
  const auto at_once = judged<ShortDyadic>(c[0], c[1], corners);
  const ProvedCorners proved = at_once && at_once->holds ? at_once->proved : certainly_nearest(c[0], c[1], corners);
  keep(found, proved.corners, {0, 0, 0});
  if (proved.meets) return MetAtOnce::overlap;
  const Sign gap = gap_of(c[0], c[1], proved.corners, a.radius, b.radius);
  return gap == Sign::zero ? MetAtOnce::touch : gap == Sign::positive ? MetAtOnce::apart : MetAtOnce::overlap;
}

}  // namespace

MetAtOnce met_at_once(const QuickBody& a, const QuickBody& b, GjkCache& found) {
  if (a.radius > 0 || b.radius > 0) return met_by_reach(a, b, found);
  std::uint32_t steps = 0;
  const Told told = quickly_told(a, b, found, steps);
  if (told == Told::apart) return MetAtOnce::apart;
  if (!a.hull.is_finite_but_of_solid() || !b.hull.is_finite_but_of_solid()) return MetAtOnce::unsure;
  if (told == Told::meet) return found.simplex.size == 4 ? MetAtOnce::overlap : MetAtOnce::meet;
  if (!a.hull.is_given() || !b.hull.is_given()) return met_under_pose(a, b, found);
  const DifferenceCorners corners = corners_of(found.simplex);
  auto n = certainly_proved(a.hull, b.hull, corners);
  if (!n) n = finely_nearest(a.hull, b.hull, corners);
  if (!n) return MetAtOnce::unsure;
  keep(found, n->proved.corners, n->way);
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

/// `other`: what lines and rays are cut to, as both are given: not under a pose of either.
bool set(QuickBody& body, std::optional<CoreCorners>& cut, const BodyView& other) {
  const FigureView& figure = body.view.figure;
  if (!is_one_of(figure.kind, {FigureKind::line, FigureKind::ray})) return body.set();
  if (other.figure.kind != FigureKind::convex_polyhedron || !body.view.pose.stands() || !other.pose.stands())
    return false;
  cut = cut_to(*static_cast<const ConvexPolyhedron3*>(other.figure.shape), figure);
  body.core = cut ? &*cut : nullptr;
  return cut && body.hull.set(*cut);
}

/// Two figures, whose corners may be asked.
struct FigurePair {
  BodyView view_of_a, view_of_b;
  QuickBody a{view_of_a}, b{view_of_b};
  std::optional<CoreCorners> part_of_a = {}, part_of_b = {};
  GjkCache found = {};

  MetAtOnce met() {
    // A corner that is no number is the farthest one nowhere, and might never be asked.
    const bool are_numbers = set(a, part_of_a, view_of_b) && set(b, part_of_b, view_of_a) &&
                             a.hull.is_finite_but_of_solid() && b.hull.is_finite_but_of_solid();
    return are_numbers ? met_at_once(a, b, found) : MetAtOnce::unsure;
  }
};

}  // namespace

std::optional<Relation> relate_by_search(const PosedView& a, const PosedView& b) {
  FigurePair pair{.view_of_a = body_of(a), .view_of_b = body_of(b)};
  switch (pair.met()) {
    case MetAtOnce::apart:
      return Relation::disjoint;
    case MetAtOnce::touch:
      return Relation::touching;
    case MetAtOnce::overlap:
      return Relation::overlapping;
    case MetAtOnce::meet:
      if (pair.a.hull.is_given() && pair.b.hull.is_given() &&
          are_parted(pair.a.hull, pair.b.hull, corners_of(pair.found.simplex)))
        return Relation::touching;
      return {};
    default:
      return {};
  }
}

std::optional<bool> meet_by_search(const PosedView& a, const PosedView& b) {
  FigurePair pair{.view_of_a = body_of(a), .view_of_b = body_of(b)};
  const MetAtOnce met = pair.met();
  if (met == MetAtOnce::unsure) return {};
  return met != MetAtOnce::apart;
}

}  // namespace plumb::query
