// Planes, halfspaces, k-DOPs and axis-aligned boxes: whose constraints are as given, or those of three points.
#include <span>

#include "plumb/predicates.hpp"
#include "query/ray/answers.hpp"
#include "query/ray/box_feature.hpp"

namespace plumb::query {
namespace {

/// normal . p - offset <= 0, or its opposite.
template <class T>
Linear<T> below(const ShotLine<T>& line, const Vector3& normal, double offset, bool opposite) {
  const Vec3<T> n = vector_of<T>(normal);
  const T constant = dot(vector_of<T>(line.ray.origin), n) - T(offset), slope = dot(line.direction, n), zero(0.0);
  return opposite ? Linear<T>{zero - constant, zero - slope} : Linear<T>{constant, slope};
}

struct HalfspaceModel {
  const Halfspace3& halfspace;

  static std::size_t size() { return 1; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t, RaySigns&) const {
    return below(line, halfspace.normal, halfspace.offset, false);
  }
  static Feature feature(std::span<const std::uint32_t>) { return {FeatureKind::face, 0}; }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided&, RaySigns&) const {
    return still_normal(vector_of<T>(halfspace.normal));
  }
};

struct PlaneModel {
  const Plane3& plane;

  static std::size_t size() { return 2; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    return below(line, plane.normal, plane.offset, i == 1);
  }
  static Feature feature(std::span<const std::uint32_t>) { return {FeatureKind::face, 0}; }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided&, RaySigns&) const {
    return still_normal(vector_of<T>(plane.normal));
  }
};

/// The plane of three points: two constraints; or the line or the place that they are, where every coordinate of
/// (x - a) x along, or of x - a, is zero.
struct PointsModel {
  explicit PointsModel(const ThreePointPlane3& p)
      : plane(p),
        along(p.b == p.a ? p.c : p.b),
        dimension(!collinear(p.a, p.b, p.c) ? 2
                  : along == p.a            ? 0
                                            : 1) {}

  [[nodiscard]] std::size_t size() const { return dimension == 2 ? 2 : 6; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const Vec3<T> from = line.origin_from(plane.a), &d = line.direction;
    T constant(0.0), slope(0.0);
    if (dimension == 2) {
      const Vec3<T> n = plane_normal<T>();
      constant = dot(from, n), slope = dot(d, n);
    } else {
      const Vec3<T> e = between<T>(plane.a, along);
      const Vec3<T> off = dimension == 1 ? cross(from, e) : from, change = dimension == 1 ? cross(d, e) : d;
      const std::uint32_t k = i / 2;
      constant = k == 0 ? off.x : k == 1 ? off.y : off.z;
      slope = k == 0 ? change.x : k == 1 ? change.y : change.z;
    }
    const T zero(0.0);
    return i % 2 == 1 ? Linear<T>{zero - constant, zero - slope} : Linear<T>{constant, slope};
  }
  [[nodiscard]] Feature feature(std::span<const std::uint32_t>) const {
    return {dimension == 2 ? FeatureKind::face : dimension == 1 ? FeatureKind::edge : FeatureKind::vertex, 0};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided&, RaySigns&) const {
    return still_normal(dimension == 2 ? plane_normal<T>() : vector_of<T>(Vector3{0, 0, 0}));
  }
  void know(const Decided&, Known& known) const {
    if (dimension == 0) known = {plane.a.x, plane.a.y, plane.a.z};
  }
  template <class T>
  [[nodiscard]] Vec3<T> plane_normal() const {
    return cross(between<T>(plane.a, plane.b), between<T>(plane.a, plane.c));
  }

  const ThreePointPlane3& plane;
  Point3 along;
  int dimension;
};

struct KDopModel {
  const KDop3& k_dop;

  [[nodiscard]] std::size_t size() const { return 2 * k_dop.directions.size(); }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const std::size_t slab = i / 2;
    const bool upper = i % 2 == 1;
    return below(line, k_dop.directions.all()[slab], upper ? k_dop.max[slab] : k_dop.min[slab], !upper);
  }
  static Feature feature(std::span<const std::uint32_t> tight) { return {FeatureKind::face, tight[0]}; }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    const Vector3& n = k_dop.directions.all()[decided.normal / 2];
    return still_normal(vector_of<T>(decided.normal % 2 == 1 ? n : Vector3{-n.x, -n.y, -n.z}));
  }
};

/// Constraint 2 a is the lower end of axis a, 2 a + 1 the upper one.
struct AabbModel {
  const Aabb3& box;

  [[nodiscard]] double end(std::uint32_t face) const {
    const Point3& p = face % 2 == 1 ? box.max : box.min;
    return face < 2 ? p.x : face < 4 ? p.y : p.z;
  }
  static std::size_t size() { return 6; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const Point3& o = line.ray.origin;
    const double from = i < 2 ? o.x : i < 4 ? o.y : o.z;
    const T& slope = i < 2 ? line.direction.x : i < 4 ? line.direction.y : line.direction.z;
    if (i % 2 == 1) return {coordinate_difference<T>(from, end(i)), slope};
    return {coordinate_difference<T>(end(i), from), T(0.0) - slope};
  }
  static Feature feature(std::span<const std::uint32_t> tight) { return box_feature(tight); }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    const double way = decided.normal % 2 == 1 ? 1 : -1;
    const std::uint32_t axis = decided.normal / 2;
    return still_normal(vector_of<T>(Vector3{axis == 0 ? way : 0.0, axis == 1 ? way : 0.0, axis == 2 ? way : 0.0}));
  }
  void know(const Decided& decided, Known& known) const {
    if (decided.when.at != When::At::quotient) return;
    const std::uint32_t face = decided.when.index;
    known[face / 2] = end(face);
    if (decided.feature.kind == FeatureKind::vertex) {
      for (std::uint32_t axis = 0; axis < 3; ++axis) known[axis] = end(2 * axis + (decided.feature.index >> axis & 1));
    }
  }
};

}  // namespace

template <class F>
auto with_model(const Plane3& plane, const RayQuestion&, const F& f) {
  return f(PlaneModel{plane});
}
template <class F>
auto with_model(const ThreePointPlane3& plane, const RayQuestion&, const F& f) {
  return f(PointsModel(plane));
}
template <class F>
auto with_model(const Halfspace3& halfspace, const RayQuestion&, const F& f) {
  return f(HalfspaceModel{halfspace});
}
template <class F>
auto with_model(const Aabb3& box, const RayQuestion&, const F& f) {
  return f(AabbModel{box});
}
template <class F>
auto with_model(const KDop3& k_dop, const RayQuestion&, const F& f) {
  return f(KDopModel{k_dop});
}

template struct RayAnswers<Plane3>;
template struct RayAnswers<ThreePointPlane3>;
template struct RayAnswers<Halfspace3>;
template struct RayAnswers<Aabb3>;
template struct RayAnswers<KDop3>;

}  // namespace plumb::query
