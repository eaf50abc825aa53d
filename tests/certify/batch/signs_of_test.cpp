// Has every formula its batches?  Signs of many cases against those of each, on every instruction set, in every layout.
#include "plumb/certify/signs_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "certify/argument_cases.hpp"
#include "certify/batch/batch_cases.hpp"
#include "certify/catalog.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::batches {
namespace {

constexpr Sign untouched{7};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Cases one after the other, coordinate after coordinate.
struct Table {
  std::size_t arity, count;
  std::vector<double> rows;     // a case after the other
  std::vector<double> columns;  // a coordinate after the other
  std::vector<double> items;    // an argument after the other, its items one after the other

  Table(std::span<const int> arguments, std::size_t n, const std::function<void(std::span<double>, std::size_t)>& fill)
      : arity(static_cast<std::size_t>(std::accumulate(arguments.begin(), arguments.end(), 0))), count(n) {
    rows.resize(arity * n);
    for (std::size_t i = 0; i < n; ++i) fill(std::span(rows).subspan(i * arity, arity), i);
    for (std::size_t k = 0; k < arity; ++k) {
      for (std::size_t i = 0; i < n; ++i) columns.push_back(rows[i * arity + k]);
    }
    std::size_t first = 0;
    for (const int size : arguments) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = first; k < first + static_cast<std::size_t>(size); ++k)
          items.push_back(rows[i * arity + k]);
      }
      first += static_cast<std::size_t>(size);
    }
  }
  [[nodiscard]] std::span<const double> row(std::size_t i) const { return std::span(rows).subspan(i * arity, arity); }
};

enum class Layout { rows, columns, items };

std::vector<certify::batch::Column> columns_of(const Table& t, std::span<const int> arguments, Layout layout,
                                               std::size_t first, std::size_t n) {
  std::vector<certify::batch::Column> all;
  std::size_t k = 0, before = 0;
  for (const int size : arguments) {
    const auto s = static_cast<std::size_t>(size);
    for (std::size_t a = 0; a < s; ++a, ++k) {
      if (layout == Layout::rows) all.push_back({t.rows.data() + first * t.arity + k, t.arity, n, false});
      if (layout == Layout::columns) all.push_back({t.columns.data() + k * t.count + first, 1, n, true});
      if (layout == Layout::items) all.push_back({t.items.data() + before * t.count + first * s + a, s, n, false});
    }
    before += s;
  }
  return all;
}

/// What signs_of tells the library of a formula of the manifest.
const certify::batch::BatchFormula& asked_of(std::string_view name) {
  static constexpr std::array all{
#define PLUMB_ASKED(formula) &certify::batch::asked<predicates::formula>,
      PLUMB_PREDICATES(PLUMB_ASKED)
#undef PLUMB_ASKED
  };
  return **std::ranges::find(all, name, [](const certify::batch::BatchFormula* asked) { return asked->name; });
}

TEST(SignsOf, AreThoseOfEachCaseForEveryPredicateOfTheManifest) {
  const std::size_t count = battery::sanitized ? 150 : 700;
  for (const CatalogEntry& e : catalog()) {
    SCOPED_TRACE(e.name);
    const certify::batch::BatchFormula& asked = asked_of(e.name);
    for (const FamilyInfo& f : families) {
      if (battery::sanitized && f.family != Family::mixture && f.family != Family::extreme) continue;
      SCOPED_TRACE(f.name);
      const Table table(e.arguments, count, [&](std::span<double> p, std::size_t i) {
        Entropy entropy(31, i);
        if (i % 5 == 0) {
          battery::fill_at_zero(e, p, entropy);
        } else {
          battery::fill_arguments(e, f.family, p, entropy);
        }
      });
      std::vector<Sign> truth;
      for (std::size_t i = 0; i < count; ++i) truth.push_back(e.decide(table.row(i)).sign);
      on_each_instruction_set([&] {
        for (const Layout layout : {Layout::rows, Layout::columns, Layout::items}) {
          for (const std::size_t n :
               {std::size_t{0}, std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{130}, count - 3}) {
            const std::size_t first = n % 4;
            std::vector<Sign> out(n + 1, untouched);
            certify::batch::decide_all(asked, columns_of(table, e.arguments, layout, first, n), std::span(out).first(n),
                                       Execution::serial);
            ASSERT_EQ(out[n], untouched);
            for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(out[i], truth[first + i]) << static_cast<int>(layout) << i;
          }
        }
      });
    }
  }
}

// Everything that a tape may have: coordinates by themselves, sums of them, opposites, constants, differences across
// arguments, results used late and twice; and its result is a sum of two coordinates in the other one.
constexpr auto everything = [](auto a, auto b, auto c, auto d, auto e, auto f) {
  const auto sum = a + b, difference = c - f, square = e * e;
  const auto product = sum * difference * d;
  return product + 3 * c * square - difference * a * (sum + -2.0 * a) + square * difference - product * 7 -
         (a - b) * d * f - -(b * f) * d + sum * (e + f) * (a + a);
};
constexpr auto plain_sum = [](auto a, auto b) { return a + b; };
constexpr auto doubled = [](auto a, auto b) { return 2 * (a - b); };

template <class Polynomial, std::size_t N>
std::vector<Sign> one_by_one(Polynomial f, const std::vector<std::array<double, N>>& cases) {
  std::vector<Sign> signs;
  for (const auto& c : cases) signs.push_back(plumb::sign_of(f, c));
  return signs;
}

template <std::size_t N>
std::vector<std::array<double, N>> cases_of_size(Family family, std::size_t count) {
  std::vector<std::array<double, N>> cases(count);
  for (std::size_t i = 0; i < count; ++i) {
    Entropy entropy(91, i);
    if (i % 3 == 0) {
      for (double& x : cases[i]) x = static_cast<double>(entropy.within(2));
    } else {
      fill_points(family, Degeneracy::collinear, 2, cases[i], entropy);
    }
  }
  return cases;
}

bool same(double a, double b) { return a == b ? std::signbit(a) == std::signbit(b) : std::isnan(a) && std::isnan(b); }

/// What the filter of a block says of each case, and what the filter of one case does: value and threshold.
template <class Polynomial, std::size_t N>
void expect_that_of_one_case(Polynomial, certify::batch::BlockFilter filter,
                             const std::vector<std::array<double, N>>& cases) {
  using F = typename FormulaOf<Polynomial, std::array<double, N>>::Type;
  alignas(64) std::array<std::array<double, certify::batch::block>, N + 2> memory;
  std::array<const double*, N> at;
  for (std::size_t k = 0; k < N; ++k) at[k] = memory[k].data();
  for (std::size_t first = 0; first + certify::batch::block <= cases.size(); first += certify::batch::block) {
    for (std::size_t i = 0; i < certify::batch::block; ++i) {
      for (std::size_t k = 0; k < N; ++k) memory[k][i] = cases[first + i][k];
    }
    filter(at.data(), memory[N].data(), memory[N + 1].data());
    for (std::size_t i = 0; i < certify::batch::block; ++i) {
      const Filtered one = evaluate<F>([&](std::size_t k) { return Filtered::Input{cases[first + i][k]}; });
      const double threshold = filter_constant<F>() * one.magnitude;
      EXPECT_TRUE(same(memory[N][i], one.value)) << first + i;
      EXPECT_TRUE(same(memory[N + 1][i], threshold)) << first + i;
    }
  }
}

template <class Polynomial, std::size_t N>
void expect_at_every_width(Polynomial f, const std::vector<std::array<double, N>>& cases) {
  constexpr certify::batch::BlockFilters all =
      certify::batch::block_filters<typename FormulaOf<Polynomial, std::array<double, N>>::Type>();
  expect_that_of_one_case(f, all.any_processor, cases);
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) expect_that_of_one_case(f, all.avx2, cases);
  if (__builtin_cpu_supports("avx512f")) expect_that_of_one_case(f, all.avx512, cases);
#endif
}

TEST(SignsOf, FiltersComputeWhatTheFilterOfOneCaseDoes) {
  for (const FamilyInfo& family : families) {
    SCOPED_TRACE(family.name);
    expect_at_every_width(everything, cases_of_size<6>(family.family, 640));
    expect_at_every_width(plain_sum, cases_of_size<2>(family.family, 640));
    expect_at_every_width(doubled, cases_of_size<2>(family.family, 640));
    expect_at_every_width(predicates::Orient2d{}, cases_of_size<6>(family.family, 640));
    expect_at_every_width(predicates::InCircle{}, cases_of_size<8>(family.family, 640));
  }
}

TEST(SignsOf, TellsThoseOfAnyLambda) {
  for (const FamilyInfo& family : families) {
    SCOPED_TRACE(family.name);
    const auto six = cases_of_size<6>(family.family, battery::fitting<std::uint64_t>(5'000));
    const auto two = cases_of_size<2>(family.family, battery::fitting<std::uint64_t>(5'000));
    const std::vector<Sign> truth = one_by_one(everything, six), sums = one_by_one(plain_sum, two);
    const std::vector<Sign> differences = one_by_one(doubled, two);
    std::vector<Point2> ab, ef;
    std::vector<Vector2> xy;
    std::vector<double> c, d;
    for (const auto& p : six) {
      ab.push_back({p[0], p[1]});
      c.push_back(p[2]);
      d.push_back(p[3]);
      ef.push_back({p[4], p[5]});
    }
    for (const auto& p : two) xy.push_back({p[0], p[1]});
    on_each_instruction_set([&] {
      for (const Execution execution : {Execution::serial, Execution::parallel}) {
        std::vector<Sign> out(six.size(), untouched);
        plumb::signs_of(everything, six, out, execution);
        ASSERT_EQ(out, truth);
        std::ranges::fill(out, untouched);
        plumb::signs_of(everything, std::span<const Point2>(ab), c, d, ef, std::span<Sign>(out), execution);
        ASSERT_EQ(out, truth);
        plumb::signs_of(plain_sum, xy, out, execution);
        ASSERT_EQ(out, sums);
        plumb::signs_of(doubled, xy, out);
        ASSERT_EQ(out, differences);
      }
    });
  }
}

TEST(SignsOf, TellsTheSameOnManyThreads) {
  const auto cases = cases_of_size<6>(Family::mixture, battery::fitting<std::uint64_t>(40'000));
  const std::vector<Sign> truth = one_by_one(everything, cases);
  std::vector<Sign> out(cases.size());
  plumb::signs_of(everything, cases, out, Execution::parallel);
  EXPECT_EQ(out, truth);
}

TEST(SignsOf, TakesViewsAndWhatIsTheSameForAllCases) {
  constexpr auto in_disc = [](auto x, auto y, auto cx, auto cy, auto r) {
    return r * r - (x - cx) * (x - cx) - (y - cy) * (y - cy);
  };
  const std::vector<double> x{0, 3, 4, 9}, y{0, 4, 4, 9};
  const Point2 center{0, 0};
  std::vector<Sign> out(4, untouched);
  plumb::signs_of(in_disc, Points2View{x, y}, center, 5.0, out);
  EXPECT_EQ(out, (std::vector{Sign::positive, Sign::zero, Sign::negative, Sign::negative}));
  plumb::signs_of(in_disc, center, Points2View{x, y}, std::vector<double>{1, 5, 6, 12}, out);
  EXPECT_EQ(out, (std::vector{Sign::positive, Sign::zero, Sign::positive, Sign::negative}));
  plumb::signs_of(predicates::Orient2d{}, Point2{0, 0}, Point2{1, 0}, Vector2{0, 1}, out);
  EXPECT_EQ(out, std::vector<Sign>(4, Sign::positive));
}

template <class Do>
std::string refused(Do run) {
  try {
    run();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(SignsOf, NamesWhatIsNoNumber) {
  std::vector<Point2> a(200, {1, 2}), b(200, {3, 4});
  std::vector<double> c(200, 1), d(200, 1), x(200, 1), y(200, 1);
  std::vector<Sign> out(200);
  b[150].y = nan;
  b[170].x = nan;
  c[190] = nan;
  on_each_instruction_set([&] {
    EXPECT_EQ(refused([&] { plumb::signs_of(everything, a, c, d, b, out); }),
              "sign_of: d.y of item 150 is nan, not a real number; give a finite double");
    EXPECT_EQ(refused([&] { plumb::signs_of(everything, a, c, d, a, out); }),
              "sign_of: b of item 190 is nan, not a real number; give a finite double");
    EXPECT_EQ(refused([&] { plumb::signs_of(everything, a, d, nan, a, out); }),
              "sign_of: c of item 0 is nan, not a real number; give a finite double");
  });
}

TEST(SignsOf, RefusesSpansOfUnequalLength) {
  const std::vector<Point2> a(3), b(2);
  const std::vector<double> c(3), d(3), x(3), y(4);
  std::vector<Sign> out(3, untouched);
  EXPECT_EQ(refused([&] { plumb::signs_of(everything, a, c, d, b, out); }),
            "sign_of: d has 2 items, but a has 3; give spans of equal length");
  EXPECT_EQ(refused([&] {
              plumb::signs_of(predicates::Orient2d{}, Points2View{x, y}, a, a, out);
            }),
            "orient2d: a.y has 4 items, but a.x has 3; give spans of equal length");
  EXPECT_EQ(refused([&] {
              plumb::signs_of(predicates::Orient2d{}, b, b, Point2{0, 0}, out);
            }),
            "orient2d: out has 3 items, but a has 2; give spans of equal length");
  EXPECT_EQ(out, std::vector<Sign>(3, untouched));
}

}  // namespace
}  // namespace plumb::batches
