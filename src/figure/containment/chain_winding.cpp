// Compiled twice, for processors with lanes of four doubles (all that multiply and add at once) and for others.
#include "figure/containment/chain_winding.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "certify/fused.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

constexpr std::size_t block = 64;

/// Two points, one after the other.
using TwoPoints = double __attribute__((vector_size(32)));
using Flags = std::int64_t __attribute__((vector_size(32)));

/// Bits 2 i and 2 i + 1, in the lanes of the first point and of the second.
constexpr auto bits_of_pair = [] {
  std::array<std::array<std::int64_t, 4>, block / 2> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const auto first = static_cast<std::int64_t>(std::uint64_t{1} << 2 * i);
    const auto second = static_cast<std::int64_t>(std::uint64_t{2} << 2 * i);
    bits[i] = {first, first, second, second};
  }
  return bits;
}();

[[gnu::always_inline]] inline std::uint64_t merged(const Flags& of, std::size_t lane) {
  return static_cast<std::uint64_t>(of[lane] | of[lane + 2]);
}

/// Bit i: corner i lies to the left, to the right, below, above.
struct Sides {
  std::uint64_t left, right, below, above;

  /// The same bits of the corners before these.
  [[nodiscard]] constexpr Sides before(const Sides& last) const {
    return {left << 1 | last.left, right << 1 | last.right, below << 1 | last.below, above << 1 | last.above};
  }
  [[nodiscard]] constexpr Sides only(std::size_t i) const {
    return {left >> i & 1, right >> i & 1, below >> i & 1, above >> i & 1};
  }
};
Sides sides_of(const Point2& corner, const Point2& p) {
  const auto bit = [](bool b) { return static_cast<std::uint64_t>(b); };
  return {bit(corner.x < p.x), bit(corner.x > p.x), bit(corner.y < p.y), bit(corner.y > p.y)};
}

/// To which side of the line ab p lies; without a branch where doubles tell, for nobody can predict it.
Sign side_of(const Point2& a, const Point2& b, const Point2& p) {
  using predicates::Orient2d;
  const int quick = filter<Orient2d>({a.x, a.y, b.x, b.y, p.x, p.y});
  return quick != 0 ? static_cast<Sign>(quick) : orient2d(a, b, p);
}

[[gnu::noinline]] void count_open(std::uint64_t open, std::span<const Point2> corners, const Point2& last,
                                  const Point2& p, ChainWinding& out) {
  for (; open != 0; open &= open - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(open));
    const Point2 &a = i == 0 ? last : corners[i - 1], &b = corners[i];
    const Sign way = a.y < b.y ? Sign::positive : Sign::negative, side = side_of(a, b, p);
    out.is_on = out.is_on || side == Sign::zero;
    out.turns += side == way ? static_cast<int>(way) : 0;
  }
}

template <bool parity_alone>
class Count {
 public:
  [[gnu::always_inline]] Count(std::span<const Point2> chain, const Point2& p)
      : p_(p), at_{p.x, p.y, p.x, p.y}, zero_(at_ - at_) {
    if (chain.size() <= block) [[likely]] {
      const Sides to = sides(chain);
      add(chain, to, to.only(chain.size() - 1), chain.back());
    } else {
      Point2 last = chain.back();
      Sides of_last = sides_of(last, p);
      for (std::size_t start = 0; start < chain.size(); start += block) {
        const std::span<const Point2> corners = chain.subspan(start, std::min(block, chain.size() - start));
        const Sides to = sides(corners);
        add(corners, to, of_last, last);
        last = corners.back();
        of_last = to.only(corners.size() - 1);
      }
    }
    out.is_finite = is_finite();
  }
  ChainWinding out;

 private:
  [[nodiscard]] bool is_finite() const { return (zero_[0] + zero_[1]) + (zero_[2] + zero_[3]) == 0; }

  [[gnu::always_inline]] Sides sides(std::span<const Point2> corners) {
    Flags less{}, more{};
    const auto take = [&](std::size_t pair, const TwoPoints& two) {
      Flags bits;
      std::memcpy(&bits, &bits_of_pair[pair], sizeof bits);
      less |= (two < at_) & bits;
      more |= (two > at_) & bits;
      zero_ += two - two;
    };
    std::size_t i = 0;
    for (; i + 2 <= corners.size(); i += 2) {
      TwoPoints two;
      std::memcpy(&two, &corners[i], sizeof two);
      take(i / 2, two);
    }
    if (i < corners.size()) take(i / 2, TwoPoints{corners[i].x, corners[i].y, corners[i].x, corners[i].y});
    return {merged(less, 0), merged(more, 0), merged(less, 1), merged(more, 1)};
  }

  /// The edges to these corners, of the first one from `last`.
  [[gnu::always_inline]] void add(std::span<const Point2> corners, const Sides& to, const Sides& of_last,
                                  const Point2& last) {
    const Sides from = to.before(of_last);
    const std::uint64_t all = ~std::uint64_t{0} >> (block - corners.size());
    const std::uint64_t beside = (to.left & from.left) | (to.right & from.right);
    const std::uint64_t crossing = (to.above ^ from.above) & all, counted = crossing & to.right & from.right;
    if constexpr (parity_alone) {  // without a branch
      out.turns ^= __builtin_parityll(counted);
    } else {
      out.turns += std::popcount(counted & to.above) - std::popcount(counted & from.above);
    }
    if (const std::uint64_t level = ~(to.below | to.above) & all; level != 0) {
      const std::uint64_t at_corner = level & ~(to.left | to.right);
      out.is_on = out.is_on || (at_corner | (level & ~(from.below | from.above) & ~beside)) != 0;
    }
    if (const std::uint64_t open = crossing & ~beside; open != 0 && !out.is_on && is_finite())
      count_open(open, corners, last, p_, out);
  }

  const Point2& p_;
  TwoPoints at_, zero_;  // zero becomes NaN, and stays it, where a number is none
};

template <bool parity_alone>
PLUMB_WITH_FMA ChainWinding count_with_fma(std::span<const Point2> chain, const Point2& p) {
  return Count<parity_alone>(chain, p).out;
}
template <bool parity_alone>
PLUMB_WITHOUT ChainWinding count_without(std::span<const Point2> chain, const Point2& p) {
  return Count<parity_alone>(chain, p).out;
}

}  // namespace

ChainWinding winding_of(std::span<const Point2> chain, const Point2& p) {
  return has_fma ? count_with_fma<false>(chain, p) : count_without<false>(chain, p);
}
ChainWinding parity_of(std::span<const Point2> chain, const Point2& p) {
  return has_fma ? count_with_fma<true>(chain, p) : count_without<true>(chain, p);
}

}  // namespace plumb
