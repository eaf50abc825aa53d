// Would a slip in a stage be noticed?  Each safeguard of the proofs is left out in turn, in a stage rebuilt here, and
// the families and the known cases must catch the lie; with the safeguard in place the same rebuilt stage tells none.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/battery.hpp"
#include "certify/case_files.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb::battery {
namespace {

// How many of these cases a stage answers with certainty and wrongly.
template <Formula F, class Stage>
int lies(const Stage& stage, std::initializer_list<Family> of, std::uint64_t most) {
  const CatalogEntry& e = *find_predicate(F::name);
  int count = 0;
  const auto judge = [&](const std::vector<double>& p) {
    Coordinates<F> c{};
    std::ranges::copy(p, c.begin());
    const Unsure<Sign> said = stage(c);
    count += said.certain() && said.value() != oracle::rational_sign(F::name, p);
  };
  for (const Family family : of) {
    for (std::uint64_t i = 0; i < most; ++i) {
      judge(coordinates_of(e, family, i));
    }
  }
  for (const CaseLine& c : known_killers()) {
    if (c.predicate == F::name) judge(c.coordinates);
  }
  return count;
}

constexpr auto hard = {Family::off_by_ulps, Family::near_half, Family::degenerate_long};
constexpr auto far = {Family::extreme, Family::mixture};
const std::uint64_t some = sanitized ? 1'000 : 3'000;

Unsure<Sign> of(int s) { return s == 0 ? Unsure<Sign>{} : Unsure{static_cast<Sign>(s)}; }

// Filter A with another constant and another guard.
template <Formula F>
auto filter_a(double factor, bool guard) {
  return [=](const Coordinates<F>& p) {
    const Filtered r = evaluate<F>([&](std::size_t i) { return Filtered::Input{p[i]}; });
    const double constant = filter_constant<F>() * factor;
    if (guard) return of(beyond(r.value, constant * r.magnitude));
    struct Unguarded {
      double value, magnitude;
      Unguarded operator+(Unguarded b) const { return {value + b.value, magnitude + b.magnitude}; }
      Unguarded operator-(Unguarded b) const { return {value - b.value, magnitude + b.magnitude}; }
      Unguarded operator*(Unguarded b) const { return {value * b.value, magnitude * b.magnitude}; }
    };
    struct Leaf {
      double value;
      Unguarded operator-(Leaf b) const { return {value - b.value, magnitude_of(value - b.value)}; }
    };
    const Unguarded u = evaluate<F>([&](std::size_t i) { return Leaf{p[i]}; });
    return of(beyond(u.value, constant * u.magnitude));
  };
}

// Filter B with another constant, floor and finiteness test.
template <Formula F>
auto filter_b(double factor, bool floor, bool finite) {
  return [=](const Coordinates<F>& p) {
    Largest<F> largest = largest_differences<F>(p);
    if (!floor) {
      for (double& x : largest) x = x == largest_floor<F> ? 0 : x;
    }
    const double value = F{}(p);
    return of(beyond(value, factor * largest_threshold<F>(largest) + (finite ? value - value : 0)));
  };
}

template <class F>
struct BrokenFilters : testing::Test {};
using Formulas = testing::Types<predicates::Orient2d, predicates::Orient3d, predicates::InCircle, predicates::InSphere>;
TYPED_TEST_SUITE(BrokenFilters, Formulas);

TYPED_TEST(BrokenFilters, AsTheyAreTheyTellNoLie) {
  EXPECT_EQ(lies<TypeParam>(filter_a<TypeParam>(1, true), hard, some), 0);
  EXPECT_EQ(lies<TypeParam>(filter_a<TypeParam>(1, true), far, some), 0);
  EXPECT_EQ(lies<TypeParam>(filter_b<TypeParam>(1, true, true), hard, some), 0);
  EXPECT_EQ(lies<TypeParam>(filter_b<TypeParam>(1, true, true), far, some), 0);
}

TYPED_TEST(BrokenFilters, AConstantOfZeroIsCaught) {
  EXPECT_GT(lies<TypeParam>(filter_a<TypeParam>(0, true), hard, some), 10);
  EXPECT_GT(lies<TypeParam>(filter_b<TypeParam>(0, true, true), hard, some), 10);
}

// The bounds of the proof are some times what random cases reach; BoundTest and the golden lines watch the rest.
TYPED_TEST(BrokenFilters, AConstantMuchTooSmallIsCaught) {
  EXPECT_GT(lies<TypeParam>(filter_a<TypeParam>(0x1p-4, true), hard, some), 10);
  EXPECT_GT(lies<TypeParam>(filter_b<TypeParam>(0x1p-8, true, true), hard, some), 10);
}

TYPED_TEST(BrokenFilters, AMissingGuardIsCaught) {
  if (!reaches_rare) GTEST_SKIP();
  EXPECT_GT(lies<TypeParam>(filter_a<TypeParam>(1, false), far, some), 0);
}

TYPED_TEST(BrokenFilters, AMissingFloorIsCaught) {
  if (!reaches_rare) GTEST_SKIP();
  EXPECT_GT(lies<TypeParam>(filter_b<TypeParam>(1, false, true), far, some), 0);
}

// Needed where the threshold is one product: a threshold summed like the formula overflows when its terms do.
TYPED_TEST(BrokenFilters, AMissingTestForOverflowIsCaught) {
  const int count = lies<TypeParam>(filter_b<TypeParam>(1, true, false), far, some);
  if constexpr (axis_degrees<TypeParam>.equal_terms && degree<TypeParam>() > 2) {
    EXPECT_GT(count, 0);
  } else {
    EXPECT_EQ(count, 0);
  }
}

// An interval whose bounds are not moved outward.
struct Unmoved {
  double lower, upper;
  friend Unmoved operator+(Unmoved a, Unmoved b) { return {a.lower + b.lower, a.upper + b.upper}; }
  friend Unmoved operator-(Unmoved a, Unmoved b) { return {a.lower - b.upper, a.upper - b.lower}; }
  friend Unmoved operator*(Unmoved a, Unmoved b) {
    const auto [low, high] = std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return {low, high};
  }
};

TYPED_TEST(BrokenFilters, AnIntervalThatIsNotRoundedOutwardIsCaught) {
  const auto stage = [](const Coordinates<TypeParam>& p) {
    const Unmoved r = evaluate<TypeParam>([&](std::size_t i) { return Unmoved{p[i], p[i]}; });
    return Interval{r.lower, r.upper}.sign();
  };
  EXPECT_GT(lies<TypeParam>(stage, hard, some), 10);
}

// The long doubles, of which the swap that brings the least argument to the end is not paid for.
TYPED_TEST(BrokenFilters, AParityThatIsLeftOutIsCaught) {
  const auto stage = [](bool parity) {
    return [=](const Coordinates<TypeParam>& p) {
      const certify::LeastLast<TypeParam> seen(p);
      const auto s = of(filter<TypeParam>(seen.at));
      return s.certain() && parity ? Unsure{s.value() * seen.parity} : s;
    };
  };
  EXPECT_EQ(lies<TypeParam>(stage(true), far, some), 0);
  EXPECT_GT(lies<TypeParam>(stage(false), far, some), 10);
}

// Integers of leveled coordinates, of which the small ones are lost where an axis spans too much.
TYPED_TEST(BrokenFilters, LevelsThatLoseSmallCoordinatesAreCaught) {
  const auto stage = [](int most) {
    return [=](const Coordinates<TypeParam>& p) {
      const certify::Levels<TypeParam> levels(p);
      if (levels.span() > most) return Unsure<Sign>{};
      Coordinates<TypeParam> leveled = levels.at(p);
      for (double& x : leveled) x = std::fabs(x) < 0x1p-900 ? 0 : x;  // as products with a power of two lose them
      return wide_integer_sign<TypeParam>(leveled);
    };
  };
  EXPECT_EQ(lies<TypeParam>(stage(certify::integer::widest<TypeParam>), far, some), 0);
  EXPECT_GT(lies<TypeParam>(stage(9999), far, some), 0);
}

// One power of two for each axis, though the formula's terms differ in their degrees there.
TYPED_TEST(BrokenFilters, AxesScaledApartWhereTheFormulaForbidsItAreCaught) {
  const auto stage = [](const Coordinates<TypeParam>& p) {
    Coordinates<TypeParam> scaled = p;
    for (std::size_t i = 0; i < p.size(); i += static_cast<std::size_t>(TypeParam::dimension)) scaled[i] *= 0x1p-3;
    return integer_sign<TypeParam>(scaled);
  };
  const int count = lies<TypeParam>(stage, {Family::uniform, Family::grid, Family::degenerate_short}, some);
  if constexpr (certify::Levels<TypeParam>::count > 1) {
    EXPECT_EQ(count, 0);
  } else {
    EXPECT_GT(count, 10);
  }
}

// Arguments that share their first coordinate alone are not equal.
TYPED_TEST(BrokenFilters, ArgumentsEqualInOneAxisAloneAreCaught) {
  const auto stage = [](std::size_t axes) {
    return [=](const Coordinates<TypeParam>& p) {
      constexpr auto size = static_cast<std::size_t>(TypeParam::dimension);
      for (std::size_t i = 0; i < p.size(); i += size) {
        for (std::size_t k = 0; k < i; k += size) {
          if (std::equal(&p[i], &p[i] + axes, &p[k])) return Unsure{Sign::zero};
        }
      }
      return Unsure<Sign>{};
    };
  };
  EXPECT_EQ(
      lies<TypeParam>(stage(static_cast<std::size_t>(TypeParam::dimension)), {Family::grid, Family::mixture}, some), 0);
  EXPECT_GT(lies<TypeParam>(stage(1), {Family::grid, Family::mixture}, some), 10);
}

TYPED_TEST(BrokenFilters, IntegersCutOffInsteadOfRefusedAreCaught) {
  const auto stage = [](const Coordinates<TypeParam>& p) {
    const double largest = std::abs(*std::ranges::max_element(p, {}, [](double x) { return std::abs(x); }));
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largest) >> 52;
    if (exponent <= 60) return Unsure<Sign>{};
    const auto scale = std::bit_cast<double>((2106 - exponent) << 52);
    return Unsure{evaluate<TypeParam>([&](std::size_t i) {
                    return WideInt<certify::integer::long_bits>{static_cast<std::int64_t>(p[i] * scale)};
                  }).sign()};
  };
  EXPECT_GT(lies<TypeParam>(stage, far, some), 10);
}

TYPED_TEST(BrokenFilters, AnIntegerOneLimbTooNarrowIsCaught) {
  // The value's upper limbs dropped: what a width derived too small would do.
  const auto stage = [](const Coordinates<TypeParam>& p) {
    const Lattice lattice = lattice_of(p);
    if (lattice.bits > 61) return Unsure<Sign>{};
    const auto r = evaluate<TypeParam>([&](std::size_t i) {
      const OddForm f = odd_form(p[i]);
      return shifted<61>(f.mantissa, f.mantissa == 0 ? 0 : f.exponent - lattice.exponent);
    });
    return Unsure{WideInt<63>{r.low64()}.sign()};
  };
  EXPECT_GT(lies<TypeParam>(stage, {Family::uniform}, some), 10);
}

}  // namespace
}  // namespace plumb::battery
