// The laws that include/plumb/predicates.hpp numbers, on cases of any family, shrunk by RapidCheck.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numeric>
#include <ostream>

#include "certify/battery.hpp"
#include "plumb/degenerate/rapidcheck.hpp"

namespace plumb::battery {

/// A predicate at some coordinates, written as the case line that replays it.
struct Case {
  const CatalogEntry* predicate;
  std::vector<double> coordinates;

  [[nodiscard]] Sign sign() const { return predicate->decide(coordinates).sign; }
};

void showValue(const Case& c, std::ostream& out) { out << case_line(*c.predicate, c.coordinates); }  // NOLINT: by name

namespace {

template <class Make>
rc::Gen<Case> cases_of(const CatalogEntry& e, Make fill) {
  return generator_of([&e, fill](Entropy& entropy) {
    Case c{&e, std::vector<double>(e.arity())};
    fill(entropy, c.coordinates);
    return c;
  });
}

rc::Gen<Case> any_case(const CatalogEntry& e) {
  return cases_of(e, [&e](Entropy& entropy, std::vector<double>& p) {
    const auto sets = zero_sets(e);
    const Family family = any_family(entropy);
    fill_points(family, sets[entropy.below(sets.size())], e.dimension, p, entropy);
  });
}

// What refutes a property within 2000 cases, the same in every run: the shrunk case as a line that replays.  Empty when
// nothing does.
template <class Property>
std::string refutation(Property property) {
  rc::detail::TestParams parameters;
  parameters.seed = 20'26;
  parameters.maxSuccess = fitting(2'000);
  const rc::detail::TestResult result = rc::detail::checkTestable(property, rc::detail::TestMetadata(), parameters);
  rc::detail::FailureResult failure;
  if (!result.match(failure)) return result.is<rc::detail::SuccessResult>() ? "" : "too few cases";
  std::string shown;
  for (const auto& [type, value] : failure.counterExample) shown += value + '\n';
  return shown;
}

template <class Property>
void check(const CatalogEntry& e, const char* law, Property property) {
  EXPECT_EQ(refutation(property), "") << e.name << ": " << law;
}

Case permuted(const Case& c, std::span<const int> order) {
  Case moved = c;
  const auto axes = static_cast<std::size_t>(c.predicate->dimension);
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(c.coordinates.begin() + static_cast<std::ptrdiff_t>(axes) * order[i], axes,
                moved.coordinates.begin() + static_cast<std::ptrdiff_t>(axes * i));
  }
  return moved;
}

Sign parity(std::span<const int> order) {
  Sign s = Sign::positive;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size(); ++k)
      if (order[i] > order[k]) s = -s;
  return s;
}

class Laws : public testing::TestWithParam<std::string_view> {
 protected:
  const CatalogEntry& entry() const { return *find_predicate(GetParam()); }
};

// Law 1, for the classic four stronger than stated: the last point is one of those that any swap flips.
TEST_P(Laws, PermutingPointsFlipsOrKeepsTheSign) {
  check(entry(), "all permutations", [&] {
    const Case c = *any_case(entry());
    std::vector<int> order(static_cast<std::size_t>(entry().points));
    std::iota(order.begin(), order.end(), 0);
    do {
      RC_ASSERT(permuted(c, order).sign() == parity(order) * c.sign());
    } while (std::ranges::next_permutation(order).found);
  });
}

// Law 1 for axes: a mirror turns every orientation over, whether it swaps two axes or negates one.
TEST_P(Laws, MirrorsFlipTheSign) {
  check(entry(), "mirrors", [&] {
    const Case c = *any_case(entry());
    // Orientations flip; so do incircle and insphere, which are inside times an orientation.
    const auto axes = static_cast<std::size_t>(entry().dimension);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      Case negated = c, swapped = c;
      for (std::size_t i = axis; i < c.coordinates.size(); i += axes) negated.coordinates[i] = -c.coordinates[i];
      for (std::size_t i = 0; i < c.coordinates.size(); i += axes) {
        std::swap(swapped.coordinates[i + axis], swapped.coordinates[i + (axis + 1) % axes]);
      }
      RC_ASSERT(negated.sign() == -c.sign());
      RC_ASSERT(swapped.sign() == -c.sign());
    }
  });
}

// Law 2: repeating a point makes any of them zero.
TEST_P(Laws, EqualPointsGiveZero) {
  check(entry(), "equal points", [&] {
    const Case c = *any_case(entry());
    for (int i = 0; i < entry().points; ++i) {
      for (int k = 0; k < entry().points; ++k) {
        if (i == k) continue;
        std::vector<int> order(static_cast<std::size_t>(entry().points));
        std::iota(order.begin(), order.end(), 0);
        order[static_cast<std::size_t>(i)] = k;
        RC_ASSERT(permuted(c, order).sign() == Sign::zero);
      }
    }
  });
}

// Law 3, for every predicate of the catalog: each power of two that keeps all coordinates' bits.
TEST_P(Laws, PowersOfTwoChangeNothing) {
  check(entry(), "powers of two", [&] {
    const Case c = *any_case(entry());
    int lowest = 1024, highest = -1075;
    for (const double x : c.coordinates) {
      lowest = std::min(lowest, lowest_exponent(x));
      highest = std::max(highest, highest_exponent(x));
    }
    RC_PRE(lowest <= highest);
    const int down = -1074 - lowest, up = 1023 - highest;
    for (const int by : {down, down / 2, up / 2, up}) {
      Case scaled = c;
      for (double& x : scaled.coordinates) x = std::ldexp(x, by);
      RC_ASSERT(scaled.sign() == c.sign());
    }
  });
}

// Law 3: integers far below 2^53 move without rounding.
TEST_P(Laws, ExactTranslationsChangeNothing) {
  const auto fill = [this](Entropy& entropy, std::vector<double>& p) {
    const bool grid = entropy.coin();
    fill_points(grid ? Family::grid : Family::degenerate_short, zero_sets(entry()).back(), entry().dimension, p,
                entropy);
  };
  check(entry(), "exact translations", [&] {
    const Case c = *cases_of(entry(), fill);
    const auto axes = static_cast<std::size_t>(entry().dimension);
    for (const double by : {1.0, -0x1p21 - 3, 0x1p40 + 1, 0x1p52}) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        Case moved = c;
        for (std::size_t i = axis; i < moved.coordinates.size(); i += axes) {
          moved.coordinates[i] += by;
          RC_PRE(moved.coordinates[i] - by == c.coordinates[i]);
        }
        RC_ASSERT(moved.sign() == c.sign());
      }
    }
  });
}

TEST_P(Laws, AFalseLawIsRefutedByALineThatReplays) {
  const std::string line = refutation([&] { RC_ASSERT((*any_case(entry())).sign() != Sign::negative); });
  const auto c = parse_case_line(line);
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ(c->expected, Unsure{Sign::negative});
  EXPECT_EQ(entry().decide(c->coordinates).sign, Sign::negative);
  EXPECT_LT(line.size(), 12 * entry().arity() + 30);  // shrunk: mostly zeros and small integers
}

INSTANTIATE_TEST_SUITE_P(Classic, Laws, testing::Values("orient2d", "orient3d", "incircle", "insphere"),
                         [](const auto& at) { return std::string(at.param); });

}  // namespace
}  // namespace plumb::battery
