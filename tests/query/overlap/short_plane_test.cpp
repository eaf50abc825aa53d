// Triangles of one plane on a lattice of few bits: what is told is so, and told of nearly all of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "plumb/certify/direction.hpp"
#include "query/overlap/lattice3.hpp"
#include "query/overlap/relation_counts.hpp"

namespace plumb::query {
namespace {

struct Both {
  Triangle3 a, b;
};

/// Corners of a plane of a lattice, none of which takes more bits than these; now and then one is moved by a unit.
Both lattice_pair(Entropy& entropy, int bits) {
  // Multiples of two vectors from a corner, by two at the most: five times the largest number.
  const std::int64_t most = ((std::int64_t{1} << bits) - 1) / 5;
  std::array<std::array<std::int64_t, 3>, 3> base{};
  for (auto& vector : base) {
    for (auto& x : vector) x = entropy.within(most);
  }
  std::array<double, 18> all{};
  const bool is_moved = entropy.below(4) == 0;
  const std::size_t moved = entropy.below(18);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::int64_t u = entropy.within(2), v = entropy.below(6) == 0 ? 0 : entropy.within(2);
    for (std::size_t k = 0; k < 3; ++k) {
      std::int64_t x = base[0][k] + u * base[1][k] + v * base[2][k];
      if (is_moved && 3 * i + k == moved) x += x > 0 ? -1 : 1;
      all[3 * i + k] = static_cast<double>(x);
    }
  }
  return std::bit_cast<Both>(all);
}

/// The largest of the volumes of b's corners over a's plane, which are integers.
double largest_volume(const Both& t) {
  using Wide = __int128;
  const auto from = [&](const Point3& p) {
    return std::array<Wide, 3>{static_cast<Wide>(p.x - t.a.a.x), static_cast<Wide>(p.y - t.a.a.y),
                               static_cast<Wide>(p.z - t.a.a.z)};
  };
  const auto u = from(t.a.b), v = from(t.a.c);
  double most = 0;
  for (const Point3& p : {t.b.a, t.b.b, t.b.c}) {
    const auto w = from(p);
    const Wide volume =
        w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) + w[2] * (u[0] * v[1] - u[1] * v[0]);
    most = std::fmax(most, std::fabs(static_cast<double>(volume)));
  }
  return most;
}

Both scaled(const Both& t, double by) {
  auto all = std::bit_cast<std::array<double, 18>>(t);
  for (double& x : all) x *= by;
  return std::bit_cast<Both>(all);
}

TEST(ShortPlane, WhatIsToldIsSo) {
  Counts counts;
  int told = 0, level = 0, off = 0;
  for (std::uint64_t i = 0; i < 1500 * shape_cases::more; ++i) {
    Entropy entropy(81, i);
    const int bits = 3 + static_cast<int>(entropy.below(22));
    const Both t = lattice_pair(entropy, bits);
    const double error = largest_volume(t), by = std::ldexp(1.0, static_cast<int>(entropy.within(300)));
    const Both at = scaled(t, by);
    const auto answer = by_short_plane(at.a, at.b, error * by * by * by);
    off += error > 0 ? 1 : 0;
    const bool is_due = error == 0 && !collinear(t.a.a, t.a.b, t.a.c) && !(t.b.a == t.b.b && t.b.b == t.b.c);
    EXPECT_TRUE(answer || !is_due) << "Entropy(81, " << i << ")";
    level += is_due ? 1 : 0, told += answer ? 1 : 0;
    EXPECT_FALSE(error > 0 && answer.has_value()) << "Entropy(81, " << i << ")";
    if (!answer) continue;
    const Relation expected = oracle::rational_relation(t.a, t.b);
    counts.add(expected);
    ASSERT_EQ(*answer, expected) << "Entropy(81, " << i << ")";
  }
  std::printf("told of %d, due of %d; %d are not level\n", told, level, off);
  EXPECT_GE(level, 500);
  EXPECT_GE(off, 150);
  expect_all_answers(counts, 1000 * shape_cases::more);
}

TEST(ShortPlane, TheFirstMayBeASegment) {
  Counts counts;
  int told = 0, off = 0;
  for (std::uint64_t i = 0; i < 1500 * shape_cases::more; ++i) {
    Entropy entropy(82, i);
    Both t = lattice_pair(entropy, 3 + static_cast<int>(entropy.below(22)));
    // A corner twice, or three of a line.
    if (entropy.coin())
      t.a.c = t.a.a;
    else
      t.a.c = {2 * t.a.b.x - t.a.a.x, 2 * t.a.b.y - t.a.a.y, 2 * t.a.b.z - t.a.a.z};
    const auto answer = by_short_plane(t.a, t.b, 0);
    off += answer ? 0 : 1, told += answer ? 1 : 0;
    if (!answer) continue;
    const Relation expected = oracle::rational_relation(t.a, t.b);
    counts.add(expected);
    ASSERT_EQ(*answer, expected) << "Entropy(82, " << i << ")";
  }
  std::printf("told of %d, not of %d\n", told, off);
  EXPECT_GE(off, 100);
  expect_all_answers(counts, 700 * shape_cases::more);
  // Off the plane by a volume of 2^64, and of 2^65: not zero, though the words of them are.
  constexpr double leg = 0x1p23;
  const Triangle3 b{{0, 0, 0}, {leg, 0, 0}, {0, leg, 0}};
  for (const double height : {0x1p18, -0x1p18, 0x1p19}) {
    const Triangle3 above{{1, 1, height}, {5, 1, height}, {9, 1, height}};
    EXPECT_FALSE(by_short_plane(above, b, 0).has_value()) << height;
    EXPECT_EQ(relate(above, b), Relation::disjoint) << height;
    const Triangle3 through{{1, 1, 0}, {1, 1, height}, {1, 1, 2 * height}};
    EXPECT_FALSE(by_short_plane(through, b, 0).has_value()) << height;
    EXPECT_EQ(relate(through, b), Relation::touching) << height;
  }
  EXPECT_EQ(by_short_plane({{1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, b, 0), Relation::overlapping);
}

TEST(ShortPlane, WhatIsLongIsLeftToOthers) {
  const Triangle3 a{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, b{{1, 1, 0}, {9, 1, 0}, {1, 9, 0}};
  EXPECT_EQ(by_short_plane(a, b, 1), Relation::overlapping);
  // Volumes that are not known to fit in a word.
  EXPECT_FALSE(by_short_plane(a, b, 0x1p70).has_value());
  // Of 24 bits, and of 25; each place is looked at.
  constexpr double longest = 0x1p24 - 1;
  EXPECT_EQ(by_short_plane({{0, 0, 0}, {longest, 0, 0}, {0, longest, 0}}, b, 1), Relation::overlapping);
  for (std::size_t i = 0; i < 18; ++i) {
    auto numbers = std::bit_cast<std::array<double, 18>>(Both{{{0, 0, 0}, {longest, 0, 0}, {0, longest, 0}}, b});
    numbers[i] += 0.5;
    const Both at = std::bit_cast<Both>(numbers);
    EXPECT_FALSE(by_short_plane(at.a, at.b, 1).has_value()) << i;
  }
  for (const double by : {0x1p-1074, 0x1p-500, 0x1p500, 0x1p1019}) {
    const Both at = scaled({a, b}, by);
    EXPECT_FALSE(by_short_plane(at.a, at.b, 0).has_value()) << by;
  }
}

}  // namespace
}  // namespace plumb::query
