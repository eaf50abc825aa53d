// Polygons in space, of any chains in one plane, with holes or without; quadrilaterals are polygons of four corners.
//
// Beside its chains a point is inside where they wind around it an odd number of times: where a line through it, moved
// as by the half-open rule, goes through an odd number of the triangles that fan out from the first vertex of each
// chain.  In its plane a ray that begins outside enters at an edge.
#include <vector>

#include "figure/basic/plane_of_points.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "query/body/chain_edges.hpp"
#include "query/ray/answers.hpp"

namespace plumb::query {
namespace {

/// Facet i is edge i, of two corners.
struct PolygonModel {
  ChainCorners<Point3> chains;
  PlaneOfPoints plane;
  bool holds_origin = false;  // of the ray, which begins there

  [[nodiscard]] std::uint32_t edges() const { return static_cast<std::uint32_t>(chains.corners.size()); }

  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t i) const {
    const std::uint32_t j = chains.next(i);
    const Vec3<T> a = line.from_origin(chains.corners[i]), b = line.from_origin(chains.corners[j]);
    return {2, {a, b, a, b}, {i, j, i, j}, {i, i, i, i}, 0};
  }
  template <class T>
  [[nodiscard]] Vec3<T> plane_normal() const {
    const auto& [a, b, c] = plane.span;
    if (plane.dimension < 2) return vector_of<T>(Vector3{0, 0, 0});
    return cross(between<T>(chains.corners[a], chains.corners[b]), between<T>(chains.corners[a], chains.corners[c]));
  }
  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns& ask) const {
    if (meeting_of(when) != Meeting::plane) return facet_time<T>(line, *this, when, ask);
    const Vec3<T> n = plane_normal<T>();
    return {dot(line.from_origin(chains.corners[plane.span[0]]), n), dot(line.direction, n)};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided&, RaySigns&) const {
    return still_normal(plane_normal<T>());
  }
  void know(const Decided& decided, Known& known) const {
    if (decided.feature.kind != FeatureKind::vertex) return;
    const Point3& v = chains.corners[decided.feature.index];
    known = {v.x, v.y, v.z};
  }
  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const;
};

/// The lowest vertex, else the lowest edge that holds the point p / w, seen from the origin.
template <class T>
std::optional<Feature> rim(const ShotLine<T>& line, const PolygonModel& model, const Vec3<T>& p, const T& w,
                           RaySigns& ask) {
  std::optional<Feature> found;
  for (std::uint32_t i = 0; i < model.edges(); ++i) {
    const auto f = corner_or_edge(model.facet(line, i), p, w, ask);
    if (f && (!found || std::pair(f->kind, f->index) < std::pair(found->kind, found->index))) found = f;
  }
  return found;
}

/// For a line that is not parallel to the plane.
template <class T>
bool winds_oddly(const ShotLine<T>& line, const PolygonModel& model, RaySigns& ask) {
  bool odd = false;
  for (std::size_t chain = 0; chain + 1 < model.chains.first.size(); ++chain) {
    const std::uint32_t start = model.chains.first[chain];
    const Vec3<T> a = line.from_origin(model.chains.corners[start]);
    Vec3<T> b = line.from_origin(model.chains.corners[start + 1]);
    for (std::uint32_t i = start + 2; i < model.chains.first[chain + 1]; ++i) {
      const Vec3<T> c = line.from_origin(model.chains.corners[i]);
      odd ^= passes_perturbed(Facet<T>{3, {a, b, c, a}, {}, {}, 0}, line.direction, ask);
      b = c;
    }
  }
  return odd;
}

/// Does the line pass the line of some edge, or is that in doubt?
template <class T>
bool may_pass_rim(const ShotLine<T>& line, const PolygonModel& model) {
  for (std::uint32_t i = 0; i < model.edges(); ++i) {
    const Facet<T> f = model.facet(line, i);
    RaySigns alone;
    if (alone(edge_side(line.direction, f.corners[0], f.corners[1])) == Sign::zero || !alone.certain()) return true;
  }
  return false;
}

template <class T>
Decided polygon_at_origin(const ShotLine<T>& line, const PolygonModel& model, RaySigns& ask) {
  const Vec3<T> p{T(0.0), T(0.0), T(0.0)};
  return {{}, rim(line, model, p, T(1.0), ask).value_or(Feature{FeatureKind::face, 0}), true, 0};
}

template <class T>
std::optional<Decided> PolygonModel::decide(const ShotLine<T>& line, RaySigns& ask) const {
  const AnyRay& ray = line.ray;
  if (holds_origin) return polygon_at_origin(line, *this, ask);
  if (has_no_direction(ray)) return {};
  const Vec3<T>&d = line.direction, n = plane_normal<T>();
  const T slope = dot(d, n), above = dot(line.from_origin(chains.corners[plane.span[0]]), n);
  const Sign way = ask(slope);
  if (way != Sign::zero) {
    const Time<T> time = with_positive_denominator(above, slope, way);
    if (!in_range(ray, time, ask)) return {};
    Feature feature{FeatureKind::face, 0};
    const auto on_rim =
        may_pass_rim(line, *this) ? rim(line, *this, times(d, time.numerator), time.denominator, ask) : std::nullopt;
    if (on_rim) {
      feature = *on_rim;
    } else if (!winds_oddly(line, *this, ask)) {
      return {};
    }
    const bool at_zero = ask(above) == Sign::zero;
    return Decided{{at_zero ? When::At::zero : When::At::quotient, 0, part_of(Meeting::plane, 0)}, feature, true, 0};
  }
  if (ask(above) != Sign::zero) return {};
  Earliest<T> earliest;
  for (std::uint32_t i = 0; i < edges(); ++i) meet_edge(line, facet(line, i), i, 0, earliest, ask);
  if (!earliest.found) return {};
  const auto& [time, when, known] = *earliest.found;
  const auto feature = rim(line, *this, times(d, time.numerator), time.denominator, ask);
  return Decided{when, feature.value_or(Feature{FeatureKind::edge, when.index}), true, 0};
}

template <class Polygon>
PolygonModel polygon_model(const Polygon& polygon, const RayQuestion& asked) {
  const auto& [function, ray] = asked;
  PolygonModel model{chain_corners(polygon), {}};
  model.plane = plane_of_points(model.chains.corners);
  require_planar(function, std::is_same_v<Polygon, Quadrilateral3> ? "quadrilateral" : "polygon", model.plane);
  model.holds_origin = (begins(ray) || has_no_direction(ray)) && contains(polygon, ray.origin);
  return model;
}

}  // namespace

template <class Polygon, class F>
requires(is_one_of(figure_kind<Polygon>, polygon_kinds)) auto with_model(const Polygon& polygon,
                                                                         const RayQuestion& asked, const F& f) {
  return f(polygon_model(polygon, asked));
}

template struct RayAnswers<Quadrilateral3>;
template struct RayAnswers<Polygon3>;
template struct RayAnswers<HoledPolygon3>;

}  // namespace plumb::query
