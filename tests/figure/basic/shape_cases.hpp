// Which shapes must every function on figures get right?  Random ones of every struct, degenerate ones above all.
//
//   on_shapes(7, 1000, [](Material& m) {
//     const auto box = m.shape<Obb3>();
//     EXPECT_EQ(contains(box, m.probe3()), ...) << m.about(box);
//   });
//
// A Material is what one case is made of: a small grid (two cases of three), of any scale, or a family of
// degenerate/points.hpp.  Probes are points near to what was drawn: corners, middles, ends, faces.
// Laws: case `index` of run `start` is the same on every machine; every number is finite, radii are not negative; half
// extents and widths may be.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/case_line.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure.hpp"

namespace plumb::shape_cases {

class Material {
 public:
  Material(std::uint64_t start, std::uint64_t index) : start_(start), index_(index), entropy_(start, index) {
    grid_ = entropy_.below(3) != 0;
    if (grid_) {
      most_ = std::int64_t{1} << entropy_.below(4);
      if (entropy_.below(4) == 0) {  // a common factor and scale: long mantissas, any exponent
        factor_ = static_cast<double>(1 + entropy_.bits(static_cast<int>(entropy_.below(30))));
        exponent_ = static_cast<int>(entropy_.coin() ? entropy_.within(960) : entropy_.within(30));
      }
    } else {
      const Degeneracy degeneracy = degeneracies[entropy_.below(degeneracies.size())];
      const Family family = any_family(entropy_);
      flat_ = points2(family, degeneracy, 16, entropy_);
      solid_ = points3(family, degeneracy, 16, entropy_);
    }
  }

  Entropy& entropy() { return entropy_; }

  /// One of n.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(entropy_.below(n)); }

  Point2 point2() {
    const Point2 p = again(drawn2_) ? drawn2_[below(drawn2_.size())] : fresh2();
    drawn2_.push_back(p);
    return p;
  }
  Point3 point3() {
    const Point3 p = again(drawn3_) ? drawn3_[below(drawn3_.size())] : fresh3();
    drawn3_.push_back(p);
    return p;
  }

  /// A vector of the size of points: an edge, an axis to be taken once.
  Vector2 vector2() {
    const Point2 p = again(vectors2_) ? Point2{vectors2_[0].x, vectors2_[0].y} : fresh2();
    vectors2_.push_back(below(12) == 0 ? Vector2{0, 0} : Vector2{p.x, p.y});
    return vectors2_.back();
  }
  Vector3 vector3() {
    const Point3 p = again(vectors3_) ? Point3{vectors3_[0].x, vectors3_[0].y, vectors3_[0].z} : fresh3();
    vectors3_.push_back(below(12) == 0 ? Vector3{0, 0, 0} : Vector3{p.x, p.y, p.z});
    return vectors3_.back();
  }

  /// A vector without a scale, to be multiplied with numbers or points: a normal or a direction.
  Vector2 direction2() {
    const Vector2 v = vector2();
    return grid_ ? Vector2{unscaled(v.x), unscaled(v.y)} : v;
  }
  Vector3 direction3() {
    const Vector3 v = vector3();
    return grid_ ? Vector3{unscaled(v.x), unscaled(v.y), unscaled(v.z)} : v;
  }

  /// A coordinate of the size of points.
  double number() {
    if (below(10) == 0) return 0;
    return grid_ ? scaled(entropy_.within(most_)) : solid_[below(solid_.size())].x;
  }
  /// Not negative, often zero or the distance of two points drawn.
  double radius() {
    const double r = std::fabs(radius_of_any_sign());
    numbers_.push_back(r);
    return r;
  }
  /// How often a vector is taken, of any sign.
  double multiple() {
    const double m = below(10) == 0 ? 0 : grid_ ? static_cast<double>(entropy_.within(3)) : number();
    numbers_.push_back(m);
    return m;
  }

  template <class Shape>
  Shape shape() {
    Shape s{};
    fill(s);
    return s;
  }

  /// A point that lies near to what was drawn, and is often on its boundary.
  Point2 probe2() {
    if (drawn2_.empty() || below(4) == 0) return fresh2();
    if (below(6) == 0) return middle(drawn2_);
    const Point2 a = drawn2_[below(drawn2_.size())], b = drawn2_[below(drawn2_.size())];
    const auto [from, to, across] = mixture();
    Point2 p{at(a.x, b.x, from, to), at(a.y, b.y, from, to)};
    for (std::size_t i = 0; i < vectors2_.size() && across; ++i) {
      const double by = step(i);
      p = finite(Point2{p.x + by * vectors2_[i].x, p.y + by * vectors2_[i].y}, p);
    }
    if (!numbers_.empty() && below(3) == 0) p = finite(Point2{p.x + numbers_[0], p.y}, p);
    return nudged(p);
  }
  Point3 probe3() {
    if (drawn3_.empty() || below(4) == 0) return fresh3();
    if (below(6) == 0) return middle(drawn3_);
    const Point3 a = drawn3_[below(drawn3_.size())], b = drawn3_[below(drawn3_.size())];
    const auto [from, to, across] = mixture();
    Point3 p{at(a.x, b.x, from, to), at(a.y, b.y, from, to), at(a.z, b.z, from, to)};
    for (std::size_t i = 0; i < vectors3_.size() && across; ++i) {
      const double by = step(i);
      p = finite(Point3{p.x + by * vectors3_[i].x, p.y + by * vectors3_[i].y, p.z + by * vectors3_[i].z}, p);
    }
    if (!numbers_.empty() && below(3) == 0) p = finite(Point3{p.x, p.y, p.z + numbers_[0]}, p);
    return nudged(p);
  }
  template <class Point>
  Point probe() {
    if constexpr (std::is_same_v<Point, Point2>) {
      return probe2();
    } else {
      return probe3();
    }
  }

  /// The line that replays a failure, with the numbers of what was asked about.
  template <class... Parts>
  [[nodiscard]] std::string about(const Parts&... parts) const {
    std::string text = "start " + std::to_string(start_) + " index " + std::to_string(index_);
    (text.append(numbers(parts)), ...);
    return text;
  }
  template <class Part>
  static std::string numbers(const Part& part) {
    std::string text;
    if constexpr (std::is_trivially_copyable_v<Part> && sizeof(Part) % sizeof(double) == 0) {
      std::array<double, sizeof(Part) / sizeof(double)> all;
      std::memcpy(all.data(), &part, sizeof(Part));
      for (const double x : all) text.append(" ").append(hexadecimal(x));
      text.append(";");
    }
    return text;
  }

 private:
  template <class Drawn>
  bool again(const Drawn& drawn) {
    return !drawn.empty() && below(12) == 0;
  }
  [[nodiscard]] double scaled(std::int64_t x) const { return std::ldexp(static_cast<double>(x) * factor_, exponent_); }
  [[nodiscard]] double unscaled(double x) const { return std::ldexp(x, -exponent_) / factor_; }
  double grid() { return scaled(entropy_.within(most_)); }
  Point2 fresh2() {
    if (!grid_) return flat_[below(flat_.size())];
    const double x = grid(), y = grid();
    return {x, y};
  }
  Point3 fresh3() {
    if (!grid_) return solid_[below(solid_.size())];
    const double x = grid(), y = grid(), z = grid();
    return {x, y, z};
  }
  double radius_of_any_sign() {
    const std::size_t kind = below(6);
    if (kind == 0 && drawn3_.size() > 1) {
      const double r =
          std::hypot(drawn3_[0].x - drawn3_[1].x, drawn3_[0].y - drawn3_[1].y, drawn3_[0].z - drawn3_[1].z);
      if (std::isfinite(r)) return r;
    }
    return number();
  }

  static Point2 middle(const std::vector<Point2>& points) {
    Point2 sum{0, 0};
    const auto n = static_cast<double>(points.size());
    for (const Point2& p : points) sum = {sum.x + p.x / n, sum.y + p.y / n};
    return finite(sum, points[0]);
  }
  static Point3 middle(const std::vector<Point3>& points) {
    Point3 sum{0, 0, 0};
    const auto n = static_cast<double>(points.size());
    for (const Point3& p : points) sum = {sum.x + p.x / n, sum.y + p.y / n, sum.z + p.z / n};
    return finite(sum, points[0]);
  }

  // Weights of two points (in halves), and whether to go along the vectors.
  std::tuple<double, double, bool> mixture() {
    constexpr std::array<std::array<double, 2>, 5> weights{{{1, 0}, {0.5, 0.5}, {2, -1}, {0.75, 0.25}, {1, 0}}};
    const auto w = weights[below(weights.size())];
    return {w[0], w[1], below(4) != 0};
  }
  static double at(double a, double b, double from, double to) {
    const double x = to == 0 ? a : from * a + to * b;
    return std::isfinite(x) ? x : a;
  }
  // Nothing, the whole, a half, and with the multiple drawn for it.
  double step(std::size_t i) {
    const double way = static_cast<double>(entropy_.within(1));
    const std::size_t kind = below(4);
    const double m = i < numbers_.size() ? numbers_[numbers_.size() - 1 - i] : 1;
    return kind == 0 ? way : kind == 1 ? way / 2 : kind == 2 ? way * m : way * m / 2;
  }
  static Point2 finite(const Point2& p, const Point2& otherwise) {
    return std::isfinite(p.x) && std::isfinite(p.y) ? p : otherwise;
  }
  static Point3 finite(const Point3& p, const Point3& otherwise) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) ? p : otherwise;
  }
  Point2 nudged(Point2 p) {
    if (below(8) == 0) p = finite(Point2{moved_by_ulps(p.x, entropy_.within(2)), p.y}, p);
    return p;
  }
  Point3 nudged(Point3 p) {
    if (below(8) == 0) p = finite(Point3{p.x, moved_by_ulps(p.y, entropy_.within(2)), p.z}, p);
    return p;
  }

  void fill(Line2& s) { s = {point2(), direction2()}; }
  void fill(Line3& s) { s = {point3(), direction3()}; }
  void fill(Ray2& s) { s = {point2(), direction2()}; }
  void fill(Ray3& s) { s = {point3(), direction3()}; }
  void fill(Segment2& s) { s = {point2(), point2()}; }
  void fill(Segment3& s) { s = {point3(), point3()}; }
  void fill(Plane3& s) { s = {direction3(), number()}; }
  void fill(ThreePointPlane3& s) { s = {point3(), point3(), point3()}; }
  void fill(Halfspace2& s) { s = {direction2(), number()}; }
  void fill(Halfspace3& s) { s = {direction3(), number()}; }
  void fill(Slab2& s) { s = {direction2(), number(), number()}; }
  void fill(Slab3& s) { s = {direction3(), number(), number()}; }
  void fill(HalfspaceIntersection2& s) { fill_all(s.halfspaces, below(5)); }
  void fill(HalfspaceIntersection3& s) { fill_all(s.halfspaces, below(6)); }
  void fill(Triangle2& s) { s = {point2(), point2(), point2()}; }
  void fill(Triangle3& s) { s = {point3(), point3(), point3()}; }
  void fill(Tetrahedron3& s) { s = {point3(), point3(), point3(), point3()}; }
  void fill(Circle2& s) { s = {point2(), radius()}; }
  void fill(Sphere3& s) { s = {point3(), radius()}; }
  void fill(Capsule2& s) { s = {point2(), point2(), radius()}; }
  void fill(Capsule3& s) { s = {point3(), point3(), radius()}; }
  void fill(Lozenge3& s) { s = {point3(), {vector3(), vector3()}, radius()}; }
  void fill(Cylinder3& s) { s = {point3(), point3(), radius()}; }
  void fill(Cone3& s) { s = {point3(), point3(), radius()}; }
  void fill(SphericalCap3& s) {
    fill(s.sphere), fill(s.halfspace);
    if (below(3) != 0) return;
    s = generated_cap(entropy_);
    drawn3_.push_back(s.sphere.center);
  }
  void fill(Ellipsoid3& s) { s = {point3(), {vector3(), vector3(), vector3()}, {multiple(), multiple(), multiple()}}; }
  void fill(Aabb2& s) { s = ordered(Aabb2{point2(), point2()}); }
  void fill(Aabb3& s) { s = ordered(Aabb3{point3(), point3()}); }
  void fill(AabbWidths3& s) { s = {point3(), vector3()}; }
  void fill(AabbCenter3& s) { s = {point3(), vector3()}; }
  void fill(Obb2& s) { s = {point2(), {vector2(), vector2()}, {multiple(), multiple()}}; }
  void fill(Obb3& s) { s = {point3(), {vector3(), vector3(), vector3()}, {multiple(), multiple(), multiple()}}; }
  void fill(Rectangle3& s) { s = {point3(), {vector3(), vector3()}, {multiple(), multiple()}}; }
  void fill(Quadrilateral2& s) { s = {point2(), point2(), point2(), point2()}; }
  void fill(Quadrilateral3& s) { s = {point3(), point3(), point3(), point3()}; }
  void fill(Polygon2& s) {
    for (std::size_t n = 3 + below(6); n-- > 0;) s.vertices.push_back(point2());
  }
  void fill(Polygon3& s) {
    for (std::size_t n = 3 + below(6); n-- > 0;) s.vertices.push_back(point3());
  }
  void fill(HoledPolygon2& s) { fill(s.outer), fill_all(s.holes, below(3)); }
  void fill(HoledPolygon3& s) { fill(s.outer), fill_all(s.holes, below(3)); }
  void fill(TriangleMesh& s) {
    for (std::size_t n = 3 + below(6); n-- > 0;) s.vertices.push_back(point3());
    const auto corner = [&] { return static_cast<std::uint32_t>(below(s.vertices.size())); };
    for (std::size_t n = 1 + below(8); n-- > 0;) s.triangles.push_back({corner(), corner(), corner()});
  }
  void fill(PolygonMesh& s) {
    for (std::size_t n = 3 + below(6); n-- > 0;) s.vertices.push_back(point3());
    for (std::size_t n = 1 + below(6); n-- > 0;) {
      for (std::size_t k = 3 + below(3); k-- > 0;)
        s.corners.push_back(static_cast<std::uint32_t>(below(s.vertices.size())));
      s.first.push_back(static_cast<std::uint32_t>(s.corners.size()));
    }
  }
  template <class Part>
  void fill_all(std::vector<Part>& parts, std::size_t n) {
    parts.resize(n);
    for (Part& part : parts) fill(part);
  }
  // Now and then as drawn: mostly empty.
  Aabb2 ordered(const Aabb2& box) {
    const auto& [a, b] = box;
    if (below(10) == 0) return box;
    return {{std::fmin(a.x, b.x), std::fmin(a.y, b.y)}, {std::fmax(a.x, b.x), std::fmax(a.y, b.y)}};
  }
  Aabb3 ordered(const Aabb3& box) {
    const auto& [a, b] = box;
    if (below(10) == 0) return box;
    return {{std::fmin(a.x, b.x), std::fmin(a.y, b.y), std::fmin(a.z, b.z)},
            {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)}};
  }

  std::uint64_t start_, index_;
  Entropy entropy_;
  bool grid_ = true;
  std::int64_t most_ = 1;
  double factor_ = 1;
  int exponent_ = 0;
  std::vector<Point2> flat_, drawn2_;
  std::vector<Point3> solid_, drawn3_;
  std::vector<Vector2> vectors2_;
  std::vector<Vector3> vectors3_;
  std::vector<double> numbers_;
};

#if defined(PLUMB_LONG_TESTS)
inline constexpr std::uint64_t more = 50;
#else
inline constexpr std::uint64_t more = 1;
#endif

/// Calls check(material) for `cases` cases.
template <class Check>
void on_shapes(std::uint64_t start, std::uint64_t cases, Check check) {
  for (std::uint64_t i = 0; i < cases * more; ++i) {
    Material material(start, i);
    check(material);
  }
}

}  // namespace plumb::shape_cases
