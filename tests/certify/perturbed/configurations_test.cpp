// Law 3 of include/plumb/certify/perturbed.hpp: the answers about many points fit together, as those about points that
// really lie so do.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "plumb/arith/big.hpp"
#include "plumb/certify/perturbed.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

std::vector<std::uint64_t> shuffled(std::size_t n, Entropy& e) {
  std::vector<std::uint64_t> indices(n);
  for (std::size_t i = 0; i < n; ++i) indices[i] = i;
  for (std::size_t i = n; i > 1; --i) std::swap(indices[i - 1], indices[e.below(i)]);
  return indices;
}

/// `n` points of a grid of `size` steps, some of them the same; all the same where the size is 1.
std::vector<Indexed2> points2(std::size_t n, std::uint64_t size, Entropy& e) {
  std::vector<Indexed2> points;
  for (const std::uint64_t index : shuffled(n, e)) {
    points.push_back({{static_cast<double>(e.below(size)), static_cast<double>(e.below(size))}, index});
  }
  return points;
}
std::vector<Indexed3> points3(std::size_t n, std::uint64_t size, Entropy& e) {
  std::vector<Indexed3> points;
  const auto any = [&] { return static_cast<double>(e.below(size)); };
  for (const std::uint64_t index : shuffled(n, e)) points.push_back({{any(), any(), any()}, index});
  return points;
}

/// Signs of r-tuples of n points and of a further one, number n, at infinity: it is beyond every plane, and outside of
/// every sphere.
struct Chirotope {
  std::size_t r, n;
  std::map<std::vector<std::size_t>, Sign> sign;  // of ascending tuples

  [[nodiscard]] Sign of(std::vector<std::size_t> t) const {
    Sign parity = Sign::positive;
    for (std::size_t i = 0; i < t.size(); ++i) {
      for (std::size_t k = i + 1; k < t.size(); ++k) {
        if (t[k] < t[i]) {
          std::swap(t[i], t[k]);
          parity = -parity;
        }
      }
    }
    return parity * sign.at(t);
  }
};

/// Calls visit with every ascending k-tuple of numbers below n.
template <class Visit>
void for_each_tuple(std::size_t n, std::size_t k, const Visit& visit, std::vector<std::size_t> t = {}) {
  if (t.size() == k) return visit(t);
  for (std::size_t i = t.empty() ? 0 : t.back() + 1; i < n; ++i) {
    t.push_back(i);
    for_each_tuple(n, k, visit, t);
    t.pop_back();
  }
}

Chirotope chirotope(const std::vector<Indexed2>& p) {
  Chirotope c{4, p.size(), {}};
  for_each_tuple(p.size() + 1, 4, [&](const auto& t) {
    c.sign[t] = t[3] == p.size() ? -orient2d(perturbed, p[t[0]], p[t[1]], p[t[2]])
                                 : incircle(perturbed, p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
  });
  return c;
}
Chirotope chirotope(const std::vector<Indexed3>& p) {
  Chirotope c{5, p.size(), {}};
  for_each_tuple(p.size() + 1, 5, [&](const auto& t) {
    c.sign[t] = t[4] == p.size() ? -orient3d(perturbed, p[t[0]], p[t[1]], p[t[2]], p[t[3]])
                                 : insphere(perturbed, p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[t[4]]);
  });
  return c;
}

/// Of determinants, ab.cd - ac.bd + ad.bc = 0 beside any common columns: three terms without zeros differ in sign.
void expect_grassmann_pluecker(const Chirotope& c, std::uint64_t number) {
  for_each_tuple(c.n + 1, c.r - 2, [&](const std::vector<std::size_t>& columns) {
    for_each_tuple(c.n + 1, 4, [&](const std::vector<std::size_t>& q) {
      for (const std::size_t i : q) {
        if (std::ranges::count(columns, i) != 0) return;
      }
      const auto of = [&](std::size_t i, std::size_t k) {
        std::vector<std::size_t> t = columns;
        t.insert(t.end(), {q[i], q[k]});
        return c.of(t);
      };
      const Sign first = of(0, 1) * of(2, 3), second = -(of(0, 2) * of(1, 3)), third = of(0, 3) * of(1, 2);
      ASSERT_NE(first, Sign::zero);
      ASSERT_FALSE(first == second && second == third) << number;
    });
  });
}

TEST(PerturbedConfigurations, CirclesAndLinesAreThoseOfAnOrientedMatroid) {
  for (std::uint64_t number = 0; number < 150 && !HasFatalFailure(); ++number) {
    Entropy e(5, number);
    expect_grassmann_pluecker(chirotope(points2(7, 1 + number % 4, e)), number);
  }
}

TEST(PerturbedConfigurations, SpheresAndPlanesAreThoseOfAnOrientedMatroid) {
  for (std::uint64_t number = 0; number < 40 && !HasFatalFailure(); ++number) {
    Entropy e(6, number);
    expect_grassmann_pluecker(chirotope(points3(8, 1 + number % 3, e)), number);
  }
}

// Knuth, "Axioms and hulls": what holds of counterclockwise triples.
TEST(PerturbedConfigurations, TriplesAreACounterclockwiseSystem) {
  for (std::uint64_t number = 0; number < 50; ++number) {
    Entropy e(7, number);
    constexpr std::size_t n = 6;
    const std::vector<Indexed2> points = points2(n, 1 + number % 4, e);
    std::array<std::array<std::array<bool, n>, n>, n> ccw{};
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        for (std::size_t c = 0; c < n; ++c)
          if (a != b && b != c && a != c)
            ccw[a][b][c] = orient2d(perturbed, points[a], points[b], points[c]) == Sign::positive;
    for_each_tuple(n, 4, [&](std::vector<std::size_t> t) {
      do {
        const auto [p, q, r, in] = std::array{t[0], t[1], t[2], t[3]};
        ASSERT_TRUE(ccw[p][q][r] == ccw[q][r][p] && ccw[p][q][r] != ccw[p][r][q]) << number;
        if (ccw[in][q][r] && ccw[p][in][r] && ccw[p][q][in]) {
          ASSERT_TRUE(ccw[p][q][r]) << "interiority, " << number;
        }
      } while (std::ranges::next_permutation(t).found);
    });
    for_each_tuple(n, 5, [&](std::vector<std::size_t> k) {
      do {
        const auto [p, q, r, s, t] = std::array{k[0], k[1], k[2], k[3], k[4]};
        if (ccw[t][s][p] && ccw[t][s][q] && ccw[t][s][r] && ccw[t][p][q] && ccw[t][q][r]) {
          ASSERT_TRUE(ccw[t][p][r]) << "transitivity, " << number;
        }
      } while (std::ranges::next_permutation(k).found);
    });
  }
}

/// 2^-exponent, however small.
BigDyadic power_of_half(std::uint64_t exponent) {
  BigDyadic power(1), base(0.5);
  for (; exponent != 0; exponent /= 2, base = base * base) {
    if (exponent % 2 != 0) power = power * base;
  }
  return power;
}

// One set of real points, far closer to the given ones than any double is, on whose exact signs every answer stands.
TEST(PerturbedConfigurations, PointsOfThePlaneReallyLieSo) {
  for (std::uint64_t number = 0; number < 6; ++number) {
    Entropy e(8, number);
    const std::vector<Indexed2> p = points2(5, 1 + number % 3, e);
    std::vector<std::array<BigDyadic, 2>> real;
    for (const Indexed2& q : p) {
      // No formula has more than squares: with three times the exponent each move is below all products of larger ones.
      std::uint64_t exponent = 48;
      for (std::uint64_t i = 0; i < 2 * q.index; ++i) exponent *= 3;
      real.push_back(
          {BigDyadic(q.point.x) + power_of_half(exponent), BigDyadic(q.point.y) + power_of_half(3 * exponent)});
    }
    const auto at = [&](const std::vector<std::size_t>& t) {
      return [&](std::size_t i) { return real[t[i / 2]][i % 2]; };
    };
    for_each_tuple(5, 3, [&](const std::vector<std::size_t>& t) {
      EXPECT_EQ(orient2d(perturbed, p[t[0]], p[t[1]], p[t[2]]), evaluate<predicates::Orient2d>(at(t)).sign()) << number;
    });
    for_each_tuple(5, 4, [&](const std::vector<std::size_t>& t) {
      EXPECT_EQ(incircle(perturbed, p[t[0]], p[t[1]], p[t[2]], p[t[3]]), evaluate<predicates::InCircle>(at(t)).sign())
          << number;
    });
  }
}

TEST(PerturbedConfigurations, PointsOfSpaceReallyLieSo) {
  for (std::uint64_t number = 0; number < 6; ++number) {
    Entropy e(9, number);
    const std::vector<Indexed3> p = points3(5, 1 + number % 3, e);
    std::vector<std::array<BigDyadic, 3>> real;
    for (const Indexed3& q : p) {
      const std::uint64_t exponent = std::uint64_t{64} << (3 * q.index);  // orient3d is linear in each coordinate
      real.push_back({BigDyadic(q.point.x) + power_of_half(exponent),
                      BigDyadic(q.point.y) + power_of_half(2 * exponent),
                      BigDyadic(q.point.z) + power_of_half(4 * exponent)});
    }
    for_each_tuple(5, 4, [&](const std::vector<std::size_t>& t) {
      const Sign exact = evaluate<predicates::Orient3d>([&](std::size_t i) { return real[t[i / 3]][i % 3]; }).sign();
      EXPECT_EQ(orient3d(perturbed, p[t[0]], p[t[1]], p[t[2]], p[t[3]]), exact) << number;
    });
  }
}

}  // namespace
}  // namespace plumb
