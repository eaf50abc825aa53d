// Does the least box depend on the points alone, is it as near to the least as its header promises, and which boxes
// along the axes of space are smaller?
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>

#include "figure/basic/shape_cases.hpp"
#include "figure/obb/cases.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/obb/fits.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb::shape_cases {
namespace {

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, std::initializer_list<double> numbers) {
  for (const double x : numbers) bits.push_back(std::bit_cast<std::uint64_t>(x));
}
Bits bits_of(const Obb3& b) {
  Bits bits;
  add(bits, {b.center.x, b.center.y, b.center.z, b.half.x, b.half.y, b.half.z});
  for (const Vector3& a : b.axes) add(bits, {a.x, a.y, a.z});
  return bits;
}
Bits bits_of(const Obb2& b) {
  Bits bits;
  add(bits, {b.center.x, b.center.y, b.half.x, b.half.y, b.axes[0].x, b.axes[0].y, b.axes[1].x, b.axes[1].y});
  return bits;
}
Bits bits_of(const CertifiedObb3& c) {
  Bits bits = bits_of(c.box);
  add(bits, {c.least_volume.lower, c.least_volume.upper, c.excess, static_cast<double>(c.unit)});
  return bits;
}

/// What an answer is in bits, nothing where doubles do not hold it.
template <class Points, class Question>
Bits answered(const Points& points, Question question) {
  try {
    return bits_of(question(points));
  } catch (const BeyondDoubles&) {
    return {};
  }
}

double with_some_sign(double x, Entropy& entropy) { return x == 0 && entropy.coin() ? -x : x; }
Point2 with_some_sign(const Point2& p, Entropy& e) { return {with_some_sign(p.x, e), with_some_sign(p.y, e)}; }
Point3 with_some_sign(const Point3& p, Entropy& e) {
  return {with_some_sign(p.x, e), with_some_sign(p.y, e), with_some_sign(p.z, e)};
}

/// The same set in another order, some points twice, zeros of any sign.
template <class Point>
std::vector<Point> told_otherwise(std::vector<Point> points, Entropy& entropy) {
  for (std::size_t twice = entropy.below(4); twice-- > 0;) points.push_back(points[entropy.below(points.size())]);
  for (std::size_t i = points.size(); i-- > 1;) std::swap(points[i], points[entropy.below(i + 1)]);
  for (Point& p : points) p = with_some_sign(p, entropy);
  return points;
}

TEST(MinimumObbLawsTest, TheOrderOfThePointsDoesNotShow) {
  std::size_t shuffles = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 12 * more; ++i) {
      Entropy entropy(431, i);
      const Degeneracy degeneracy = degeneracies[i % degeneracies.size()];
      const auto solid = points3(info.family, degeneracy, 4 + entropy.below(12), entropy);
      const auto flat = points2(info.family, degeneracy, 3 + entropy.below(12), entropy);
      const std::string about = std::string(info.name) + " 431 " + std::to_string(i);
      const auto least = [](const auto& points) { return certified_minimum_obb(points); };
      const auto rectangle = [](const std::vector<Point2>& points) { return minimum_obb(points); };
      const std::array fits{+[](const std::vector<Point3>& p) { return fit_obb_hull_vertices(p); },
                            +[](const std::vector<Point3>& p) { return fit_obb_hull_surface(p); },
                            +[](const std::vector<Point3>& p) { return fit_obb_around_principal(p); }};
      const Bits box = answered(solid, least), sides = answered(flat, rectangle);
      for (int k = 0; k < 5; ++k, ++shuffles) {
        const auto shuffled = told_otherwise(solid, entropy);
        ASSERT_EQ(answered(shuffled, least), box) << about;
        ASSERT_EQ(answered(told_otherwise(flat, entropy), rectangle), sides) << about;
        for (const auto fit : fits) ASSERT_EQ(answered(shuffled, fit), answered(solid, fit)) << about;
      }
    }
  }
  EXPECT_GE(shuffles, 592U);
}

// By how much the box is as thick as long, and how far from the origin it is beside its length.
struct Shape {
  double thickness, distance, longest;
};
Shape shape_of(const Obb3& box) {
  std::array<double, 3> half{std::fabs(box.half.x), std::fabs(box.half.y), std::fabs(box.half.z)};
  for (std::size_t k = 0; k < 3; ++k) half[k] *= std::hypot(box.axes[k].x, box.axes[k].y, box.axes[k].z);
  std::ranges::sort(half);
  const double far = std::max({std::fabs(box.center.x), std::fabs(box.center.y), std::fabs(box.center.z)});
  return {half[0] / half[2], far / half[2], half[2]};
}
bool is_promised(const Shape& s) {
  return s.thickness > 0.002 && s.distance < 1000 && s.longest > 0x1p-900 && s.longest < 0x1p1000;
}

// Excess counts from what is proved, so it tells how well the search and the box did, whoever is the judge.
TEST(MinimumObbLawsTest, ExcessIsBelowThePromiseInEveryFamily) {
  std::size_t promised = 0, thin = 0;
  double worst = 0;
  const auto look = [&](const std::vector<Point3>& points, const std::string& about) {
    CertifiedObb3 c{{}, Interval(0), 0, 0};
    try {
      c = certified_minimum_obb(points);
    } catch (const BeyondDoubles&) {
      return;
    }
    if (c.least_volume.upper == 0 || !is_promised(shape_of(c.box))) return;
    ++promised;
    thin += shape_of(c.box).thickness < 0.05 ? 1 : 0;
    worst = std::max(worst, c.excess);
    EXPECT_LE(c.excess, 1e-12) << about;
  };
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 40 * more; ++i) {
      Entropy entropy(432, i);
      const auto n = 4 + entropy.below(i % 2 == 0 ? 12 : 60);
      look(points3(info.family, degeneracies[i % degeneracies.size()], n, entropy),
           std::string(info.name) + " 432 " + std::to_string(i));
    }
  }
  // Of all thicknesses down to where the promise ends, turned at random.
  for (std::uint64_t i = 0; i < 120 * more; ++i) {
    Entropy entropy(433, i);
    const Obb3 frame = obb_cases::turned(entropy);
    const double thick = std::exp2(-9 * unit_coordinate(entropy)), wide = std::exp2(-4 * unit_coordinate(entropy));
    std::vector<Point3> points(4 + entropy.below(10));
    for (Point3& p : points) {
      const double a = signed_unit_coordinate(entropy), b = wide * signed_unit_coordinate(entropy),
                   c = thick * signed_unit_coordinate(entropy);
      const auto& [u, v, w] = frame.axes;
      p = {a * u.x + b * v.x + c * w.x, a * u.y + b * v.y + c * w.y, a * u.z + b * v.z + c * w.z};
    }
    look(points, "433 " + std::to_string(i));
  }
  std::cout << promised << " sets, " << thin << " of them thin; at most " << worst << "\n";
  EXPECT_GE(promised, 250U * more);
  EXPECT_GE(thin, 40U * more);
}

mpq_class exact_volume(const Obb3& box) {
  const auto u = obb_cases::rational(box.axes[0]), v = obb_cases::rational(box.axes[1]),
             w = obb_cases::rational(box.axes[2]);
  const mpq_class det =
      u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  return abs(8 * mpq_class(box.half.x) * mpq_class(box.half.y) * mpq_class(box.half.z) * det);
}

// One coordinate of the points.
struct Range {
  double least, most;
  [[nodiscard]] mpq_class width() const { return mpq_class(most) - mpq_class(least); }
};
std::array<Range, 3> ranges_of(const std::vector<Point3>& points) {
  std::array<Range, 3> all;
  const std::array<double Point3::*, 3> coordinates{&Point3::x, &Point3::y, &Point3::z};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [least, most] = std::ranges::minmax(points, {}, coordinates[k]);
    all[k] = {least.*coordinates[k], most.*coordinates[k]};
  }
  return all;
}
double rounded_up(const mpq_class& x) {
  double d = x.get_d();  // toward zero
  return mpq_class(d) < x ? std::nextafter(d, INFINITY) : d;
}
// The least half extent around any double.
mpq_class least_half(const Range& r) {
  const double middle = r.least / 2 + r.most / 2;
  mpq_class best;
  for (const double center : {std::nextafter(middle, -INFINITY), middle, std::nextafter(middle, INFINITY)}) {
    const mpq_class above = mpq_class(r.most) - mpq_class(center), below = mpq_class(center) - mpq_class(r.least);
    const mpq_class half(rounded_up(above > below ? above : below));
    if (best == 0 || half < best) best = half;
  }
  return best;
}

TEST(MinimumObbLawsTest, NoneAlongTheAxesOfSpaceIsSmallerButOneWithEndsByAnUlp) {
  std::size_t smaller = 0, needles = 0;
  const auto look = [&](const std::vector<Point3>& points, const std::string& about) {
    Obb3 box{};
    try {
      box = minimum_obb(points);
    } catch (const BeyondDoubles&) {
      return;
    }
    const mpq_class volume = exact_volume(box);
    mpq_class upright = 8, with_ends = 1, wider = 1;
    for (const Range& r : ranges_of(points)) {
      if (r.width() == 0) return;
      const mpq_class half = least_half(r), middle = (mpq_class(r.least) + mpq_class(r.most)) / 2;
      const double center = std::fabs(middle.get_d()), half_double = half.get_d();
      const double ulp = std::nextafter(center, INFINITY) - center;
      const double rounding = half_double - std::nextafter(half_double, 0);
      upright *= half;
      with_ends *= r.width();
      wider *= r.width() + mpq_class(ulp) + 2 * mpq_class(rounding);
    }
    ASSERT_LE(volume, upright) << about;
    ASSERT_LE(volume, wider) << about;
    smaller += with_ends < volume ? 1 : 0;
    needles += volume > mpq_class(1.3) * with_ends ? 1 : 0;
  };
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 20 * more; ++i) {
      Entropy entropy(434, i);
      look(points3(info.family, degeneracies[i % degeneracies.size()], 4 + entropy.below(12), entropy),
           std::string(info.name) + " 434 " + std::to_string(i));
    }
  }
  for (std::uint64_t i = 0; i < 60 * more; ++i) {
    Entropy entropy(435, i);
    std::vector<Point3> needle(4 + entropy.below(6));
    const auto near_half = [&] { return 0.5 + static_cast<double>(entropy.below(8)) * 0x1p-53; };
    for (Point3& p : needle) p = {near_half(), near_half(), i % 2 == 0 ? near_half() : unit_coordinate(entropy)};
    look(needle, "435 " + std::to_string(i));
  }
  std::vector<Point3> cube;
  for (int corner = 0; corner < 8; ++corner) {
    const auto end = [&](int k) { return 0.5 + (corner >> k & 1) * 3 * 0x1p-53; };
    cube.push_back({end(0), end(1), end(2)});
  }
  look(cube, "a cube of three ulps");
  EXPECT_GE(smaller, 5U * more);
  EXPECT_GE(needles, 1U * more);  // the law that knew no ends of boxes was false
}

}  // namespace
}  // namespace plumb::shape_cases
