// Fillings of least area, against all triangulations of a loop; equally large ones are told where they differ.
#include "surface/repair/least_area.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "plumb/arith/rational.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb::surface {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// All triangulations of the part of a loop from i to k.
std::vector<Filling> all_fillings(std::uint32_t i, std::uint32_t k) {
  if (k - i < 2) return {Filling{}};
  std::vector<Filling> all;
  for (std::uint32_t j = i + 1; j < k; ++j)
    for (const Filling& one : all_fillings(i, j))
      for (const Filling& other : all_fillings(j, k)) {
        Filling filling = one;
        filling.insert(filling.end(), other.begin(), other.end());
        filling.push_back({i, j, k});
        all.push_back(std::move(filling));
      }
  return all;
}

/// Twice the area, of points whose coordinates are integers.
mpf_class area_of(const std::vector<Point3>& points, const Filling& filling) {
  mpf_class sum(0, 1024);
  for (const auto& [a, b, c] : filling) {
    const auto part = [&, &a = a, &b = b, &c = c](double Point3::*u, double Point3::*v) {
      return mpz_class((points[b].*u - points[a].*u) * (points[c].*v - points[a].*v) -
                       (points[b].*v - points[a].*v) * (points[c].*u - points[a].*u));
    };
    const mpz_class x = part(&Point3::y, &Point3::z), y = part(&Point3::z, &Point3::x),
                    z = part(&Point3::x, &Point3::y);
    sum += sqrt(mpf_class(x * x + y * y + z * z, 1024));
  }
  return sum;
}

bool differ(const mpf_class& a, const mpf_class& b) { return abs(a - b) > mpf_class("1e-200", 1024); }

/// Is a point of triangle s, with these weights, in triangle t?
bool is_in(const std::vector<Point3>& points, const Corners& s, const std::array<int, 3>& weights, const Corners& t) {
  const auto coordinate = [&](double Point3::*x) {
    return (Rational(points[s[0]].*x) * Rational(weights[0]) + Rational(points[s[1]].*x) * Rational(weights[1]) +
            Rational(points[s[2]].*x) * Rational(weights[2])) /
           Rational(weights[0] + weights[1] + weights[2]);
  };
  using Exact = std::array<Rational, 3>;
  const Exact p{coordinate(&Point3::x), coordinate(&Point3::y), coordinate(&Point3::z)};
  const auto exact = [&](std::uint32_t v) { return Exact{points[v].x, points[v].y, points[v].z}; };
  const auto minus = [](const Exact& a, const Exact& b) { return Exact{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto cross = [](const Exact& a, const Exact& b) {
    return Exact{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto dot = [](const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Exact a = exact(t[0]), b = exact(t[1]), c = exact(t[2]), n = cross(minus(b, a), minus(c, a));
  if (!(dot(n, minus(p, a)) == Rational(0))) return false;
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
    if (dot(cross(minus(to, from), minus(p, from)), n) < Rational(0)) return false;
  return true;
}

/// Seen at some points of each triangle.
bool seem_one_surface(const std::vector<Point3>& points, const Filling& one, const Filling& other) {
  for (const auto& [from, to] : {std::pair{&one, &other}, {&other, &one}})
    for (const Corners& s : *from)
      for (const std::array<int, 3>& w :
           {std::array{1, 1, 1}, {50, 3, 2}, {3, 50, 2}, {3, 2, 50}, {30, 31, 1}, {1, 40, 39}})
        if (std::ranges::none_of(*to, [&](const Corners& t) { return is_in(points, s, w, t); })) return false;
  return true;
}

/// Do two triangles of one plane turn against each other?
bool is_folded(const std::vector<Point3>& points, const Filling& filling) {
  const auto normal = [&](const Corners& t) {
    const auto part = [&](double Point3::*u, double Point3::*v) {
      return (points[t[1]].*u - points[t[0]].*u) * (points[t[2]].*v - points[t[0]].*v) -
             (points[t[1]].*v - points[t[0]].*v) * (points[t[2]].*u - points[t[0]].*u);
    };
    return std::array{part(&Point3::y, &Point3::z), part(&Point3::z, &Point3::x), part(&Point3::x, &Point3::y)};
  };
  for (const Corners& s : filling)
    for (const Corners& t : filling) {
      const auto m = normal(s), n = normal(t);  // exact, of small integers
      const bool are_parallel = m[0] * n[1] == m[1] * n[0] && m[1] * n[2] == m[2] * n[1] && m[2] * n[0] == m[0] * n[2];
      if (are_parallel && m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0) return true;
    }
  return false;
}

/// Then a corner may lie on a diagonal, and one outline have several edges.
bool has_collinear(const std::vector<Point3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (collinear(points[i], points[j], points[k])) return true;
  return false;
}

TEST(LeastArea, OfAllTriangulations) {
  std::size_t tied = 0, several = 0, none = 0, plain = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<Point3> points;
    const std::uint32_t n = 4 + seed % 4, range = seed % 3 == 0 ? 2 : seed % 3 == 1 ? 4 : 100;
    while (points.size() < n) {
      const Point3 p{double(random() % range), double(random() % range), double(random() % range)};
      if (std::ranges::count(points, p) == 0) points.push_back(p);
      if (range == 2 && points.size() == 8) break;
    }
    const std::uint32_t a = std::uint32_t(random() % n), b = std::uint32_t(random() % n);
    const TakenDiagonal is_taken = [&](std::uint32_t i, std::uint32_t k) {
      return seed % 25 == 0 || (seed % 5 == 0 && ((i == a && k == b) || (i == b && k == a)));
    };
    std::vector<std::uint32_t> loop(n);
    for (std::uint32_t i = 0; i < n; ++i) loop[i] = i;
    std::vector<Filling> allowed;
    for (Filling& f : all_fillings(0, n - 1)) {
      const bool is_bad = std::ranges::any_of(f, [&](const Corners& t) {
        const auto diagonal = [&](std::uint32_t i, std::uint32_t k) {
          return k - i > 1 && k - i + 1 < n && is_taken(i, k);
        };
        return collinear(points[t[0]], points[t[1]], points[t[2]]) || diagonal(t[0], t[1]) || diagonal(t[1], t[2]) ||
               diagonal(t[0], t[2]);
      });
      if (!is_bad) allowed.push_back(std::move(f));
    }
    const auto found = least_area_filling(points, loop, is_taken);
    ASSERT_EQ(found.has_value(), !allowed.empty());
    none += allowed.empty();
    if (!found) continue;
    ASSERT_EQ(found->filling.size(), n - 2);
    const mpf_class area = area_of(points, found->filling);
    bool others = false, is_tied = false, folded = has_collinear(points);
    for (const Filling& f : allowed) {
      const mpf_class other = area_of(points, f);
      EXPECT_FALSE(differ(area, other) && other < area);
      if (differ(area, other)) continue;
      const bool same =
          std::ranges::all_of(f, [&](const Corners& t) { return std::ranges::count(found->filling, t) != 0; });
      others = others || !same;
      is_tied = is_tied || !seem_one_surface(points, f, found->filling);
      folded = folded || is_folded(points, f);
    }
    if (folded) {  // which of them are one surface is a matter of words
      EXPECT_TRUE(found->tied || !is_tied);
    } else {
      EXPECT_EQ(found->tied, is_tied);
    }
    plain += !folded;
    tied += is_tied, several += others;
  }
  EXPECT_GT(tied, 20U);
  EXPECT_GT(several, tied + 5) << "and some that are the same surface";
  EXPECT_GT(none, 0U);
  EXPECT_GT(plain, 150U);
}

TEST(LeastArea, WhereDoublesEnd) {
  for (const int power : {1000, 500, -500, -1000}) {
    const auto at = [&](double x, double y, double z) {
      return Point3{std::ldexp(x, power), std::ldexp(y, power), std::ldexp(z, power)};
    };
    const std::vector<Point3> points{at(0, 0, 0), at(1, 0, 1), at(1, 1, 0), at(0, 1, 1 + 0x1p-40), {0x1p-1074, 0, 0}};
    const std::vector<std::uint32_t> loop{0, 1, 2, 3};
    const auto never = [](std::uint32_t, std::uint32_t) { return false; };
    const auto found = least_area_filling(points, loop, never);
    ASSERT_TRUE(found && !found->tied) << power;
    EXPECT_EQ(std::ranges::count(found->filling, Corners{0, 2, 3}), 1) << "the shorter diagonal";
    const std::vector<std::uint32_t> far{4, 1, 2, 3};  // its coordinates cannot be scaled alike
    EXPECT_EQ(least_area_filling(points, far, never)->filling.size(), 2U);
  }
}

TEST(LeastArea, ALongLoop) {
  std::vector<Point3> points;
  std::vector<std::uint32_t> loop;
  for (std::uint32_t i = 0; i < 120; ++i) {
    points.push_back({std::cos(i * 0.05), std::sin(i * 0.05), 0.1 * std::sin(i * 0.2)});
    loop.push_back(i);
  }
  const auto found = least_area_filling(points, loop, [](std::uint32_t, std::uint32_t) { return false; });
  ASSERT_TRUE(found);
  EXPECT_EQ(found->filling.size(), 118U);
}

}  // namespace
}  // namespace plumb::surface
