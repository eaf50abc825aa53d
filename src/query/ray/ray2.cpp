// A shape of the plane with straight edges is hit where one of them is first, or where the ray begins inside.  Circles and
// capsules are asked as the balls and capsules about them, oriented boxes as rectangles, k-DOPs as those of space: the
// plane z = 0 rounds nothing.
#include "plumb/query/ray/ray2.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "figure/basic/in_space.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/body/boundary.hpp"
#include "query/body/figure_input.hpp"
#include "query/ray/numbers.hpp"

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

struct Edge2 {
  Point2 a, b;
  std::uint32_t at_a, at_b, number;
};

template <class Shape>
std::vector<Edge2> edges_of(const Shape& s) {
  struct Heard {
    std::vector<Point2> corners;
    std::vector<Edge2> edges;

    void corner(const arith::Vec<double>& p) { corners.push_back({p.x, p.y}); }
    void edge(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
      edges.push_back({corners[from], corners[to], from, to, number});
    }
    void face(std::span<const std::uint32_t>, std::uint32_t) {}
  } heard;
  heard.corners.reserve(4), heard.edges.reserve(4);
  if (!is_nothing(s)) tell_boundary<double>(s, heard);
  return std::move(heard.edges);
}

template <class T>
T area(const Vec3<T>& u, const Vec3<T>& v) {
  return u.x * v.y - u.y * v.x;
}

/// Met where the line crosses it, or, along it, at its ends a and b; its vertices 0 and 1, its edge 0.
struct EdgeModel {
  enum : std::uint32_t { crossing, at_a, at_b };
  const Edge2& e;

  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns&) const {
    const Vec3<T>& d = line.direction;
    if (when.part != crossing) {
      const Vec3<T> end = line.from_origin(in_space(when.part == at_a ? e.a : e.b));
      return {dot(end, d), dot(d, d)};
    }
    const Vec3<T> along = between<T>(in_space(e.a), in_space(e.b));
    return {area(line.from_origin(in_space(e.a)), along), area(d, along)};
  }
  /// Perpendicular, against a ray across which the edge runs to the right (0) or to the left (1).
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    const Vec3<T> along = between<T>(in_space(e.a), in_space(e.b));
    const T zero(0.0);
    return still_normal(decided.normal == 0 ? Vec3<T>{along.y, zero - along.x, zero}
                                            : Vec3<T>{zero - along.y, along.x, zero});
  }
  void know(const Decided& decided, Known& known) const {
    if (decided.feature.kind == FeatureKind::vertex) {
      const Point2& v = decided.feature.index == 0 ? e.a : e.b;
      known[0] = v.x, known[1] = v.y;
    } else {
      if (e.a.x == e.b.x) known[0] = e.a.x;
      if (e.a.y == e.b.y) known[1] = e.a.y;
    }
  }
};

/// `across` is positive where the edge runs to the left across the ray, zero where along it.
Decided met(When::At at, std::uint32_t part, const Feature& feature, Sign across) {
  return {{at, 0, part}, feature, across != Sign::zero, across == Sign::positive ? 1u : 0u};
}

constexpr Feature inside_edge{FeatureKind::edge, 0};
constexpr Feature end(std::uint32_t i) { return {FeatureKind::vertex, i}; }

/// The ray runs along the edge's line.
template <class T>
std::optional<Decided> decide_along(const AnyRay& ray, const EdgeModel& model, RaySigns& ask) {
  const ShotLine<T> line(ray);
  const Vec3<T>& d = line.direction;
  const Vec3<T> p = line.from_origin(in_space(model.e.a)), q = line.from_origin(in_space(model.e.b));
  const bool ahead = ask(dot(between<T>(in_space(model.e.a), in_space(model.e.b)), d)) != Sign::negative;
  const std::uint32_t near = ahead ? 0 : 1, far = 1 - near;
  const Sign first = ask(dot(ahead ? p : q, d)), last = ask(dot(ahead ? q : p, d));
  if (begins(ray) && first == Sign::negative) {
    if (last == Sign::negative) return {};
    return met(When::At::zero, 0, last == Sign::zero ? end(far) : inside_edge, Sign::zero);
  }
  const When when{When::At::quotient, 0, ahead ? EdgeModel::at_a : EdgeModel::at_b};
  if (!in_range(ray, model.time(line, when, ask), ask)) return {};
  return met(first == Sign::zero ? When::At::zero : when.at, when.part, end(near), Sign::zero);
}

template <class T>
std::optional<Decided> decide_edge(const AnyRay& ray, const EdgeModel& model, RaySigns& ask) {
  const ShotLine<T> line(ray);
  const Vec3<T>& d = line.direction;
  const Vec3<T> p = line.from_origin(in_space(model.e.a)), q = line.from_origin(in_space(model.e.b));
  if (has_no_direction(ray)) {
    if (ask(area(p, q)) != Sign::zero || ask(dot(p, q)) == Sign::positive) return {};
    const bool at_a = ray.origin == in_space(model.e.a), at_b = ray.origin == in_space(model.e.b);
    return met(When::At::zero, 0, at_a ? end(0) : at_b ? end(1) : inside_edge, Sign::zero);
  }
  const Sign a = ask(area(d, p)), b = ask(area(d, q));  // on which side of the line
  if (a == b) return a == Sign::zero ? decide_along<T>(ray, model, ask) : std::nullopt;
  const Sign across = b == Sign::positive || a == Sign::negative ? Sign::positive : Sign::negative;
  const When when{When::At::quotient, 0, EdgeModel::crossing};
  const Time<T> crossing = model.time(line, when, ask);
  const Time<T> time = with_positive_denominator(crossing.numerator, crossing.denominator, across);
  if (!in_range(ray, time, ask)) return {};
  const bool at_zero = ask(time.numerator) == Sign::zero;
  const Feature feature = a == Sign::zero ? end(0) : b == Sign::zero ? end(1) : inside_edge;
  return met(at_zero ? When::At::zero : when.at, when.part, feature, across);
}

Feature feature_of(const Edge2& e, const Feature& f) {
  if (f.kind == FeatureKind::edge) return {f.kind, e.number};
  return {f.kind, f.index == 0 ? e.at_a : e.at_b};
}

std::optional<Decided> decided(const AnyRay& ray, const EdgeModel& model) {
  return certainly<RayWorlds>([&]<class T>(RayWorld<T>& signs) { return decide_edge<T>(ray, model, signs); });
}

/// Which edges are hit first, and where.
class FirstEdge {
 public:
  explicit FirstEdge(const AnyRay2& ray) : ray_(in_space(ray)) {}

  void ask(const Edge2& e) {
    const EdgeModel model{e};
    const auto edge = decided(ray_, model);
    if (!edge) return;
    const Hit at = numbers_of(ray_, model, *edge);
    const Hit2 hit{at.t, {at.point.x, at.point.y}, feature_of(e, at.feature), {at.normal.x, at.normal.y}};
    const int order = found_ ? compare(hit, model, *edge) : -1;
    if (order > 0) return;
    if (order < 0) {
      found_ = hit, edge_ = e, decided_ = *edge;
      return;
    }
    const auto rank = [](const Feature& f) { return std::tuple(f.kind, f.index); };
    if (rank(hit.feature) < rank(found_->feature)) found_->feature = hit.feature;
    if (found_->normal == Vector2{0, 0}) found_->normal = hit.normal;
  }
  [[nodiscard]] const std::optional<Hit2>& hit() const { return found_; }
  [[nodiscard]] std::optional<RayParameter> parameter() const {
    if (!found_) return {};
    return parameter_of(ray_, EdgeModel{edge_}, decided_);
  }

 private:
  /// Rounding keeps order.
  [[nodiscard]] int compare(const Hit2& hit, const EdgeModel& model, const Decided& decided) const {
    if (hit.t != found_->t) return hit.t < found_->t ? -1 : 1;
    const bool corners = hit.feature.kind == FeatureKind::vertex && found_->feature.kind == FeatureKind::vertex;
    if (corners && hit.point == found_->point) return 0;
    const auto order = parameter_of(ray_, model, decided) <=> *parameter();
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }

  AnyRay ray_;
  std::optional<Hit2> found_;
  Edge2 edge_{};
  Decided decided_{};
};

template <class Shape>
FirstEdge first_edge(const AnyRay2& ray, const Shape& s) {
  FirstEdge first(ray);
  for (const Edge2& e : edges_of(s)) first.ask(e);
  return first;
}

KDop3 in_space(const KDop2& k_dop) {
  std::vector<Vector3> directions;
  for (const Vector2& d : k_dop.directions.all()) directions.push_back(plumb::in_space(d));
  return {Directions3(directions), k_dop.min, k_dop.max};
}
/// The box is a rectangle of the plane z = 0.
Rectangle3 in_space(const Obb2& b) { return {in_space(b.center), {in_space(b.axes[0]), in_space(b.axes[1])}, b.half}; }

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

/// Of what has faces in space the feature and the normal are those of there.
template <class Shape>
std::optional<Hit2> hit_lifted(const AnyRay& ray, const Shape& s) {
  const auto hit = plumb::first_hit(ray, in_space(s));
  if (!hit) return {};
  Hit2 flat{hit->t, {hit->point.x, hit->point.y}, hit->feature, {hit->normal.x, hit->normal.y}};
  if constexpr (has_faces_lifted<Shape>) {
    flat.feature.kind = hit->feature.kind == FeatureKind::interior ? FeatureKind::face : FeatureKind::edge;
  } else {
    flat.normal = normal_of(ray, s, hit->feature);
  }
  return flat;
}

}  // namespace

template <class Shape>
std::optional<Hit2> RayAnswers2<Shape>::first_hit(const AnyRay2& ray, const Shape& s) {
  require_ray2("first_hit", ray, s);
  if (begins_inside(ray, s)) return Hit2{0, {ray.origin.x + 0.0, ray.origin.y + 0.0}, {FeatureKind::face, 0}, {0, 0}};
  if constexpr (is_lifted<Shape>) {
    return hit_lifted(in_space(ray), s);
  } else {
    return first_edge(ray, s).hit();
  }
}
template <class Shape>
std::optional<RayParameter> RayAnswers2<Shape>::first_hit_parameter(const AnyRay2& ray, const Shape& s) {
  require_ray2("first_hit_parameter", ray, s);
  if constexpr (is_lifted<Shape>) {
    return plumb::first_hit_parameter(in_space(ray), in_space(s));
  } else {
    return begins_inside(ray, s) ? RayParameter{Rational(0.0)} : first_edge(ray, s).parameter();
  }
}
template <class Shape>
bool RayAnswers2<Shape>::hits(const AnyRay2& ray, const Shape& s) {
  require_ray2("hits", ray, s);
  const AnyRay lifted = in_space(ray);
  if constexpr (is_lifted<Shape>) {
    return plumb::hits(lifted, in_space(s));
  } else {
    return begins_inside(ray, s) ||
           std::ranges::any_of(edges_of(s), [&](const Edge2& e) { return decided(lifted, EdgeModel{e}).has_value(); });
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
