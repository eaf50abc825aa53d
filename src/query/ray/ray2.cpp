// A shape of the plane with straight edges is hit where one of them is first, or where the ray begins inside.  Circles and
// capsules are asked as the balls and capsules about them, oriented boxes as rectangles, k-DOPs as those of space: the
// plane z = 0 rounds nothing.
#include "plumb/query/ray/ray2.hpp"

#include <cmath>
#include <vector>

#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/body/chain_edges.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/in_space.hpp"
#include "query/ray/answers.hpp"

namespace plumb::query {
namespace {

using plumb::in_space;

/// The ray in z = 0.
AnyRay in_space(const AnyRay2& r) {
  if (r.kind == AnyRay::Kind::segment) return Segment3{plumb::in_space(r.origin), plumb::in_space(r.end)};
  const Vector3 direction{r.direction.x, r.direction.y, 0};
  if (r.kind == AnyRay::Kind::line) return Line3{plumb::in_space(r.origin), direction};
  return Ray3{plumb::in_space(r.origin), direction};
}

/// Throws as query/body/figure_input.hpp says.
template <class Shape>
void require_ray2(std::string_view function, const AnyRay2& ray, const Shape& s) {
  switch (ray.kind) {
    case AnyRay::Kind::ray:
      return require_figures(function, Ray2{ray.origin, ray.direction}, s);
    case AnyRay::Kind::segment:
      return require_figures(function, Segment2{ray.origin, ray.end}, s);
    default:
      return require_figures(function, Line2{ray.origin, ray.direction}, s);
  }
}

template <class T>
T area(const Vec3<T>& u, const Vec3<T>& v) {
  return u.x * v.y - u.y * v.x;
}

/// The edges that the line may meet, each a facet of two corners; a decision's normal is 2 times an edge's place in the
/// list, plus 1 where the edge runs to the left across the ray.
struct EdgesModel {
  template <class Shape>
  EdgesModel(const AnyRay& ray, const Shape& s) {
    if (!is_nothing(s)) edges = chain_edges(s);
    const ShotLine<Approximate> line(ray);
    std::erase_if(edges, [&](const ChainEdge& e) {
      RaySigns ask;
      const Sign from = ask(area(line.direction, line.from_origin(e.shape.a)));
      const Sign to = ask(area(line.direction, line.from_origin(e.shape.b)));
      return ask.certain() && from == to && from != Sign::zero;
    });
  }
  std::vector<ChainEdge> edges;

  [[nodiscard]] std::uint32_t facets() const { return static_cast<std::uint32_t>(edges.size()); }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t i) const {
    const auto& [shape, from, to, whole] = edges[i];
    const Vec3<T> a = line.from_origin(shape.a), b = line.from_origin(shape.b);
    return {2, {a, b, a, b}, {from, to, from, to}, {whole.index, whole.index}, 0};
  }
  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns& ask) const {
    return facet_time<T>(line, *this, when, ask);
  }
  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const {
    const Vec3<T>& d = line.direction;
    Earliest<T> earliest;
    if (has_no_direction(line.ray)) {
      earliest.found = Candidate<T>{time_zero<T>(), {}, {}};
    } else {
      for (std::uint32_t i = 0; i < facets(); ++i) meet_edge(line, facet(line, i), i, 0, earliest, ask);
    }
    if (!earliest.found) return {};
    const auto& [time, when, known] = *earliest.found;
    const When at_or_zero = ask(time.numerator) == Sign::zero ? When{} : when;
    const Vec3<T> p = times(d, time.numerator);
    std::optional<Decided> first;
    for (std::uint32_t i = 0; i < facets(); ++i) {
      const Facet<T> f = facet(line, i);
      const auto at = corner_or_edge(f, p, time.denominator, ask);
      if (!at) continue;
      if (!first) first = Decided{at_or_zero, *at, false, 0};
      if (std::pair(at->kind, at->index) < std::pair(first->feature.kind, first->feature.index)) first->feature = *at;
      if (first->has_normal) continue;
      const Sign across = ask(area(d, f.corners[1] - f.corners[0]));
      if (across != Sign::zero) first->has_normal = true, first->normal = 2 * i + (across == Sign::positive ? 1 : 0);
    }
    return first;
  }
  /// At right angles to the edge, against the ray.
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    const Segment3& e = edges[decided.normal / 2].shape;
    const Vec3<T> along = decided.normal % 2 == 0 ? between<T>(e.a, e.b) : between<T>(e.b, e.a);
    return still_normal(Vec3<T>{along.y, T(0.0) - along.x, T(0.0)});
  }
  void know(const Decided& decided, Known& known) const {
    for (const auto& [shape, from, to, whole] : edges) {
      const auto& [a, b] = shape;
      if (decided.feature == Feature{FeatureKind::vertex, from}) known[0] = a.x, known[1] = a.y;
      if (decided.feature == Feature{FeatureKind::vertex, to}) known[0] = b.x, known[1] = b.y;
      if (decided.feature == whole && a.x == b.x) known[0] = a.x;
      if (decided.feature == whole && a.y == b.y) known[1] = a.y;
    }
  }
};

/// Rounded once: doubling is exact, before or after.
double twice_product(double half, double x) {
  const double h = std::fabs(half);
  return h < 1 ? h * 2 * x : h * x * 2;
}

/// Perpendicular to the first edge that holds the point and that the ray does not run along: only its axis matters.
Vector2 normal_of(const AnyRay& ray, const Obb2& box, const Feature& at) {
  const bool corner = at.kind == FeatureKind::vertex;
  for (const std::uint32_t axis : {0u, 1u}) {
    if (!corner && at.index / 2 != axis) continue;
    const double half = axis == 0 ? box.half.x : box.half.y;
    const Vector2& along = box.axes[axis];
    const Sign across = certainly<RayWorlds>(
        [&]<class T>(RayWorld<T>& ask) { return ask(area(direction_of<T>(ray), vector_of<T>(in_space(along)))); });
    if (half == 0 || across == Sign::zero) continue;
    const double way = across == Sign::positive ? -1 : 1;
    return {way * twice_product(half, along.y) + 0.0, -way * twice_product(half, along.x) + 0.0};
  }
  return {0, 0};
}

template <class Shape>
inline constexpr bool is_lifted = is_one_of(figure_kind<Shape>, {FigureKind::ball, FigureKind::capsule, FigureKind::obb,
                                                                 FigureKind::k_dop});
/// What has faces in space has edges in the plane.
template <class Shape>
inline constexpr bool has_faces_lifted = is_lifted<Shape> && !std::is_same_v<Shape, Obb2>;

/// Asked of what space does not tell: what begins inside something straight, which has no normal there.
template <class Shape>
bool begins_inside(const AnyRay2& ray, const Shape& s) {
  if constexpr (has_faces_lifted<Shape> || std::is_same_v<Shape, Segment2>) {
    return false;
  } else {
    const AnyRay lifted = in_space(ray);
    return (begins(lifted) || has_no_direction(lifted)) && locate(s, ray.origin) == Location::inside;
  }
}

/// As it is asked in space: what is straight by its edges.
template <class Answer, class Shape>
std::optional<Answer> answer_in_space(const AnyRay& ray, const Shape& s) {
  if constexpr (!is_lifted<Shape>) {
    return answer_of_model<Answer>(ray, EdgesModel(ray, s));
  } else if constexpr (std::is_same_v<Answer, Hit>) {
    return plumb::first_hit(ray, in_space(s));
  } else {
    return plumb::first_hit_parameter(ray, in_space(s));
  }
}

}  // namespace

template <class Shape>
std::optional<Hit2> RayAnswers2<Shape>::first_hit(const AnyRay2& ray, const Shape& s) {
  require_ray2("first_hit", ray, s);
  if (begins_inside(ray, s)) return Hit2{0, {ray.origin.x + 0.0, ray.origin.y + 0.0}, {FeatureKind::face, 0}, {0, 0}};
  const AnyRay lifted = in_space(ray);
  const auto hit = answer_in_space<Hit>(lifted, s);
  if (!hit) return {};
  Hit2 flat{hit->t, {hit->point.x, hit->point.y}, hit->feature, {hit->normal.x, hit->normal.y}};
  if constexpr (has_faces_lifted<Shape>) {
    flat.feature.kind = hit->feature.kind == FeatureKind::interior ? FeatureKind::face : FeatureKind::edge;
  } else if constexpr (is_lifted<Shape>) {
    flat.normal = normal_of(lifted, s, hit->feature);
  }
  return flat;
}
template <class Shape>
std::optional<RayParameter> RayAnswers2<Shape>::first_hit_parameter(const AnyRay2& ray, const Shape& s) {
  require_ray2("first_hit_parameter", ray, s);
  if (!is_lifted<Shape> && begins_inside(ray, s)) return RayParameter{Rational(0.0)};
  return answer_in_space<RayParameter>(in_space(ray), s);
}
template <class Shape>
bool RayAnswers2<Shape>::hits(const AnyRay2& ray, const Shape& s) {
  require_ray2("hits", ray, s);
  if constexpr (is_lifted<Shape>) {
    return plumb::hits(in_space(ray), in_space(s));
  } else {
    return begins_inside(ray, s) || answer_in_space<Decided>(in_space(ray), s).has_value();
  }
}

template struct RayAnswers2<Segment2>;
template struct RayAnswers2<Triangle2>;
template struct RayAnswers2<Aabb2>;
template struct RayAnswers2<Quadrilateral2>;
template struct RayAnswers2<Polygon2>;
template struct RayAnswers2<HoledPolygon2>;
template struct RayAnswers2<Circle2>;
template struct RayAnswers2<Capsule2>;
template struct RayAnswers2<Obb2>;
template struct RayAnswers2<KDop2>;

}  // namespace plumb::query
