// Polygons: their inside, or the nearest of all edges.  Distances of edges are compared by intervals, and exactly where
// these overlap.
#include <optional>
#include <vector>

#include "figure/basic/plane_of_points.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "query/body/chain_edges.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {
namespace {

Feature region_of_edge(const Point2& a, const Point2& b, const Point2& p) { return voronoi_region(Segment2{a, b}, p); }
Feature region_of_edge(const Point3& a, const Point3& b, const Point3& p) { return voronoi_region(Segment3{a, b}, p); }

template <class T, class Point>
Foot<T> foot_on_chain(const ChainCorners<Point>& chains, const Feature& f, const Point& p) {
  const Vec<T> a = vec<T>(chains.corners[f.index]);
  if (f.kind == FeatureKind::vertex) return foot_on_point(a, vec<T>(p));
  return foot_on_line(a, vec<T>(chains.corners[chains.next(f.index)]) - a, vec<T>(p));
}

Sign compare_feet(const Foot<BigDyadic>& a, const Foot<BigDyadic>& b) {
  return (a.square() * b.over() - b.square() * a.over()).sign();
}

/// The nearest vertex or edge of the chains; of equally near ones the lowest.
template <class Point>
Feature nearest_on_chains(const ChainCorners<Point>& chains, const Point& p) {
  struct Candidate {
    Feature feature;
    double at_least;
  };
  std::vector<Candidate> candidates;
  double at_most = Interval::infinity;
  for (std::size_t c = 0; c + 1 < chains.first.size(); ++c) {
    for (std::uint32_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
      const std::uint32_t j = chains.next(c, i);
      Feature f = region_of_edge(chains.corners[i], chains.corners[j], p);
      f.index = f.kind == FeatureKind::vertex && f.index == 1 ? j : i;
      const Foot<Interval> foot = foot_on_chain<Interval>(chains, f, p);
      const Interval square = quotient(foot.square(), foot.over());
      if (square.lower > at_most) continue;
      at_most = std::min(at_most, square.upper);
      candidates.push_back({f, square.lower});
    }
  }
  std::erase_if(candidates, [&](const Candidate& c) { return c.at_least > at_most; });
  const auto before = [](const Feature& a, const Feature& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
  };
  Feature best = candidates.front().feature;
  std::optional<Foot<BigDyadic>> foot;
  for (const Candidate& c : candidates) {
    if (c.feature == best) continue;
    if (!foot) foot = foot_on_chain<BigDyadic>(chains, best, p);
    Foot<BigDyadic> other = foot_on_chain<BigDyadic>(chains, c.feature, p);
    const Sign s = compare_feet(other, *foot);
    if (s == Sign::positive || (s == Sign::zero && !before(c.feature, best))) continue;
    best = c.feature;
    foot = std::move(other);
  }
  return best;
}

/// Points a, b, p, and c, d, e of a plane: the side of ab on which p lies as seen along the plane's normal.
struct SideInPlane {
  static constexpr std::string_view name = "closest_points";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    using namespace predicates;
    return dot(cross(difference(p, 0, 1), difference(p, 0, 2)), cross(difference(p, 3, 4), difference(p, 3, 5)));
  }
};

/// Does p project into the polygon, strictly?  Edges are counted that cross the ray from there across c's way to d, in
/// the plane of c, d and e.
bool projects_into(const ChainCorners<Point3>& chains, const std::array<std::size_t, 3>& span, const Point3& p) {
  const Point3 &c = chains.corners[span[0]], &d = chains.corners[span[1]], &e = chains.corners[span[2]];
  bool odd = false;
  for (std::size_t k = 0; k + 1 < chains.first.size(); ++k) {
    for (std::uint32_t i = chains.first[k]; i < chains.first[k + 1]; ++i) {
      const Point3 &a = chains.corners[i], &b = chains.corners[chains.next(k, i)];
      const auto is_above = [&](const Point3& v) {
        return sign_of(predicates::OrderAlongLine3d{}, v, p, c, d) == Sign::positive;
      };
      const bool rises = is_above(b);
      if (is_above(a) == rises) continue;
      if (sign_of(SideInPlane{}, a, b, p, c, d, e) == (rises ? Sign::positive : Sign::negative)) odd = !odd;
    }
  }
  return odd;
}

}  // namespace

template <class Polygon>
struct NearestOfPolygon2 {
  static Feature feature(const Polygon& s, const Point2& p) {
    if (locate(s, p) == Location::inside) return {FeatureKind::face, 0};
    return nearest_on_chains(chain_corners(s), p);
  }
  template <class T>
  static Foot<T> foot(const Polygon& s, const Point2& p, const Feature& f) {
    if (f.kind == FeatureKind::face) return foot_of_itself(vec<T>(p));
    return foot_on_chain<T>(chain_corners(s), f, p);
  }
};
template <>
struct Nearest<Quadrilateral2> : NearestOfPolygon2<Quadrilateral2> {};
template <>
struct Nearest<Polygon2> : NearestOfPolygon2<Polygon2> {};
template <>
struct Nearest<HoledPolygon2> : NearestOfPolygon2<HoledPolygon2> {};

template <class Polygon>
struct NearestOfPolygon3 {
  static void require_some(std::string_view function, const Polygon& s) {
    require_planar(function, spoken(view_of(s)), plane_of_points(chain_corners(s).corners));
  }
  static Feature feature(const Polygon& s, const Point3& p) {
    const auto chains = chain_corners(s);
    const PlaneOfPoints plane = plane_of_points(chains.corners);
    const Feature on_chain = nearest_on_chains(chains, p);
    if (plane.dimension < 2 || !projects_into(chains, plane.span, p)) return on_chain;
    // The foot may lie on a chain; then it is as near as the plane is.
    const Foot<BigDyadic> chain = foot_on_chain<BigDyadic>(chains, on_chain, p);
    const Feature face{FeatureKind::face, 0};
    return compare_feet(chain, foot<BigDyadic>(s, p, face)) == Sign::zero ? on_chain : face;
  }
  template <class T>
  static Foot<T> foot(const Polygon& s, const Point3& p, const Feature& f) {
    const auto chains = chain_corners(s);
    if (f.kind != FeatureKind::face) return foot_on_chain<T>(chains, f, p);
    const auto [i, j, k] = plane_of_points(chains.corners).span;
    const Vec<T> a = vec<T>(chains.corners[i]), q = vec<T>(p);
    const Vec<T> n = cross(vec<T>(chains.corners[j]) - a, vec<T>(chains.corners[k]) - a);
    return foot_on_plane(n, dot(n, q - a), q);
  }
};
template <>
struct Nearest<Quadrilateral3> : NearestOfPolygon3<Quadrilateral3> {};
template <>
struct Nearest<Polygon3> : NearestOfPolygon3<Polygon3> {};
template <>
struct Nearest<HoledPolygon3> : NearestOfPolygon3<HoledPolygon3> {};

}  // namespace query

PLUMB_CLOSEST_FLAT(Closest2, Point2, Quadrilateral2)
PLUMB_CLOSEST_FLAT(Closest2, Point2, Polygon2)
PLUMB_CLOSEST_FLAT(Closest2, Point2, HoledPolygon2)
PLUMB_CLOSEST_FLAT(Closest, Point3, Quadrilateral3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Polygon3)
PLUMB_CLOSEST_FLAT(Closest, Point3, HoledPolygon3)

}  // namespace plumb
