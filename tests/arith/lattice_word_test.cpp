#include "plumb/arith/lattice_word.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "plumb/certify/plan.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {
namespace {

std::int64_t any_integer(Entropy& e, int bits) {
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  switch (e.below(3)) {
    case 0:
      return e.coin() ? most : -most;
    case 1:
      return e.within(std::min<std::int64_t>(most, 3));
    default:
      return e.within(most);
  }
}

TEST(LatticeWordTest, IsADoubleAndAnInteger) {
  for (int bits = 0; bits <= arith::lattice_word::double_bits; ++bits) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
      Entropy e(static_cast<std::uint64_t>(bits), i);
      const std::int64_t a = any_integer(e, bits), b = any_integer(e, bits);
      const std::uint64_t wa = arith::lattice_word::of(a), wb = arith::lattice_word::of(b);
      ASSERT_EQ(arith::lattice_word::integer(wa), a);
      const WordAsDouble da{wa}, db{wb};
      ASSERT_EQ(static_cast<double>(da), static_cast<double>(a));
      ASSERT_EQ(da - db, static_cast<double>(a - b));
      ASSERT_EQ(da + db, static_cast<double>(a + b));
      ASSERT_EQ(da * db, static_cast<double>(a) * static_cast<double>(b));
    }
  }
}

TEST(LatticeWordTest, IsAnIntegerUpTo62Bits) {
  for (int bits = 1; bits <= arith::lattice_word::integer_bits; ++bits) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
      Entropy e(static_cast<std::uint64_t>(bits), i);
      const std::int64_t a = any_integer(e, bits), b = any_integer(e, bits), c = any_integer(e, bits);
      const std::uint64_t wa = arith::lattice_word::of(a), wb = arith::lattice_word::of(b),
                          wc = arith::lattice_word::of(c);
      using Word = WordAsInteger<arith::lattice_word::integer_bits + 1>;
      ASSERT_EQ((Word{wa} - Word{wb}).low64(), a - b);
      ASSERT_EQ((Word{wa} + Word{wb}).low64(), a + b);
      ASSERT_TRUE((Word{wa} * Word{wb}).low128() == Int128{a} * b);
      // Beside an intermediate value, on either side.
      const auto difference = Word{wa} - Word{wb};
      ASSERT_TRUE((difference * Word{wc}).low128() == Int128{a - b} * c);
      ASSERT_TRUE((Word{wc} * difference).low128() == Int128{a - b} * c);
      ASSERT_TRUE((difference + Word{wc}).low128() == Int128{a - b} + c);
      ASSERT_TRUE((Word{wc} + difference).low128() == Int128{a - b} + c);
      ASSERT_TRUE((difference - Word{wc}).low128() == Int128{a - b} - c);
      ASSERT_TRUE((Word{wc} - difference).low128() == Int128{c} - (a - b));
      const Modular m = (WordModular{wa} - WordModular{wb}) * WordModular{wc} + WordModular{wa};
      ASSERT_EQ(m.value, static_cast<std::uint64_t>(Int128{a - b} * c + a));
    }
  }
}

// What WidthGrowth counts is what the types of WideInt say.
template <Formula F, int Bits>
consteval bool counts_as_types() {
  using Result = decltype(evaluate<F>([](std::size_t) { return WordAsInteger<Bits>{}; }));
  return Result::bits == certify::planned::growth<F>(Bits - 1).bits;
}
#define PLUMB_COUNTS(formula) \
  static_assert(counts_as_types<predicates::formula, 2>() && counts_as_types<predicates::formula, 20>());
PLUMB_CLASSICS(PLUMB_COUNTS)
#undef PLUMB_COUNTS

constexpr WidthGrowth::Input a{30}, b{30};
static_assert((a - b).bits == 30 && (a * b).bits == 60 && (a * b).widest_factor == 30);
static_assert((a * b + a).bits == 61 && ((a * b + a) * b).widest_factor == 61);
static_assert((a - a * b).widest_factor == 30);

}  // namespace
}  // namespace plumb
