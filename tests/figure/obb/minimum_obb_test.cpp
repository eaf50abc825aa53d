// Is no box smaller than what certified_minimum_obb proves, and is the box that it gives so small?
//
// The judges share nothing with the search: volumes around exactly rectangular frames of integer quaternions, in
// rationals, and a walk over all pairs of edges and angles in long doubles, which finds boxes and proves nothing.
#include "plumb/figure/obb/minimum_obb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "figure/obb/cases.hpp"
#include "figure/obb/flush_part.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb::shape_cases {
namespace {

using obb_cases::Rational3;
constexpr std::array upright{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};

mpq_class two_to(int exponent) {
  mpq_class one(1);
  exponent >= 0 ? mpq_mul_2exp(one.get_mpq_t(), one.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent))
                : mpq_div_2exp(one.get_mpq_t(), one.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return one;
}
mpq_class least_of(const CertifiedObb3& c) { return mpq_class(c.least_volume.lower) * two_to(3 * c.unit); }
mpq_class most_of(const CertifiedObb3& c) { return mpq_class(c.least_volume.upper) * two_to(3 * c.unit); }

mpq_class exact_volume(const Obb3& box) {
  const auto u = obb_cases::rational(box.axes[0]), v = obb_cases::rational(box.axes[1]),
             w = obb_cases::rational(box.axes[2]);
  const mpq_class det =
      u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  return abs(8 * mpq_class(box.half.x) * mpq_class(box.half.y) * mpq_class(box.half.z) * det);
}

/// The rows of the quaternion's matrix, each as long as its square, that is |q|^2.
std::array<Rational3, 3> frame_of(const std::array<mpq_class, 4>& q) {
  const auto& [w, x, y, z] = q;
  return {Rational3{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
          Rational3{2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
          Rational3{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
}

mpq_class volume_along(const std::array<mpq_class, 4>& q, std::span<const Point3> points) {
  mpq_class size = 0, volume = 1;
  for (const mpq_class& x : q) size += x * x;
  for (const Rational3& axis : frame_of(q)) {
    mpq_class least, most;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto p = obb_cases::rational(points[i]);
      const mpq_class at = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
      if (i == 0 || at < least) least = at;
      if (i == 0 || at > most) most = at;
    }
    volume *= (most - least) / size;
  }
  return volume;
}

std::array<mpq_class, 4> random_quaternion(Entropy& entropy) {
  std::array<mpq_class, 4> q;
  do {
    for (mpq_class& x : q) x = static_cast<long>(entropy.below(41)) - 20;
  } while (q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0);
  return q;
}

// What holds of every answer.
void expect_proved(const CertifiedObb3& c, std::span<const Point3> points, const std::string& about) {
  const mpq_class least = least_of(c), volume = exact_volume(c.box);
  for (const Point3& p : points) ASSERT_TRUE(obb_cases::holds(c.box, p)) << about;
  ASSERT_LE(c.least_volume.lower, c.least_volume.upper) << about;
  if (std::isfinite(c.excess)) {
    ASSERT_LE(volume, least * (1 + mpq_class(c.excess))) << about;
  }
}

using Real = long double;
using Real3 = std::array<Real, 3>;
Real dot(const Real3& u, const Real3& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Real3 cross(const Real3& u, const Real3& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Real3 unit(const Real3& v) {
  const Real length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}
Real width(const std::vector<Real3>& points, const Real3& n) {
  Real least = dot(points[0], n), most = least;
  for (const Real3& p : points) {
    least = std::min(least, dot(p, n));
    most = std::max(most, dot(p, n));
  }
  return most - least;
}

// Over all pairs of points as edges and all angles: a box that exists, up to roundings of long doubles.
Real walked(std::span<const Point3> given) {
  std::vector<Real3> points, edges;
  for (const Point3& p : given) points.push_back({p.x - given[0].x, p.y - given[0].y, p.z - given[0].z});
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Real3 e{points[i][0] - points[j][0], points[i][1] - points[j][1], points[i][2] - points[j][2]};
      if (dot(e, e) > 0) edges.push_back(unit(e));
    }
  }
  Real best = std::numeric_limits<Real>::infinity();
  for (const Real3& e : edges) {
    const Real3 beside = std::fabs(e[0]) < 0.6L ? Real3{1, 0, 0} : Real3{0, 1, 0};
    const Real3 u = unit(cross(e, beside)), v = cross(e, u);
    for (const Real3& f : edges) {
      const auto volume = [&](Real angle) {
        const Real c = std::cos(angle), s = std::sin(angle);
        const Real3 n1{c * u[0] + s * v[0], c * u[1] + s * v[1], c * u[2] + s * v[2]};
        const Real3 across = cross(f, n1);
        if (dot(across, across) < 1e-12L) return std::numeric_limits<Real>::infinity();
        const Real3 n2 = unit(across);
        return width(points, n1) * width(points, n2) * width(points, cross(n1, n2));
      };
      constexpr int steps = 48;
      constexpr Real step = 3.14159265358979323846L / steps;
      std::array<Real, steps> at{};
      for (int i = 0; i < steps; ++i) at[static_cast<std::size_t>(i)] = volume(i * step);
      for (int i = 0; i < steps; ++i) {
        const Real here = at[static_cast<std::size_t>(i)];
        if (here > at[static_cast<std::size_t>((i + 1) % steps)] ||
            here > at[static_cast<std::size_t>((i + steps - 1) % steps)] || here > best * 1.05L)
          continue;
        Real low = (i - 1) * step, high = (i + 1) * step;
        for (int k = 0; k < 90; ++k) {
          const Real a = low + (high - low) * 0.4L, b = low + (high - low) * 0.6L;
          (volume(a) < volume(b) ? high : low) = volume(a) < volume(b) ? b : a;
        }
        best = std::min({best, here, volume(low), volume(high)});
      }
    }
  }
  return best;
}

// Found by hostile probes: doubles ended the search too early.
TEST(MinimumObbTest, FindsTheLeastWhereDoublesMissedIt) {
  const std::vector<Point3> slanted{{-0.23710333501766556, 0.31738240041967192, -0.91817777169094417},
                                    {0.334864349112656, -0.013210857341516703, -0.94217373182532504},
                                    {-0.99335672618576953, 0.10218362373177627, -0.052923733641276803},
                                    {0.49943576138117241, -0.85367103551214296, -0.14768101902828987}};
  const std::vector<Point3> five{{.3, .3 * 3, .3 * 3}, {0, .3, 0}, {0, .3 * 3, 1.2}, {1.2, 1.2, .6}, {0, 0, 0}};
  const std::vector<Point3> lattice{{3, 0, 0}, {2, 1, 3}, {1, 2, 0}, {2, 3, 1}};
  for (const auto& [points, least] :
       {std::pair{slanted, 0.041230534262764}, std::pair{five, 0.432}, std::pair{lattice, 8.4}}) {
    const CertifiedObb3 c = certified_minimum_obb(points);
    expect_proved(c, points, "known");
    EXPECT_NEAR(volume(c.box), least, least * 1e-12);
    EXPECT_LE(c.excess, 1e-12);
    EXPECT_EQ(minimum_obb(points), c.box);
  }
}

TEST(MinimumObbTest, NoFrameIsSmallerThanTheProof) {
  int near = 0, all = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 6 * more; ++i) {
      Entropy entropy(418, i);
      const auto points = points3(info.family, degeneracies[i % degeneracies.size()], 4 + entropy.below(12), entropy);
      CertifiedObb3 c{{}, Interval(0), 0, 0};
      try {
        c = certified_minimum_obb(points);
      } catch (const BeyondDoubles&) {
        continue;
      }
      const std::string about = std::string(info.name) + " 418 " + std::to_string(i);
      expect_proved(c, points, about);
      const mpq_class least = least_of(c);
      for (int k = 0; k < 4; ++k) ASSERT_LE(least, volume_along(random_quaternion(entropy), points)) << about;
      ASSERT_LE(least, volume_along({1, 0, 0, 0}, points)) << about;
      ASSERT_LE(exact_volume(c.box), exact_volume(fit_obb(upright, points))) << about;
      ++all;
      near += static_cast<int>(c.excess <= 1e-12);
    }
  }
  std::cout << near << " of " << all << " within 1e-12\n";
  EXPECT_GT(3 * near, all);
}

// Of frames in all directions, and turned little by little from the best one.
TEST(MinimumObbTest, NoPairOfEdgesGivesASmallerBox) {
  for (std::uint64_t i = 0; i < 12 * more; ++i) {
    Entropy entropy(419, i);
    std::vector<Point3> points(4 + entropy.below(2));
    const bool lattice = i % 2 == 0;
    const auto number = [&] {
      return lattice ? static_cast<double>(entropy.below(4)) : signed_unit_coordinate(entropy);
    };
    for (Point3& p : points) p = {number(), number(), number()};
    const CertifiedObb3 c = certified_minimum_obb(points);
    expect_proved(c, points, "419 " + std::to_string(i));
    if (convex_hull(points).dimension < 3) {
      EXPECT_EQ(c.least_volume.upper, 0);
      continue;
    }
    const Real least = walked(points);
    ASSERT_LE(c.least_volume.lower, least * (1 + 1e-15L)) << "419 " << i;
    ASSERT_LE(volume(c.box), least * (1 + 1e-12L + c.excess)) << "419 " << i;
    if (lattice) {
      EXPECT_LE(c.excess, 1e-12) << "419 " << i;
    }
  }
}

// Boxes turned by quaternions of integers, whose volume is known in rationals where their corners are doubles.
TEST(MinimumObbTest, IntervalsHoldKnownVolumes) {
  for (std::uint64_t i = 0; i < 40 * more; ++i) {
    Entropy entropy(420, i);
    const auto frame = frame_of(random_quaternion(entropy));
    std::array<mpq_class, 3> half;
    mpq_class truth = 8;
    for (std::size_t k = 0; k < 3; ++k) {
      half[k] = static_cast<long>(1 + entropy.below(9));
      truth *= half[k];
    }
    mpq_class square = 0;
    for (const mpq_class& x : frame[0]) square += x * x;
    std::vector<Point3> corners;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      std::array<double, 3> at{};
      for (std::size_t x = 0; x < 3; ++x) {
        mpq_class sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += frame[k][x] * half[k] * ((corner >> k & 1) != 0 ? 1 : -1);
        at[x] = sum.get_d();  // exact
      }
      corners.push_back({at[0], at[1], at[2]});
    }
    const CertifiedObb3 c = certified_minimum_obb(corners);
    expect_proved(c, corners, "420 " + std::to_string(i));
    // The frame's rows have the length root(square), so this is volume^2 = truth^2 square^3.
    const mpq_class squared = truth * truth * square * square * square, least = least_of(c), most = most_of(c);
    ASSERT_LE(least * least, squared) << "420 " << i;
    ASSERT_GE(most * most, squared) << "420 " << i;
    ASSERT_LE(c.excess, 1e-12) << "420 " << i;
  }
  const std::array tetrahedron{Point3{1, 1, 1}, Point3{1, -1, -1}, Point3{-1, 1, -1}, Point3{-1, -1, 1}};
  const CertifiedObb3 c = certified_minimum_obb(tetrahedron);
  EXPECT_LE(c.least_volume.lower, 8);
  EXPECT_GE(c.least_volume.upper, 8);
  EXPECT_LE(c.excess, 1e-12);
  // Faces and edges that are perpendicular exactly, of which parts of the search shrink to a point.
  std::vector<Point3> lattice;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -3; z <= 3; ++z) {
        if (x * x + y * y + z * z <= 9) lattice.push_back({1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  EXPECT_LE(certified_minimum_obb(lattice).excess, 1e-12);
}

// What the search leaves out on the way from 0 to 1 is beyond zero for all functions that these doubles may stand for,
// and what is made no longer than one is not longer.
TEST(MinimumObbTest, BoundsOfTheSearchHold) {
  using namespace figure::frame;
  std::size_t crossing = 0;
  for (std::uint64_t i = 0; i < 400 * more; ++i) {
    Entropy entropy(424, i);
    const double error = std::ldexp(unit_coordinate(entropy), -static_cast<int>(30 + entropy.below(20)));
    const auto near = [&] {
      return entropy.below(3) == 0 ? error * signed_unit_coordinate(entropy) * 4 : signed_unit_coordinate(entropy);
    };
    const std::array f{near(), near()}, g{near(), near()};
    const mpq_class share(beyond_zero(f, g, error));
    if (share > 0) {
      const double side = f[0] < 0 ? -1 : 1;
      for (std::size_t k = 0; k < 2; ++k) {
        const mpq_class from = mpq_class(side * f[k]) - mpq_class(error),
                        to = mpq_class(side * g[k]) - mpq_class(error);
        ASSERT_GE(from + (to - from) * share, 0) << "424 " << i;
        crossing += to < 0 ? 1 : 0;
      }
    }
    const double square = 0.1 + unit_coordinate(entropy);
    const mpq_class factor(shortening(square, error));
    const mpq_class longest = factor * factor * (mpq_class(square) + mpq_class(error));
    ASSERT_LE(longest, 1) << "424 " << i;
    ASSERT_GE(longest, 1 - mpq_class(0x1p-48)) << "424 " << i;
  }
  EXPECT_GE(crossing, 50 * more);
}

TEST(MinimumObbTest, PowersOfTwoChangeUnitsAlone) {
  Entropy entropy(421);
  std::vector<Point3> points;
  for (int i = 0; i < 9; ++i)
    points.push_back(
        {signed_unit_coordinate(entropy), signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)});
  const CertifiedObb3 c = certified_minimum_obb(points);
  EXPECT_EQ(c.unit, 0);
  for (const int exponent : {-900, -400, -40, 40, 400, 1000}) {
    std::vector<Point3> scaled = points;
    for (Point3& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const CertifiedObb3 s = certified_minimum_obb(scaled);
    EXPECT_EQ(s.box.axes, c.box.axes) << exponent;
    EXPECT_EQ(s.excess, c.excess) << exponent;
    EXPECT_EQ(least_of(s), least_of(c) * two_to(3 * exponent)) << exponent;
    EXPECT_EQ(most_of(s), most_of(c) * two_to(3 * exponent)) << exponent;
  }
}

// A needle an ulp thin: the axes of the box are doubles, so that the bound is what is left.
TEST(MinimumObbTest, SaysHowNearWhereDoublesEnd) {
  std::vector<Point3> needle;
  for (int i = 0; i < 9; ++i) needle.push_back({1 + i * (i % 3) * 0x1p-52, 1 + i * i % 4 * 0x1p-52, i * .3});
  const CertifiedObb3 thin = certified_minimum_obb(needle);
  expect_proved(thin, needle, "needle");
  EXPECT_LE(exact_volume(thin.box), exact_volume(fit_obb(upright, needle)));
  EXPECT_GT(thin.excess, 0);
  EXPECT_LE(thin.excess, 5);  // a box of least volume holds six times the hull at most, and that is known
  // A search that is cut short says so as well.
  Entropy entropy(422);
  const auto points = points3(Family::uniform, Degeneracy::cospherical, 60, entropy);
  const CertifiedObb3 whole = certified_minimum_obb(points), cut = certified_minimum_obb(points, {.most_parts = 50}),
                      none = certified_minimum_obb(points, {.most_vertices = 0});
  EXPECT_LE(whole.excess, 1e-12);
  EXPECT_GT(cut.excess, 1e-12);
  EXPECT_GT(none.excess, 1e-12);
  for (const CertifiedObb3& c : {whole, cut, none}) expect_proved(c, points, "cut");
  EXPECT_LE(least_of(cut), exact_volume(whole.box));
  // One of which the axes that doubles find are 10^16 times as thick as the needle.
  Entropy thin_entropy(77, 2);
  const auto points_near_half = points3(Family::near_half, degeneracies[0], 33, thin_entropy);
  EXPECT_LE(certified_minimum_obb(points_near_half).excess, 100);
  const std::vector<Point3> one(3, Point3{1, 2, 3});
  EXPECT_EQ(certified_minimum_obb(one).excess, 0);
  EXPECT_EQ(certified_minimum_obb(one).least_volume.upper, 0);
}

// The least of several merged boxes, by volumes that doubles do not hold as well.
TEST(MinimumObbTest, MergesChooseAlikeAtAnyScale) {
  for (std::uint64_t i = 0; i < 20 * more; ++i) {
    Entropy entropy(424, i);
    const Obb3 a = obb_cases::turned(entropy), b = obb_cases::turned(entropy), both = merge(a, b);
    for (const int exponent : {-420, 420}) {
      const auto scaled = [exponent](Obb3 box) {
        for (double* x : {&box.center.x, &box.center.y, &box.center.z, &box.half.x, &box.half.y, &box.half.z})
          *x = std::ldexp(*x, exponent);
        return box;
      };
      ASSERT_EQ(merge(scaled(a), scaled(b)), scaled(both)) << "424 " << i;
    }
  }
}

// No rectangle along the axes of the plane is smaller, though an edge's direction is rounded.
TEST(MinimumObbTest, RectanglesAreNoLargerThanUprightOnes) {
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 20 * more; ++i) {
      Entropy entropy(423, i);
      const auto points = points2(info.family, degeneracies[i % degeneracies.size()], 3 + entropy.below(20), entropy);
      const auto area_of = [](const Obb2& b) {
        const mpq_class det =
            mpq_class(b.axes[0].x) * mpq_class(b.axes[1].y) - mpq_class(b.axes[0].y) * mpq_class(b.axes[1].x);
        return mpq_class(abs(mpq_class(b.half.x) * mpq_class(b.half.y) * det));
      };
      try {
        const Obb2 straight = fit_obb({Vector2{1, 0}, Vector2{0, 1}}, points);
        ASSERT_LE(area_of(minimum_obb(points)), area_of(straight)) << info.name << " 423 " << i;
      } catch (const BeyondDoubles&) {
        continue;
      }
    }
  }
}

}  // namespace
}  // namespace plumb::shape_cases
