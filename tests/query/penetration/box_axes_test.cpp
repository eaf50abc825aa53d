// The axes that may be the least of fifteen: which bounds were derived, and does a machine confirm them?
#include "query/penetration/box_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::query::parting {
namespace {

using Pair = NearAxes::Pair;

/// The guess is the first.
constexpr auto first = [](const auto&, const auto&) { return 0U; };

/// All fifteen, this one first.
std::array<Pair, 15> fifteen(const Pair& from) {
  std::array<Pair, 15> all{from};
  std::size_t size = 1;
  for (std::uint32_t p = 0; p < 6; ++p) {
    for (std::uint32_t q = p + 1; q < 6; ++q) {
      if (Pair{p, q} != from) all[size++] = {p, q};
    }
  }
  return all;
}

TEST(NearBoxAxes, DerivedBoundsAreAsRecordedAndProved) {
  // Deep in one another but for a face of the first, which is nearly met: its normal, of axes 0 and 1, is the least.
  const GivenBox::Ends ten{-5, 5}, one{-0.5, 0.5};
  const GivenBox a{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {ten, ten, one}, {{{-1, 1}, {-1, 1}, {-1, 1}}}};
  const GivenBox b{{{{0.75, 0.5, 0.25}, {-0.5, 0.75, 0.125}, {-0.25, 0.125, 0.75}}},
                   {one, one, one},
                   {{{-1, 1.5}, {-1, 1.25}, {-1, 2}}}};
  const auto all = fifteen({0, 1});
  const auto bounds = judged_bounds(NearAxes{}, a, b, all, first);
  FloatWorld<NearAxes> world;
  EXPECT_EQ(NearAxes{}(world, a, b, all, first).near, 1U);
  EXPECT_TRUE(world.certain());
  expect_golden("least_box_axis", bounds);
  expect_proved(bounds, judged_proofs("least_box_axis", NearAxes{}, a, b, all, first));
}

/// A box by 21 numbers.
GivenBox box_of(const double* x) {
  GivenBox box{};
  for (std::size_t k = 0; k < 3; ++k) {
    box.axes[k] = {x[3 * k], x[3 * k + 1], x[3 * k + 2]};
    box.length[k] = {std::fmin(x[9 + k], x[12 + k]), std::fmax(x[9 + k], x[12 + k])};
    box.middle[k] = {x[15 + k], x[18 + k]};
  }
  return box;
}

/// Is this axis the only one that may be the least, the boxes overlap along it, and is every other sign known?  Where not
/// and a number may be anything, that is left open.
struct IsLeast {
  static constexpr Scales scales = NearAxes::scales;
  static constexpr int highest = NearAxes::highest;
  template <class W>
  bool operator()(W& w, const GivenBox& a, const GivenBox& b) const {
    const auto least = [](const auto& overlaps, const auto& lengths) {
      std::uint32_t best = 0;
      for (std::uint32_t i = 1; i < overlaps.size(); ++i) {
        const auto x = *overlaps[i] * *lengths[best], y = *overlaps[best] * *lengths[i];
        if constexpr (requires { x.value < y.value; }) {
          best = x.value < y.value ? i : best;
        } else {
          best = (x - y).sign() == Sign::negative ? i : best;
        }
      }
      return best;
    };
    const auto all = fifteen({0, 1});
    const NearAxes::Told told = NearAxes{}(w, a, b, all, least);
    const bool is_it = told.near == 1U << told.picked && told.overlap == Sign::positive && told.middle != Sign::zero;
    if constexpr (requires { w.leave_open(); }) {
      if (!is_it && told.overlap != Sign::negative) w.leave_open();
    }
    return is_it;
  }
};
TEST(NearBoxAxes, DoublesTellInPromisedShare) {
  expect_share<42>("least_box_axis", IsLeast{}, [](const auto& ask, const std::array<double, 42>& x) {
    ask(box_of(x.data()), box_of(x.data() + 21));
  });
}

struct Drawn {
  GivenBox a, b;
  std::array<std::uint32_t, 2> pair;
};
/// Along the cross product of two axes: both boxes' reach less the way between their middles, by all six axes.
struct Along {
  arith::Plain n;
  double lead, overlap, square;

  Along(const Drawn& x, std::size_t i, std::size_t j) : n(cross(axis(x, i), axis(x, j))), square(dot(n, n)) {
    const auto of = [](const GivenBox::Ends& e) { return e.to - e.from; };
    const auto middle = [&](std::size_t k) { return of(x.a.middle[k]) - of(x.b.middle[k]); };
    lead = dot(n, arith::Plain{middle(0), middle(1), middle(2)});
    overlap = -std::fabs(lead);
    for (std::size_t k = 0; k < 6; ++k) {
      overlap += std::fabs(dot(n, axis(x, k))) * of((k < 3 ? x.a : x.b).length[k % 3]);
    }
  }
  static arith::Plain axis(const Drawn& x, std::size_t k) {
    const Vector3& v = (k < 3 ? x.a : x.b).axes[k % 3];
    return {v.x, v.y, v.z};
  }
};
/// Of small integers, whose products doubles hold.
NearAxes::Told truth(const Drawn& x) {
  const auto sign = [](double t) { return static_cast<Sign>((t > 0) - (t < 0)); };
  const auto [i, j] = x.pair;
  const Along least(x, i, j);
  NearAxes::Told told;
  told.overlap = sign(least.overlap), told.middle = sign(least.lead);
  for (std::size_t k = 0; k < 6; ++k) {
    if (k != i && k != j) told.along[k] = sign(dot(least.n, Along::axis(x, k)));
  }
  const auto all = fifteen(x.pair);
  for (std::uint32_t k = 0; k < 15; ++k) {
    const Along other(x, all[k][0], all[k][1]);
    const double here = least.overlap * std::fabs(least.overlap) * other.square,
                 there = other.overlap * std::fabs(other.overlap) * least.square;
    if (k == 0 || !(there > here)) told.near |= 1U << k;
  }
  for (std::size_t body : {0U, 3U}) {
    const arith::Plain n = cross(Along::axis(x, body), Along::axis(x, body + 1));
    told.turn[body / 3] = sign(dot(n, Along::axis(x, body + 2)));
  }
  return told;
}
TEST(NearBoxAxes, MutantsAreNoticed) {
  const auto draw = [](mutants::Draw& d) {
    Drawn x{};
    for (GivenBox* box : {&x.a, &x.b}) {
      std::array<double, 21> all{};
      for (std::size_t k = 0; k < 9; ++k)
        all[k] = d.number() / 2 + (k % 4 == 0 ? 3 : 0);  // not far from those of space
      for (std::size_t k = 9; k < 21; ++k) all[k] = d.number();
      *box = box_of(all.data());
      for (GivenBox::Ends& e : box->length) e.to += 1;
    }
    // A guess at the least, or at the second.
    double least = HUGE_VAL, second = HUGE_VAL;
    std::array<std::uint32_t, 2> of_least{0, 1}, of_second{0, 1};
    for (std::uint32_t p = 0; p < 6; ++p) {
      for (std::uint32_t q = p + 1; q < 6; ++q) {
        const Along along(x, p, q);
        const double far = along.overlap / std::sqrt(along.square);
        if (far < least) {
          second = least, of_second = of_least, least = far, of_least = {p, q};
        } else if (far < second) {
          second = far, of_second = {p, q};
        }
      }
    }
    x.pair = d.number() > 0 ? of_second : of_least;
    return x;
  };
  mutants::expect_noticed("least_box_axis", mutants::unnoticed(
                                                draw,
                                                [](const Drawn& x) {
                                                  mutants::World w;
                                                  return std::optional(NearAxes{}(w, x.a, x.b, fifteen(x.pair), first));
                                                },
                                                truth, 0, 10000));
}

/// Boxes that stand on one another all but flush, on ground that is far larger than they sink into it: no axis is left out
/// that is as near, and most of those that are not are.
TEST(NearBoxAxes, OfNearlyFlushBoxesAreFew) {
  int alone = 0, several = 0, not_least = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Entropy entropy(54, seed);
    const auto noise = [&](double size) { return size * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
    const double tilt = std::ldexp(1.0, -static_cast<int>(entropy.bits(5))), size = seed % 2 == 0 ? 0.5 : 20;
    const auto box = [&](double height, double half, double yaw, double pitch) {
      const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(pitch), t = std::sin(pitch);
      GivenBox b{{Vector3{c, 0, -s}, Vector3{s * t, d, c * t}, Vector3{s * d, -t, c * d}}, {}, {}};
      b.length = {{{-half, half}, {-0.5, 0.5}, {-half, half}}};
      const double x = noise(0.02);
      b.middle = {{{-x, x}, {-height, height}, {0, 0}}};
      return b;
    };
    const GivenBox a = box(1 - std::fabs(noise(1e-3)), 0.5, noise(3), noise(tilt)),
                   b = box(0, size, noise(3), noise(tilt));
    std::vector<std::pair<double, Pair>> order;  // a guess, of axes that are not those of nearly parallel edges
    for (const Pair& p : fifteen({0, 1})) {
      const Along along({a, b, {}}, p[0], p[1]);
      if (along.square > 0x1p-40) order.emplace_back(along.overlap / std::sqrt(along.square), p);
    }
    std::ranges::sort(order);
    const bool is_least = seed % 3 != 0;
    const auto all = fifteen(order[is_least ? 0 : 1].second);
    FloatWorld<NearAxes> floats;
    RationalWorld rationals;
    const NearAxes::Told told = NearAxes{}(floats, a, b, all, first), exact = NearAxes{}(rationals, a, b, all, first);
    EXPECT_TRUE(floats.certain()) << seed;
    EXPECT_EQ(told.near & exact.near, exact.near) << seed;
    not_least += exact.near != 1;
    if (is_least) ++(told.near == 1 ? alone : several);
  }
  std::printf("one axis is left of %d, several of %d\n", alone, several);
  EXPECT_GT(alone, 3 * several);
  EXPECT_GT(not_least, 50);
}

}  // namespace
}  // namespace plumb::query::parting
