// Oriented boxes, rectangles and tetrahedra: by halfspaces where they have an inside, else by their faces.
//
// A box without inside is the union of its faces: along a direction in which nothing changes every point of it is
// reached from its boundary.  So is a tetrahedron in a plane, of its four triangles.
#include <cmath>
#include <span>

#include "plumb/predicates.hpp"
#include "plumb/predicates/determinant.hpp"
#include "query/ray/answers.hpp"
#include "query/ray/box_feature.hpp"

namespace plumb::query {
namespace {

/// Constraint 2 a is the lower end of axis a, 2 a + 1 the upper one, by the cofactors of the axes.
struct SolidBoxModel {
  const Obb3& box;
  Sign turn;  // of the three axes

  /// Toward the upper end of axis a: the cross product of the other two, which is as far along axis a as the
  /// determinant says.
  template <class T>
  [[nodiscard]] Vec3<T> outward(std::uint32_t axis, bool upper) const {
    const Vec3<T> u = vector_of<T>(box.axes[(axis + 1) % 3]), v = vector_of<T>(box.axes[(axis + 2) % 3]);
    return upper == (turn == Sign::positive) ? cross(u, v) : cross(v, u);
  }
  [[nodiscard]] double half(std::uint32_t axis) const {
    return std::fabs(axis == 0 ? box.half.x : axis == 1 ? box.half.y : box.half.z);
  }
  static std::size_t size() { return 6; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const std::uint32_t axis = i / 2;
    const Vec3<T> out = outward<T>(axis, i % 2 == 1), a = vector_of<T>(box.axes[axis]);
    const T reach = T(half(axis)) * dot(a, outward<T>(axis, true));
    return {dot(line.origin_from(box.center), out) - reach, dot(line.direction, out)};
  }
  static Feature feature(std::span<const std::uint32_t> tight) { return box_feature(tight); }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    return still_normal(outward<T>(decided.normal / 2, decided.normal % 2 == 1));
  }
};

/// The corner at the upper ends of these axes.
template <class T, std::size_t N>
Vec3<T> corner(const ShotLine<T>& line, const Point3& center, const std::array<Vector3, N>& axes,
               const std::array<double, N>& half, std::uint32_t ends) {
  Vec3<T> p = line.from_origin(center);
  for (std::size_t i = 0; i < N; ++i) {
    const double h = std::fabs(half[i]);
    p = p + times(vector_of<T>(axes[i]), T((ends >> i & 1u) != 0 ? h : -h));
  }
  return p;
}

struct FlatBoxModel : FacetModel<FlatBoxModel> {
  explicit FlatBoxModel(const Obb3& b) : box(b) {}
  const Obb3& box;

  static std::size_t facets() { return 6; }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t face) const {
    const std::uint32_t w = face / 2, u = w == 0 ? 1 : 0, v = 3 - u - w, at = (face & 1u) << w;
    Facet<T> f{4, {line.direction, line.direction, line.direction, line.direction}, {}, {}, face};
    const std::array<std::uint32_t, 4> ends{at, at | 1u << u, at | 1u << u | 1u << v, at | 1u << v};
    for (std::size_t i = 0; i < 4; ++i) {
      f.corners[i] = corner<T, 3>(line, box.center, box.axes, {box.half.x, box.half.y, box.half.z}, ends[i]);
      f.vertex[i] = ends[i];
      const std::uint32_t along = i % 2 == 0 ? u : v, first = along == 0 ? 1 : 0, second = 3 - along - first;
      const std::uint32_t here = ends[i] & ~(1u << along);
      f.edge[i] = 4 * along + (here >> first & 1u) + 2 * (here >> second & 1u);
    }
    return f;
  }
};

struct RectangleModel : FacetModel<RectangleModel> {
  explicit RectangleModel(const Rectangle3& r) : rectangle(r) {}
  const Rectangle3& rectangle;

  static std::size_t facets() { return 1; }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t) const {
    const auto at = [&](std::uint32_t ends) {
      return corner<T, 2>(line, rectangle.center, rectangle.axes, {rectangle.half.x, rectangle.half.y}, ends);
    };
    return {4, {at(0), at(1), at(3), at(2)}, {0, 1, 3, 2}, {0, 3, 1, 2}, 0};
  }
};

/// Corners of the face opposite to each corner, and the edges between corners.
constexpr std::array<std::array<std::uint32_t, 3>, 4> tetrahedron_faces{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
constexpr std::uint32_t edge_between(std::uint32_t p, std::uint32_t q) {
  const std::uint32_t low = p < q ? p : q, high = p < q ? q : p;
  return low == 0 ? high - 1 : low + high;  // ab ac ad, bc bd cd
}

struct BoxCorners {
  std::array<Point3, 4> at;
  explicit BoxCorners(const Tetrahedron3& t) : at{t.a, t.b, t.c, t.d} {}
};

/// Constraint i is the face opposite to corner i.
struct SolidTetrahedronModel {
  BoxCorners corners;
  Sign turn;  // orient3d of the corners

  template <class T>
  [[nodiscard]] Vec3<T> outward(std::uint32_t face) const {
    const auto& [p, q, r] = tetrahedron_faces[face];
    const Vec3<T> u = between<T>(corners.at[p], corners.at[q]), v = between<T>(corners.at[p], corners.at[r]);
    // (q - p) x (r - p) points away from the corner left out for even ones where a, b, c, d turn to the right.
    return (face % 2 == 0) == (turn == Sign::negative) ? cross(u, v) : cross(v, u);
  }
  static std::size_t size() { return 4; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const Vec3<T> out = outward<T>(i);
    return {dot(line.origin_from(corners.at[tetrahedron_faces[i][0]]), out), dot(line.direction, out)};
  }
  static Feature feature(std::span<const std::uint32_t> tight) {
    if (tight.size() == 1) return {FeatureKind::face, tight[0]};
    std::array<bool, 4> on{true, true, true, true};
    for (const std::uint32_t face : tight) on[face] = false;
    std::array<std::uint32_t, 4> left{};
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (on[i]) left[n++] = i;
    }
    if (n == 1) return {FeatureKind::vertex, left[0]};
    return {FeatureKind::edge, edge_between(left[0], left[1])};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    return still_normal(outward<T>(decided.normal));
  }
};

struct FlatTetrahedronModel : FacetModel<FlatTetrahedronModel> {
  explicit FlatTetrahedronModel(const Tetrahedron3& t) : corners(t) {}
  BoxCorners corners;

  static std::size_t facets() { return 4; }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t face) const {
    const auto& [p, q, r] = tetrahedron_faces[face];
    const Vec3<T> first = line.from_origin(corners.at[p]);
    return {3,
            {first, line.from_origin(corners.at[q]), line.from_origin(corners.at[r]), first},
            {p, q, r, p},
            {edge_between(p, q), edge_between(q, r), edge_between(r, p), 0},
            face};
  }
};

}  // namespace

template <class F>
auto with_model(const Obb3& box, const RayQuestion&, const F& f) {
  const Sign turn = sign_of(predicates::Determinant3{}, box.axes[0], box.axes[1], box.axes[2]);
  return turn != Sign::zero ? f(SolidBoxModel{box, turn}) : f(FlatBoxModel(box));
}
template <class F>
auto with_model(const Rectangle3& rectangle, const RayQuestion&, const F& f) {
  return f(RectangleModel(rectangle));
}
template <class F>
auto with_model(const Tetrahedron3& t, const RayQuestion&, const F& f) {
  const Sign turn = orient3d(t.a, t.b, t.c, t.d);
  return turn != Sign::zero ? f(SolidTetrahedronModel{BoxCorners(t), turn}) : f(FlatTetrahedronModel(t));
}

template struct RayAnswers<Obb3>;
template struct RayAnswers<Rectangle3>;
template struct RayAnswers<Tetrahedron3>;

}  // namespace plumb::query
