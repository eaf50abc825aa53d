// Are the numbers of round shapes rounded once, and their features exact?  Against GMP's floats of thousands of bits,
// in which each shape is followed by its definition: unit vectors, projections, sums.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "figure/basic/shape_cases.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;

// Every sum of products of seven doubles fits, so that rational values are exact; what is irrational is known to some
// thousand bits more than any double beside it needs.
constexpr unsigned precision = 18000;
const bool digits = [] {
  mpf_set_default_prec(precision);
  return true;
}();

using Number = mpf_class;
struct V {
  Number x, y, z;
};
V real(const Point3& p) { return {Number(p.x, precision), Number(p.y, precision), Number(p.z, precision)}; }
V real(const Vector3& p) { return {Number(p.x, precision), Number(p.y, precision), Number(p.z, precision)}; }
V operator+(const V& a, const V& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator*(const Number& s, const V& a) { return {s * a.x, s * a.y, s * a.z}; }
Number dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
bool zero(const V& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

/// Zero but for the last digits of what it was computed from.
int sign(const Number& x, const Number& size) {
  Number least(size, precision);
  mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), precision - 2000);
  return abs(x) <= least ? 0 : sgn(x);
}

/// s / |s|, or zero.
V unit(const V& s) {
  const Number square = dot(s, s);
  if (square == 0) return s;
  return Number(1 / sqrt(square)) * s;
}

/// d less its part along the axis u, which is not zero; exactly zero where d is parallel to u.
V across(const V& u, const V& d) {
  const V c{u.y * d.z - u.z * d.y, u.z * d.x - u.x * d.z, u.x * d.y - u.y * d.x};
  if (zero(c)) return c;
  return d - Number(dot(d, u) / dot(u, u)) * u;
}

struct Farthest {
  V point;
  std::uint32_t feature;
  bool unique;
};

Farthest of(const V& center, double radius, const V& d) {
  return {center + Number(radius) * unit(d), 0, radius == 0 || !zero(d)};
}
Farthest of(const Sphere3& s, const V& d) { return of(real(s.center), s.radius, d); }
Farthest of(const Capsule3& s, const V& d) {
  const int far = sgn(Number(dot(real(s.b) - real(s.a), d)));
  Farthest f = of(real(far > 0 ? s.b : s.a), s.radius, d);
  f.feature = far > 0 ? 1 : 0;
  f.unique = f.unique && (far != 0 || s.a == s.b);
  return f;
}
Farthest of(const Lozenge3& s, const V& d) {
  V corner = real(s.corner);
  std::uint32_t feature = 0;
  bool tied = false;
  for (std::uint32_t i = 0; i < 2; ++i) {
    const V e = real(s.edges[i]);
    const int far = sgn(Number(dot(e, d)));
    if (far > 0) {
      corner = corner + e;
      feature += i + 1;
    }
    tied = tied || (far == 0 && !zero(e));
  }
  Farthest f = of(corner, s.radius, d);
  return {f.point, feature, f.unique && !tied};
}
Farthest of(const Cylinder3& s, const V& d) {
  if (s.a == s.b) return of(real(s.a), s.radius, d);
  const V u = real(s.b) - real(s.a), w = across(u, d);
  const int far = sgn(Number(dot(u, d)));
  return {real(far > 0 ? s.b : s.a) + Number(s.radius) * unit(w), far > 0 ? 1u : 0u,
          far != 0 && (s.radius == 0 || !zero(w))};
}
Farthest of(const Cone3& s, const V& d) {
  if (s.apex == s.base) return of(real(s.apex), s.radius, d);
  const V u = real(s.base) - real(s.apex), w = across(u, d);
  const V rim = real(s.base) + Number(s.radius) * unit(w);
  const Number straight = dot(real(s.base) - real(s.apex), d), round = s.radius * dot(unit(w), d);
  const int far = sign(straight + round, abs(straight) + abs(round));
  if (far > 0) return {rim, 1, s.radius == 0 || !zero(w)};
  return {real(s.apex), 0, far < 0};
}
Farthest of(const Ellipsoid3& s, const V& d) {
  const std::array<double, 3> half{s.half.x, s.half.y, s.half.z};
  std::array<V, 3> arm;
  for (std::size_t i = 0; i < 3; ++i) arm[i] = Number(half[i]) * real(s.axes[i]);
  const V t = unit({dot(arm[0], d), dot(arm[1], d), dot(arm[2], d)});
  const bool point = zero(arm[0]) && zero(arm[1]) && zero(arm[2]);
  return {real(s.center) + t.x * arm[0] + t.y * arm[1] + t.z * arm[2], 0, point || !zero(t)};
}

/// How far the plane is beyond the center, and the square of its circle's radius, both times the normal's square.
std::pair<Number, Number> cut_of(const SphericalCap3& s) {
  const V n = real(s.halfspace.normal);
  const Number depth = Number(s.halfspace.offset, precision) - dot(n, real(s.sphere.center)),
               r(s.sphere.radius, precision);
  return {depth, Number(r * r * dot(n, n) - depth * depth, precision)};
}
Farthest of(const SphericalCap3& s, const V& d) {
  const V n = real(s.halfspace.normal), c = real(s.sphere.center);
  const auto [depth, circle] = cut_of(s);
  const Number off = s.sphere.radius * dot(n, unit(d)), over = off - depth;
  if (zero(d) ? depth >= 0 : sign(over, abs(off) + abs(depth)) <= 0) return of(c, s.sphere.radius, d);
  const Number square = dot(n, n), rim = sqrt(Number(circle / square, precision));
  const V w = across(n, d), middle = c + Number(depth / square) * n;
  return {middle + rim * unit(w), 1, circle == 0 || !zero(w)};
}

/// Is the finite x rounded from v as asked, where v may be off by its last digits?
bool is_rounded(Rounding rounding, double x, const Number& v, const Number& size) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Number below(std::nextafter(x, -infinity)), above(std::nextafter(x, infinity));
  if (std::signbit(x) && x == 0) return false;
  if (rounding == Rounding::down) return sign(v - x, size) >= 0 && sign(above - v, size) > 0;
  if (rounding == Rounding::up) return sign(x - v, size) >= 0 && sign(v - below, size) > 0;
  return sign(x + above - 2 * v, size) >= 0 && sign(2 * v - x - below, size) >= 0;
}

struct Seen {
  std::map<std::uint32_t, int> feature;
  int tied = 0, beyond = 0;
};

template <class Shape>
void hold(const Shape& shape, const Vector3& direction, Seen& seen) {
  const double half_most = std::numeric_limits<double>::max() / 2;
  const V d = real(direction);
  const Farthest f = of(shape, d);
  Number size = 1;
  for (const Number& x : {f.point.x, f.point.y, f.point.z}) size += abs(x);
  try {
    const Support3 s = support_point(shape, direction);
    EXPECT_EQ(s.feature, f.feature);
    EXPECT_EQ(s.unique, f.unique);
    for (const auto& [x, v] : {std::pair{s.point.x, f.point.x}, {s.point.y, f.point.y}, {s.point.z, f.point.z}}) {
      EXPECT_TRUE(!(std::fabs(x) < half_most) || is_rounded(Rounding::nearest, x, v, size)) << x;
    }
    ++seen.feature[s.feature];
    seen.tied += s.unique ? 0 : 1;
  } catch (const BeyondDoubles&) {
    EXPECT_GT(size, half_most);
    ++seen.beyond;
  }
  const Number height = dot(f.point, d), height_size = size * (1 + abs(d.x) + abs(d.y) + abs(d.z));
  for (const Rounding r : {Rounding::down, Rounding::nearest, Rounding::up}) {
    const double x = support_value(shape, direction, r);
    if (std::fabs(x) < half_most) {
      EXPECT_TRUE(is_rounded(r, x, height, height_size)) << x << " " << static_cast<int>(r);
    } else {
      EXPECT_GT(abs(height), half_most / 2);
    }
  }
}

template <class Shape>
Seen hold_all(std::uint64_t start, std::uint64_t cases) {
  Seen seen;
  on_shapes(start, cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const Vector3 d = m.below(8) == 0 ? m.vector3() : m.direction3();
    SCOPED_TRACE(m.about(shape, d));
    hold(shape, d, seen);
  });
  return seen;
}

TEST(SupportRound, OfASphere) {
  const Seen seen = hold_all<Sphere3>(51, 1500);
  EXPECT_GT(seen.tied, 10);
}
TEST(SupportRound, OfACapsule) {
  const Seen seen = hold_all<Capsule3>(52, 1500);
  EXPECT_GT(seen.feature.at(0), 50);
  EXPECT_GT(seen.feature.at(1), 50);
  EXPECT_GT(seen.tied, 20);
}
TEST(SupportRound, OfALozenge) {
  const Seen seen = hold_all<Lozenge3>(53, 1500);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_GT(seen.feature.at(i), 20);
  EXPECT_GT(seen.tied, 50);
}
TEST(SupportRound, OfACylinder) {
  const Seen seen = hold_all<Cylinder3>(54, 1500);
  EXPECT_GT(seen.feature.at(0), 50);
  EXPECT_GT(seen.feature.at(1), 50);
  EXPECT_GT(seen.tied, 20);
}
TEST(SupportRound, OfACone) {
  const Seen seen = hold_all<Cone3>(55, 2000);
  EXPECT_GT(seen.feature.at(0), 50);
  EXPECT_GT(seen.feature.at(1), 50);
  EXPECT_GT(seen.tied, 10);
}
TEST(SupportRound, OfAnEllipsoid) {
  const Seen seen = hold_all<Ellipsoid3>(56, 1500);
  EXPECT_GT(seen.tied, 10);
}

TEST(SupportRound, OfACap) {
  Seen seen;
  int empty = 0;
  on_shapes(57, 1500, [&](Material& m) {
    const auto cap = m.shape<SphericalCap3>();
    const Vector3 d = m.below(8) == 0 ? m.vector3() : m.below(8) == 0 ? cap.halfspace.normal : m.direction3();
    SCOPED_TRACE(m.about(cap, d));
    const auto [depth, circle] = cut_of(cap);
    if (depth < 0 && circle < 0) {
      ++empty;
      EXPECT_THROW(support_point(cap, d), InvalidShape);
    } else {
      hold(cap, d, seen);
    }
  });
  EXPECT_GT(empty, 100);
  EXPECT_GT(seen.feature.at(0), 50);
  EXPECT_GT(seen.feature.at(1), 50);
  EXPECT_GT(seen.tied, 10);
}

TEST(SupportRound, InThePlaneIsThatInSpace) {
  on_shapes(57, 500, [](Material& m) {
    const auto circle = m.shape<Circle2>();
    const auto capsule = m.shape<Capsule2>();
    const Vector2 d = m.direction2();
    SCOPED_TRACE(m.about(circle, capsule, d));
    const auto raised = [](const Point2& p) { return Point3{p.x, p.y, 0}; };
    const auto flat = [](const Support3& s) { return Support2{{s.point.x, s.point.y}, s.feature, s.unique}; };
    try {
      const Support3 on_ball = support_point(Sphere3{raised(circle.center), circle.radius}, {d.x, d.y, 0});
      EXPECT_EQ(support_point(circle, d), flat(on_ball));
      const Support3 on_solid =
          support_point(Capsule3{raised(capsule.a), raised(capsule.b), capsule.radius}, {d.x, d.y, 0});
      EXPECT_EQ(support_point(capsule, d), flat(on_solid));
      for (const Rounding r : {Rounding::down, Rounding::nearest, Rounding::up}) {
        EXPECT_EQ(support_value(circle, d, r),
                  support_value(Sphere3{raised(circle.center), circle.radius}, {d.x, d.y, 0}, r));
        EXPECT_EQ(support_value(capsule, d, r),
                  support_value(Capsule3{raised(capsule.a), raised(capsule.b), capsule.radius}, {d.x, d.y, 0}, r));
      }
    } catch (const BeyondDoubles&) {
      EXPECT_GT(std::fabs(circle.radius) + std::fabs(capsule.radius) + std::fabs(circle.center.x) +
                    std::fabs(capsule.a.x) + std::fabs(capsule.a.y) + std::fabs(circle.center.y),
                1e300);
    }
  });
}

TEST(SupportRound, ThatCanBeCountedOnFingers) {
  EXPECT_EQ(support_point(Sphere3{{1, 2, 3}, 5}, {3, -4, 0}), (Support3{{4, -2, 3}, 0, true}));
  EXPECT_EQ(support_point(Sphere3{{1, 2, 3}, 5}, {0, 0, 0}), (Support3{{1, 2, 3}, 0, false}));
  EXPECT_EQ(support_point(Circle2{{0, 0}, 1}, {1, 1}),
            (Support2{{0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1}, 0, true}));
  EXPECT_EQ(support_point(Cylinder3{{0, 0, 0}, {0, 0, 2}, 1}, {0, 0, 7}), (Support3{{0, 0, 2}, 1, false}));
  EXPECT_EQ(support_point(Cylinder3{{0, 0, 0}, {0, 0, 2}, 1}, {1, 0, 7}), (Support3{{1, 0, 2}, 1, true}));
  // The directions along which apex and rim of this cone tie enclose an angle whose tangent is 3/4 with its axis.
  const Cone3 cone{{0, 0, 3}, {0, 0, 0}, 4};
  EXPECT_EQ(support_point(cone, {3, 0, 4}), (Support3{{0, 0, 3}, 0, false}));
  EXPECT_EQ(support_point(cone, {std::nextafter(3.0, 4.0), 0, 4}), (Support3{{4, 0, 0}, 1, true}));
  EXPECT_EQ(support_point(cone, {std::nextafter(3.0, 0.0), 0, 4}), (Support3{{0, 0, 3}, 0, true}));
  EXPECT_EQ(support_value(cone, {3, 0, 4}), 12);
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  EXPECT_EQ(support_point(Sphere3{{0, 0, 0}, 5}, {3 * tiny, 4 * tiny, 0}).point, (Point3{3, 4, 0}));
  EXPECT_EQ(support_point(Sphere3{{0, 0, 0}, huge}, {huge, tiny, 0}).point, (Point3{huge, tiny, 0}));
  EXPECT_THROW(support_point(Sphere3{{huge, 0, 0}, huge}, {1, 0, 0}), BeyondDoubles);
  EXPECT_EQ(support_value(Sphere3{{huge, 0, 0}, huge}, {1, 0, 0}, Rounding::down), huge);
}

}  // namespace
}  // namespace plumb
