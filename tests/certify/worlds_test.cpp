// Are derived sizes and errors true?  Statements drawn at random when compiled, over numbers drawn at random and at the
// ends of the doubles, against rational arithmetic: each intermediate number, and each sign.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/point.hpp"
#include "plumb/certify/certainly.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

constexpr int highest = 6;
template <Precision precision>
using World = certify::one_lane::Floats<double, highest, Scales{2, 0, 0b10}, NoBoundListener, precision>;
using Numbers = std::array<double, 6>;

mpq_class value_of(double x) { return mpq_class(x); }
mpq_class value_of(const certify::one_lane::Pair<double>& x) { return mpq_class(x.high) + mpq_class(x.low); }
double low_of(double) { return 0; }
double low_of(const certify::one_lane::Pair<double>& x) { return x.low; }

template <class Number>
struct Seen {
  Number number;
  mpq_class exact;
  Track track;
  int certain_sign;  // 2: none
};

/// The exact values of what is computed, by their numbers.  No statement holds one itself, so that what is compiled for
/// each of its parts is short.
class Exacts {
 public:
  explicit Exacts(const Numbers& numbers) : x_(numbers.begin(), numbers.end()) {}
  [[nodiscard]] const mpq_class& operator[](std::size_t i) const { return x_[i]; }

  std::size_t sum(std::size_t a, std::size_t b) { return add(x_[a] + x_[b]); }
  std::size_t difference(std::size_t a, std::size_t b) { return add(x_[a] - x_[b]); }
  std::size_t product(std::size_t a, std::size_t b) { return add(x_[a] * x_[b]); }
  std::size_t magnitude(std::size_t a) { return add(abs(x_[a])); }
  [[nodiscard]] std::size_t larger(std::size_t a, std::size_t b) const { return x_[a] > x_[b] ? a : b; }
  [[nodiscard]] std::size_t smaller(std::size_t a, std::size_t b) const { return x_[a] < x_[b] ? a : b; }

 private:
  std::size_t add(const mpq_class& x) {
    x_.push_back(x);
    return x_.size() - 1;
  }

  std::vector<mpq_class> x_;
};

/// A number of both worlds; what is computed is noted.
template <class T>
struct Both {
  T floats;
  std::size_t exact;
};
template <class T>
Both(T, std::size_t) -> Both<T>;

template <Precision precision>
class Run {
 public:
  using Seen = plumb::Seen<typename World<precision>::Number>;

  explicit Run(const Numbers& numbers) : exact(numbers), x_(numbers) {}

  template <class T>
  auto noted(const T& t, std::size_t value) {
    note(t.value, value, T::track, judge_of<T>());
    return Both{t, value};
  }
  template <std::uint64_t seed, std::size_t scale>
  auto leaf() {
    constexpr std::size_t i = seed % 6, j = seed / 6 % 6;
    if constexpr (scale == 3) {  // a weight: of power 1 of scale 0, -1 of scale 1
      return noted(world_.template weight<1>(world_.given(x_[i])), i);
    } else if constexpr (seed / 36 % 3 == 0) {
      return noted(world_.template number<scale>(x_[i]), i);
    } else if constexpr (seed / 36 % 3 == 1) {
      return noted(world_.template sum<scale>(world_.given(x_[i]), world_.given(x_[j])), exact.sum(i, j));
    } else {
      return noted(world_.template difference<scale>(x_[i], x_[j]), exact.difference(i, j));
    }
  }
  /// Signs are asked at the end, when all leaves are in their scales.
  std::vector<Seen> finished() {
    for (std::size_t i = 0; i < seen_.size(); ++i) seen_[i].certain_sign = judges_[i](world_, seen_[i].number);
    return std::move(seen_);
  }
  World<precision>& world() { return world_; }

  Exacts exact;

 private:
  using Number = typename World<precision>::Number;
  using Judge = int (*)(const World<precision>&, const Number&);
  template <class T>
  static Judge judge_of() {
    return [](const World<precision>& w, const Number& x) -> int {
      if constexpr (T::track.power(1, 0) < 0) {
        return 2;
      } else {
        const int sign = static_cast<int>(w.positive(T{x})) - static_cast<int>(w.negative(T{x}));
        return sign == 0 && !w.zero(T{x}) ? 2 : sign;
      }
    };
  }

  void note(const Number& number, std::size_t value, const Track& track, Judge judge) {
    seen_.push_back({number, exact[value], track, 0});
    judges_.push_back(judge);
  }

  Numbers x_;
  World<precision> world_;
  std::vector<Seen> seen_;
  std::vector<Judge> judges_;
};

constexpr std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 31, x *= 0x9e3779b97f4a7c15, x ^= x >> 29, x *= 0xbf58476d1ce4e5b9;
  return x ^ x >> 32;
}

/// Of powers p and q of scales 0 and 1.
template <std::uint64_t seed, int depth, int p, int q, class Run>
auto tree(Run& run) {
  constexpr std::uint64_t h = mixed(seed);
  constexpr auto next = [](std::uint64_t i) { return mixed(h + i * 0x51ed27); };
  if constexpr (p + q == 1 && (depth == 0 || h % 4 == 0)) {
    return run.template leaf<h % 108, q>();  // what it looks at of h
  } else if constexpr (p + q > 1 && (depth == 0 || h % 3 == 0)) {
    if constexpr (q > 1 && p > 0 && h % 5 == 0) {  // a weight
      const auto a = run.template leaf<h % 6, 3>();
      const auto b = tree<next(1), 0, p - 1, q + 1>(run);
      return run.noted(a.floats * b.floats, run.exact.product(a.exact, b.exact));
    } else {
      constexpr int left_p = p > 0 ? static_cast<int>(h / 16 % static_cast<unsigned>(p + 1)) : 0;
      constexpr int wanted_q = q > 0 ? static_cast<int>(h / 256 % static_cast<unsigned>(q + 1)) : 0;
      constexpr bool all_left = left_p + wanted_q == p + q, none_left = left_p + wanted_q == 0;
      constexpr int lp = all_left && p > 0 ? p - 1 : none_left && p > 0 ? 1 : left_p;
      constexpr int lq = all_left && p == 0 ? q - 1 : none_left && p == 0 ? 1 : wanted_q;
      constexpr int d = depth > 0 ? depth - 1 : 0;
      const auto a = tree<next(1), d, lp, lq>(run);
      const auto b = tree<next(2), d, p - lp, q - lq>(run);
      return run.noted(a.floats * b.floats, run.exact.product(a.exact, b.exact));
    }
  } else {
    const auto a = tree<next(3), depth - 1, p, q>(run);
    if constexpr (h / 8 % 7 == 0) {
      return run.noted(magnitude(a.floats), run.exact.magnitude(a.exact));
    } else if constexpr (h / 8 % 7 == 1) {
      return run.noted(twice(a.floats), run.exact.sum(a.exact, a.exact));
    } else {
      const auto b = tree<next(4), depth - 1, p, q>(run);
      if constexpr (h / 8 % 7 == 2) {
        return run.noted(larger(a.floats, b.floats), run.exact.larger(a.exact, b.exact));
      } else if constexpr (h / 8 % 7 == 3) {
        return run.noted(smaller(a.floats, b.floats), run.exact.smaller(a.exact, b.exact));
      } else if constexpr (h / 8 % 7 < 5) {
        return run.noted(a.floats + b.floats, run.exact.sum(a.exact, b.exact));
      } else {
        return run.noted(a.floats - b.floats, run.exact.difference(a.exact, b.exact));
      }
    }
  }
}

/// Numbers that lie near to one another, are equal, vanish, or are as large and small as doubles are.
Numbers drawn(Entropy& e) {
  Numbers x{};
  const std::uint64_t family = e.below(6);
  const auto power = [&](int most) { return std::ldexp(1.0, static_cast<int>(e.within(most))); };
  const double all = family == 1 ? power(1000) : family == 2 ? std::ldexp(1.0, -1074) : family == 3 ? power(170) : 1;
  for (double& number : x) {
    number = family == 2 ? static_cast<double>(e.within(1 << 20)) * all
                         : static_cast<double>(e.within(std::int64_t{1} << 53)) * 0x1p-53 * all;
    if (family == 4) number *= power(60);
    if (family == 5) number = static_cast<double>(e.within(3));
  }
  if (e.below(2) == 0) x[1] = x[0];
  if (e.below(2) == 0) x[3] = std::nextafter(x[2], e.below(2) == 0 ? 9 : -9);
  if (e.below(4) == 0) x[4] = -x[5];
  return x;
}

struct Tally {
  std::uint64_t numbers = 0, certain = 0, zero = 0, in_range = 0, out_of_range = 0;
  double nearest = 0;  // the largest part of its bound that an error took
};

mpq_class power_of(const mpq_class& x, int n) {
  mpq_class r = 1;
  for (int i = 0; i < std::abs(n); ++i) r *= x;
  return n < 0 ? mpq_class(1 / r) : r;
}

template <Precision precision>
using Statement = void (*)(Run<precision>&);
template <Precision precision, std::uint64_t seed>
void statement(Run<precision>& run) {
  (void)tree<seed, 5, seed % 3, 2 - seed % 2>(run);
}

template <Precision precision>
void expect_laws(Statement<precision> ask, std::uint64_t seed, Tally& tally) {
  Entropy e(seed, 18);
  for (int round = 0; round < 60; ++round) {
    Run<precision> run(drawn(e));
    ask(run);
    if (!run.world().certain()) {
      ++tally.out_of_range;
      continue;
    }
    ++tally.in_range;
    const mpq_class first(run.world().template scale<0>()), second(run.world().template scale<1>()), u(0x1p-53),
        unit(precision == Precision::pairs ? 0x1p-138 : 0x1p-85);
    for (const auto& n : run.finished()) {
      const mpq_class most = power_of(first, n.track.power(0, 0)) * power_of(second, n.track.power(1, 0));
      const mpq_class value = value_of(n.number), low(low_of(n.number));
      ASSERT_LE(abs(mpq_class(value - low)), most * n.track.size * mpq_class(0x1p-32))
          << "replay: " << seed << ' ' << round;
      ASSERT_LE(abs(low), most * n.track.low * mpq_class(0x1p-32) * u) << "replay: " << seed << ' ' << round;
      const mpq_class off = abs(mpq_class(value - n.exact)), bound = most * n.track.error * unit;
      ASSERT_LE(off, bound) << "replay: " << seed << ' ' << round;
      if (n.track.root == 0) {
        ASSERT_EQ(sgn(n.exact), sgn(value));
      }
      if (n.certain_sign != 2) {
        ASSERT_EQ(sgn(n.exact), n.certain_sign) << "replay: " << seed << ' ' << round;
        ++tally.certain, tally.zero += n.certain_sign == 0 && n.track.root != 0;
      }
      if (bound > 0) tally.nearest = std::max(tally.nearest, mpq_class(off / bound).get_d());
      ++tally.numbers;
    }
  }
}

template <Precision precision, std::uint64_t... seeds>
Tally tally_of(std::integer_sequence<std::uint64_t, seeds...>) {
  Tally tally;
  (expect_laws<precision>(statement<precision, seeds + 1>, seeds + 1, tally), ...);
  return tally;
}

TEST(Worlds, SizesAndErrorsAreTrueOfStatementsAtRandom) {
  const Tally t = tally_of<Precision::doubles>(std::make_integer_sequence<std::uint64_t, 24>());
  EXPECT_GT(t.numbers, 10'000u);
  EXPECT_GT(t.certain, t.numbers / 2);
  EXPECT_LT(t.certain, t.numbers);
  EXPECT_GT(t.in_range, 8 * t.out_of_range);
  EXPECT_GT(t.out_of_range, 20u);
  EXPECT_GT(t.nearest, 0.3) << "no error comes near to its bound: it would not be noticed if it were wrong";
}

TEST(Worlds, DoublesOnALatticeTellZeroAsWell) {
  const Tally t = tally_of<Precision::lattice>(std::make_integer_sequence<std::uint64_t, 10>());
  EXPECT_GT(t.numbers, 4'000u);
  EXPECT_GT(t.zero, t.numbers / 200);
  EXPECT_LT(t.certain, t.numbers);
}

TEST(Worlds, PairsKeepTwiceAsManyDigits) {
  const Tally t = tally_of<Precision::pairs>(std::make_integer_sequence<std::uint64_t, 24>());
  EXPECT_GT(t.numbers, 10'000u);
  EXPECT_GT(t.certain, t.numbers * 3 / 4);
  EXPECT_GT(t.zero, t.numbers / 200);
  EXPECT_LT(t.certain, t.numbers);
  EXPECT_GT(t.nearest, 0.05) << "no error comes near to its bound: it would not be noticed if it were wrong";
}

/// Of two scales that are roots of sums of squares: numbers of odd and of even powers, told to be above or below zero.
TEST(Worlds, OddPowersOfARootAreJudgedBySquares) {
  using World = certify::one_lane::Floats<double, 4, Scales{.count = 2, .squares = 0b11}>;
  int odd = 0, even = 0, unsure = 0, zeros = 0, out_of_range = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Entropy e(29, i);
    const Numbers x = drawn(e);
    World w;
    const auto a = w.difference(x[0], x[1]);
    const auto b = w.number(x[2]);
    const auto c = w.difference<1>(x[3], x[4]);
    const auto d = w.number<1>(x[5]);
    const auto across = a * c + b * d;
    const auto squares = a * a - b * b;
    const auto all = across * across - squares * (c * c);
    if (!w.certain()) {
      ++out_of_range;
      continue;
    }
    const mpq_class p = mpq_class(x[0]) - mpq_class(x[1]), q(x[2]), r = mpq_class(x[3]) - mpq_class(x[4]), s(x[5]);
    const mpq_class exact = p * r + q * s, exact_squares = p * p - q * q;
    const auto expect = [&](const auto& n, const mpq_class& truth, int& told) {
      if (w.positive(n)) {
        ASSERT_GT(sgn(truth), 0) << "replay: " << i;
      }
      if (w.negative(n)) {
        ASSERT_LT(sgn(truth), 0) << "replay: " << i;
      }
      (w.positive(n) || w.negative(n) ? told : unsure) += 1;
      zeros += sgn(truth) == 0;
    };
    expect(across, exact, odd);
    expect(squares, exact_squares, even);
    expect(all, mpq_class(exact * exact - exact_squares * r * r), even);
    // What is told of an odd power is told by its bound, and not by much less.
    if (std::abs(across.value) > 0x1p-40 * std::hypot(a.value, b.value) * std::hypot(c.value, d.value) + 0x1p-400) {
      ASSERT_TRUE(w.positive(across) || w.negative(across)) << "replay: " << i;
    }
  }
  EXPECT_GT(odd, 1500);
  EXPECT_GT(even, 3000);
  EXPECT_GT(unsure, 300);
  EXPECT_GT(zeros, 100);
  EXPECT_GT(out_of_range, 50);
  World w;
  static_cast<void>(w.number(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(w.certain());
}

mpq_class exact_product(const mpq_class& a, const mpq_class& b) { return a * b; }
TEST(Worlds, IntegersOnTheStackAreExactUpToTheirRange) {
  int zeros = 0, left = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Entropy e(27, i);
    const auto number = [&] {
      const double x = static_cast<double>(e.within(std::int64_t{1} << (1 + e.below(53))));
      return std::ldexp(x, static_cast<int>(e.within(e.below(3) == 0 ? 900 : 40)));
    };
    std::vector<StackDyadic> numbers;
    std::vector<mpq_class> exact;
    for (int k = 0; k < 6; ++k) {
      const double x = k == 5 ? exact[0].get_d() : number();
      numbers.emplace_back(x), exact.emplace_back(x);
    }
    StackDyadic::clear_range();
    for (int step = 0; step < 12; ++step) {
      const std::size_t a = e.below(numbers.size()), b = e.below(numbers.size());
      const StackDyadic &x = numbers[a], &y = numbers[b];
      const std::uint64_t which = e.below(5);
      numbers.push_back(which == 0   ? x + y
                        : which == 1 ? x - y
                        : which == 2 ? larger(x, y)
                        : which == 3 ? magnitude(negated(twice(x)))
                                     : x * y);
      exact.push_back(which == 0   ? mpq_class(exact[a] + exact[b])
                      : which == 1 ? mpq_class(exact[a] - exact[b])
                      : which == 2 ? (exact[a] < exact[b] ? exact[b] : exact[a])
                      : which == 3 ? mpq_class(2 * abs(exact[a]))
                                   : exact_product(exact[a], exact[b]));
      if (StackDyadic::left_range()) break;
      ASSERT_EQ(static_cast<int>(numbers.back().sign()), sgn(exact.back())) << "replay: " << i;
      zeros += numbers.back().sign() == Sign::zero;
    }
    if (StackDyadic::left_range()) {
      ++left;
      continue;
    }
    for (std::size_t a = 0; a < numbers.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Sign s = (numbers[a] - numbers[b]).sign();
        if (!StackDyadic::left_range()) {
          ASSERT_EQ(static_cast<int>(s), sgn(mpq_class(exact[a] - exact[b]))) << "replay: " << i;
        }
      }
    }
  }
  StackDyadic::clear_range();
  static_cast<void>(StackDyadic(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(StackDyadic::left_range());
  EXPECT_GT(zeros, 30);
  EXPECT_GT(left, 10);
  EXPECT_LT(left, 900);
}

}  // namespace
}  // namespace plumb
