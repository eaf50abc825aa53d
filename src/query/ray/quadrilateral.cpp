// Quadrilaterals in a plane: convex or not, of edges that may cross, of corners that may be equal or on one line.
//
// Beside its chain a point is inside where the chain winds around it an odd number of times: where it is in one of the
// triangles abc and acd, by the half-open rule, and not in both.
#include "figure/basic/plane_of_points.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/predicates.hpp"
#include "query/ray/answers.hpp"

namespace plumb::query {
namespace {

constexpr std::array<std::array<std::size_t, 3>, 4> triples{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};

struct QuadrilateralModel {
  const Quadrilateral3& quadrilateral;
  std::size_t triple;  // which of the corners span the plane

  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t) const {
    const auto& [a, b, c, d] = quadrilateral;
    return {4,
            {line.from_origin(a), line.from_origin(b), line.from_origin(c), line.from_origin(d)},
            {0, 1, 2, 3},
            {0, 1, 2, 3},
            0};
  }
  template <class T>
  [[nodiscard]] Vec3<T> plane_normal(const Facet<T>& f) const {
    const auto& [p, q, r] = triples[triple];
    return cross(f.corners[q] - f.corners[p], f.corners[r] - f.corners[p]);
  }
  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns& ask) const {
    if (meeting_of(when) != Meeting::plane) return facet_time<T>(line, *this, when, ask);
    const Facet<T> f = facet(line, 0);
    const Vec3<T> n = plane_normal(f);
    return {dot(f.corners[0], n), dot(line.direction, n)};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided&, RaySigns&) const {
    return still_normal(plane_normal(facet(line, 0)));
  }
  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const;
};

/// Does the line, not parallel to the plane, pass strictly between the edges of a convex one?
template <class T>
bool passes_convex(const Facet<T>& f, const Vec3<T>& direction) {
  RaySigns ask;
  const Sign first = ask(edge_side(direction, f.corners[0], f.next(0)));
  bool same = first != Sign::zero;
  for (std::size_t i = 1; i < 4 && same; ++i) same = ask(edge_side(direction, f.corners[i], f.next(i))) == first;
  return same && ask.certain();
}

/// The point p / w is in the plane: the feature that holds it.
template <class T>
std::optional<Feature> hold(const Facet<T>& f, const Vec3<T>& direction, const Vec3<T>& p, const T& w, RaySigns& ask) {
  if (passes_convex(f, direction)) return Feature{FeatureKind::face, 0};
  if (const auto feature = corner_or_edge(f, p, w, ask)) return feature;
  const auto& [a, b, c, d] = f.corners;
  const Facet<T> abc{3, {a, b, c, a}, {}, {}, 0}, acd{3, {a, c, d, a}, {}, {}, 0};
  if (passes_perturbed(abc, direction, ask) == passes_perturbed(acd, direction, ask)) return {};
  return Feature{FeatureKind::face, 0};
}

/// The ray begins in the quadrilateral, in its plane.
template <class T>
Decided decided_at_origin(const Facet<T>& f, RaySigns& ask) {
  const Vec3<T> p{T(0.0), T(0.0), T(0.0)};
  return {{}, corner_or_edge(f, p, T(1.0), ask).value_or(Feature{FeatureKind::face, 0}), true, 0};
}

template <class T>
std::optional<Decided> QuadrilateralModel::decide(const ShotLine<T>& line, RaySigns& ask) const {
  const AnyRay& ray = line.ray;
  const Facet<T> f = facet(line, 0);
  const Vec3<T>&d = line.direction, n = plane_normal(f);
  if (has_no_direction(ray)) {
    if (!contains(quadrilateral, ray.origin)) return {};
    return decided_at_origin(f, ask);
  }
  const T slope = dot(d, n), above = dot(f.corners[0], n);
  const Sign way = ask(slope);
  if (way != Sign::zero) {
    const Time<T> time = with_positive_denominator(above, slope, way);
    if (!in_range(ray, time, ask)) return {};
    const std::optional<Feature> feature = hold(f, d, times(d, time.numerator), time.denominator, ask);
    if (!feature) return {};
    const bool at_zero = ask(above) == Sign::zero;
    return Decided{{at_zero ? When::At::zero : When::At::quotient, 0, part_of(Meeting::plane, 0)}, *feature, true, 0};
  }
  if (ask(above) != Sign::zero) return {};  // of all corners on one line both are zero
  if (begins(ray) && contains(quadrilateral, ray.origin)) return decided_at_origin(f, ask);
  Earliest<T> earliest;
  for (std::size_t i = 0; i < 4; ++i) meet_edge(line, f, 0, i, earliest, ask);
  if (!earliest.found) return {};
  const auto& [time, when, inside] = *earliest.found;
  const auto feature = corner_or_edge(f, times(d, time.numerator), time.denominator, ask);
  return Decided{when, feature.value_or(Feature{FeatureKind::edge, when.part & 3u}), true, 0};
}

/// The first three corners that are not on one line, else any.
std::size_t spanning(const Quadrilateral3& quadrilateral) {
  const auto& [a, b, c, d] = quadrilateral;
  const std::array<Point3, 4> at{a, b, c, d};
  for (std::size_t i = 0; i < triples.size(); ++i) {
    const auto& [p, q, r] = triples[i];
    const bool collinear = certainly<RayWorlds>([&, p = p, q = q, r = r]<class T>(RayWorld<T>& ask) {
      return is_zero(cross(between<T>(at[p], at[q]), between<T>(at[p], at[r])), ask);
    });
    if (!collinear) return i;
  }
  return 0;
}

}  // namespace

template <class F>
auto with_model(const Quadrilateral3& q, const RayQuestion& asked, const F& f) {
  if (orient3d(q.a, q.b, q.c, q.d) != Sign::zero)
    require_planar(asked.function, "quadrilateral", plane_of_points(std::array{q.a, q.b, q.c, q.d}));
  return f(QuadrilateralModel{q, spanning(q)});
}

template struct RayAnswers<Quadrilateral3>;

}  // namespace plumb::query
