// Is the worked example of docs/add_a_figure.md true?  Places and boxes against rationals, and what it says of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "docs/cushion.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::docs {
namespace {

using Exact = std::array<Rational, 3>;
Exact exact(const Point3& p) { return {p.x, p.y, p.z}; }
Exact from(const Exact& a, const Exact& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
Rational inner(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Of p from the segment.
Rational squared_distance(const Exact& a, const Exact& b, const Exact& p) {
  const Exact u = from(a, b), w = from(a, p);
  const Rational whole = inner(u, u);
  Rational t = whole.sign() == Sign::zero ? Rational(0.0) : inner(w, u) / whole;
  t = std::clamp(t, Rational(0.0), Rational(1.0));
  const Exact off{w[0] - t * u[0], w[1] - t * u[1], w[2] - t * u[2]};
  return inner(off, off);
}
/// From the triangle: of its edges, and of the foot where that is within.
Rational squared_distance(const Triangle3& t, const Point3& point) {
  const Exact a = exact(t.a), b = exact(t.b), c = exact(t.c), p = exact(point);
  Rational least = std::min({squared_distance(a, b, p), squared_distance(b, c, p), squared_distance(c, a, p)});
  const Exact u = from(a, b), v = from(a, c), w = from(a, p);
  const Rational uu = inner(u, u), uv = inner(u, v), vv = inner(v, v), whole = uu * vv - uv * uv;
  if (whole.sign() == Sign::zero) return least;
  const Rational s = (inner(w, u) * vv - inner(w, v) * uv) / whole, r = (inner(w, v) * uu - inner(w, u) * uv) / whole;
  if (s.sign() == Sign::negative || r.sign() == Sign::negative || s + r > Rational(1.0)) return least;
  const Exact off{w[0] - s * u[0] - r * v[0], w[1] - s * u[1] - r * v[1], w[2] - s * u[2] - r * v[2]};
  return std::min(least, inner(off, off));
}

TEST(OwnFigure, PlacesAndBoxesAreThoseOfRationals) {
  std::array<int, 3> seen{};
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Entropy e(22, i);
    const auto number = [&e] { return static_cast<double>(e.within(4)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    const mine::Cushion cushion{{point(), point(), point()}, static_cast<double>(e.below(4))};
    Point3 p = point();
    if (e.below(3) == 0) p = {cushion.core.b.x, cushion.core.b.y, cushion.core.b.z + cushion.radius};
    const Rational reach = Rational(cushion.radius) * Rational(cushion.radius);
    const Sign beyond = (squared_distance(cushion.core, p) - reach).sign();
    const auto expected = static_cast<Location>(-static_cast<int>(beyond));
    ASSERT_EQ(locate(cushion, p), expected) << "replay: " << i;
    ASSERT_EQ(contains(cushion, p), expected != Location::outside) << "replay: " << i;
    ++seen[static_cast<std::size_t>(static_cast<int>(expected) + 1)];

    const Triangle3& t = cushion.core;
    const double r = cushion.radius;
    const Aabb3 core = fit_aabb(t);
    ASSERT_EQ(fit_aabb(cushion), (Aabb3{{core.min.x - r, core.min.y - r, core.min.z - r},
                                        {core.max.x + r, core.max.y + r, core.max.z + r}}))
        << "replay: " << i;
  }
  for (const int n : seen) EXPECT_GT(n, 30);
}

TEST(OwnFigure, SaysItself) {
  mine::Cushion cushion{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, 10};
  EXPECT_EQ(name_of_figure(cushion), "cushion");
  change_members(cushion, [](auto, auto& member) {
    if constexpr (requires { member.a; }) {
      change_members(member, []<part::Role role>(part::RoleIs<role>, Point3& p) {
        static_assert(role == part::Role::place);
        p.x = -p.x;
      });
    } else {
      member *= 2;
    }
  });
  EXPECT_EQ(cushion.core, (Triangle3{{-1, 2, 3}, {-4, 5, 6}, {-7, 8, 9}}));
  EXPECT_EQ(cushion.radius, 20);
}

}  // namespace
}  // namespace plumb::docs
