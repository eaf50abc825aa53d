// Support mapping by lanes: which of a list of points is farthest along a direction?  A guess in doubles, which holds no
// bound.
//
// Laws: of those that are as far the first one is told, where no product is NaN.  Lanes of two and of four doubles say
// the same: the products of a point are added in one order.
// Source: RTCD 9.5.4.
// Cost: three instructions a point in lanes of four, which pay above eight points; some thirty to find which it was.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "plumb/arith/point.hpp"

namespace plumb::query::quick_scan {

/// Of up to so many points there is no branch on what was found.
inline constexpr std::uint32_t most_at_once = 64;

/// Of at least four points, where certify/fused.hpp has such lanes: all that multiply and add at once do.
std::uint32_t farthest_by_fours(const Point3* at, std::uint32_t size, double x, double y, double z);
std::uint32_t farthest_by_pairs(const Point3* at, std::uint32_t size, double x, double y, double z);

using Two [[gnu::vector_size(16)]] = double;
using TwoBits [[gnu::vector_size(16)]] = std::int64_t;
using Four [[gnu::vector_size(32)]] = double;
using FourBits [[gnu::vector_size(32)]] = std::int64_t;

/// Lanes that a list of points has one after the other, by their number: one at a time, for a copy of three of them is
/// stored before it is read.
template <class V>
[[gnu::always_inline]] inline void load(V& out, const Point3* at, std::size_t number) {
  std::memcpy(&out, reinterpret_cast<const char*>(at) + number * sizeof(V), sizeof(V));
}

/// Two doubles: of points i and i + 1, as (x y) (z x) (y z).
struct PairLanes {
  using V = Two;
  using Bits = TwoBits;
  struct Along {
    V first, both, second;
    [[gnu::always_inline]] Along(double x, double y, double z) : first{x, y}, both{z, x}, second{y, z} {}
  };

  [[gnu::always_inline]] static void reaches(V& out, const Point3* at, const Along& n) {
    V first, both, second;
    load(first, at, 0), load(both, at, 1), load(second, at, 2);
    first *= n.first, both *= n.both, second *= n.second;
    out = (V{first[0], second[0]} + V{first[1], second[1]}) + both;
  }
  [[gnu::always_inline]] static void fill(V& out, double x) { out = V{x, x}; }
  [[gnu::always_inline]] static void bits_from(Bits& out, std::size_t i) { out = Bits{1, 2} << static_cast<int>(i); }
  [[gnu::always_inline]] static double most(const V& t) { return t[1] > t[0] ? t[1] : t[0]; }
  [[gnu::always_inline]] static std::int64_t united(const Bits& b) { return b[0] | b[1]; }
};

/// Four doubles: of points i to i + 3, as (x y z x) (y z x y) (z x y z).
struct QuadLanes {
  using V = Four;
  using Bits = FourBits;
  struct Along {
    V first, both, second;
    [[gnu::always_inline]] Along(double x, double y, double z)
        : first{x, y, z, x}, both{y, z, x, y}, second{z, x, y, z} {}
  };

  [[gnu::always_inline]] static void reaches(V& out, const Point3* at, const Along& n) {
    V p, q, r;
    load(p, at, 0), load(q, at, 1), load(r, at, 2);
    p *= n.first, q *= n.both, r *= n.second;
    const V first = __builtin_shufflevector(p, q, 0, 1, 6, 7);   // x0 y0 x2 y2
    const V both = __builtin_shufflevector(p, r, 2, 3, 4, 5);    // z0 x1 z2 x3
    const V second = __builtin_shufflevector(q, r, 0, 1, 6, 7);  // y1 z1 y3 z3
    out = (__builtin_shufflevector(first, second, 0, 4, 2, 6) + __builtin_shufflevector(first, second, 1, 5, 3, 7)) +
          both;
  }
  [[gnu::always_inline]] static void fill(V& out, double x) { out = V{x, x, x, x}; }
  [[gnu::always_inline]] static void bits_from(Bits& out, std::size_t i) {
    out = Bits{1, 2, 4, 8} << static_cast<int>(i);
  }
  [[gnu::always_inline]] static double most(const V& t) {
    const Two low = __builtin_shufflevector(t, t, 0, 1), high = __builtin_shufflevector(t, t, 2, 3);
    return PairLanes::most(high > low ? high : low);
  }
  [[gnu::always_inline]] static std::int64_t united(const Bits& b) {
    const TwoBits low = __builtin_shufflevector(b, b, 0, 1), high = __builtin_shufflevector(b, b, 2, 3);
    return PairLanes::united(low | high);
  }
};

/// The farthest of at least four points.
template <class Lanes>
class Scan {
 public:
  [[gnu::always_inline]] Scan(const Point3* at, std::uint32_t size, double x, double y, double z)
      : at_(at), size_(size), along_(x, y, z) {}

  /// First how far all of them are, then which one is that far: nothing waits for a comparison.  The last block ends
  /// where the points end, and begins within the one before it.
  [[nodiscard, gnu::always_inline]] std::uint32_t farthest() const {
    return size_ <= 8 ? of_eight() : size_ <= most_at_once ? farthest_at_once() : farthest_at_length();
  }
  /// Of no more.
  [[nodiscard, gnu::always_inline]] std::uint32_t of_eight() const {
    const std::uint32_t other = size_ - 4;
    Block b;
    set(b, 0, other);
    V most;
    most_of(most, b);
    const std::uint32_t place = place_of(b, Lanes::most(most));
    return place < 4 ? place : other + place - 4;
  }

 private:
  using V = typename Lanes::V;
  using Bits = typename Lanes::Bits;
  static constexpr std::size_t lanes = sizeof(V) / sizeof(double), parts = 8 / lanes;
  /// Four points from one place on and four from another.
  using Block = std::array<V, parts>;

  [[gnu::always_inline]] static void raise(V& most, const V& other) { most = other > most ? other : most; }
  [[gnu::always_inline]] static void most_of(V& most, const Block& b) {
    if constexpr (parts == 4) {
      V other = b[2];
      most = b[0];
      raise(most, b[1]), raise(other, b[3]), raise(most, other);
    } else {
      most = b[0];
      raise(most, b[1]);
    }
  }
  [[gnu::always_inline]] void set(Block& b, std::uint32_t from, std::uint32_t other) const {
    for (std::size_t k = 0; k < parts / 2; ++k) {
      Lanes::reaches(b[k], at_ + from + k * lanes, along_);
      Lanes::reaches(b[k + parts / 2], at_ + other + k * lanes, along_);
    }
  }
  /// Which of eight is as much as this: the first one, and one of them where there is NaN.
  [[gnu::always_inline]] static std::uint32_t place_of(const Block& b, double most) {
    V wanted;
    Lanes::fill(wanted, most);
    Bits found{};
    for (std::size_t k = 0; k < parts; ++k) {
      Bits bits;
      Lanes::bits_from(bits, k * lanes);
      found |= (b[k] == wanted) & bits;
    }
    return static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint64_t>(Lanes::united(found) | 128)));
  }
  [[nodiscard, gnu::always_inline]] std::uint32_t farthest_at_once() const {
    std::array<Block, most_at_once / 8> all;
    std::array<V, most_at_once / 8> most_in;
    set(all[0], 0, 4), most_of(most_in[0], all[0]);
    V most = most_in[0];
    const std::uint32_t blocks = (size_ + 7) / 8, last = size_ - 8;
    for (std::uint32_t k = 1; k < blocks; ++k) {
      const std::uint32_t from = std::min(8 * k, last);
      set(all[k], from, from + 4), most_of(most_in[k], all[k]);
      raise(most, most_in[k]);
    }
    const double far = Lanes::most(most);
    V wanted;
    Lanes::fill(wanted, far);
    Bits bit{}, found{};
    bit += 1;
    for (std::uint32_t k = 0; k < blocks; ++k, bit += bit) found |= (most_in[k] == wanted) & bit;
    const auto k = static_cast<std::uint32_t>(
        std::countr_zero(static_cast<std::uint64_t>(Lanes::united(found)) | std::uint64_t{1} << (blocks - 1)));
    return std::min(8 * k, last) + place_of(all[k], far);
  }
  /// The same of many: the best block so far.
  [[nodiscard, gnu::always_inline]] std::uint32_t farthest_at_length() const {
    Block best;
    V most;
    set(best, 0, 4), most_of(most, best);
    double far = Lanes::most(most);
    std::uint32_t best_from = 0;
    for (std::uint32_t from = 8; from < size_; from += 8) {
      const std::uint32_t start = std::min(from, size_ - 8);
      Block b;
      set(b, start, start + 4), most_of(most, b);
      if (Lanes::most(most) > far) best = b, far = Lanes::most(most), best_from = start;
    }
    return best_from + place_of(best, far);
  }

  const Point3* at_;
  std::uint32_t size_;
  typename Lanes::Along along_;
};

}  // namespace plumb::query::quick_scan
