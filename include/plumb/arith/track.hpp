// How large can a computed number be, and how far off, before the program runs?  Sizes and errors that are part of a
// number's type, derived operation by operation when it is compiled.
//
// A statement's leaves belong to scales: a scale is at run time one number that no leaf of it exceeds in magnitude, or
// one for each axis.  With M the product of the scales in the number's powers, and u = 2^-53:
// Laws: |computed| <= size M;  |computed - exact| <= error u M;  before its last rounding it was off by root u M at
// most, so that nothing is off where root is 0, and its sign is exact.  Every M lies between 2^-968 and 2^968, or
// nothing is claimed; a statement whose numbers' powers do not agree does not compile.
// Of pairs of doubles, of_pairs: |high| <= size M, |low| <= low u M, and both together are off by error u^2 M at most.
// Proof: docs/proof.md, "Tracked errors".
// Source: RTCD 11.2; the idea is that of static filters.
// Cost: none at run time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/arith/bound.hpp"

namespace plumb {

/// Throws std::logic_error; where the compiler derives, the statement is refused by this name.
[[noreturn]] void throw_unequal_powers();
[[noreturn]] void throw_powers_too_high();

/// Scalars all: GCC 12 gives types one name for the linker that differ in arrays within their parameters.
/// How many scales a statement has; bit by bit of which there is a number for each axis, which have weights, and which
/// are the largest of their leaves' magnitudes instead of the sum.  The largest is sharper in high powers, but a NaN is
/// not seen in it: the statement requires that a number is real in which all leaves are.
/// Of `known` ones, which are maxima too, the world is given a bound before there are leaves, which none of them exceeds.
/// Of `squares` doubles add up the squares of the leaves instead, which costs nothing where a statement does so itself:
/// the scale is the root, of which odd powers are judged by the square of the number.
/// And has scale 0 numbers that are multiplied crosswise, each by two of the scales 1, 2 and 3?
struct Scales {
  unsigned count = 1, each_axis = 0, weights = 0, maxima = 0;
  bool crosswise = false;
  unsigned squares = 0, known = 0;
};

struct Track {
  using Fixed = std::uint64_t;  // in units of 2^-32

  Fixed size, error, root;
  std::uint64_t powers;  // by power(s, k) below
  std::uint64_t others;  // where M is a sum of two products, the powers in the second, which are no less; else 0
  int highest;           // no sum of the powers' magnitudes is more
  unsigned each_axis;    // bit s: scale s has a number for each axis
  Fixed low = 0;
  bool of_pairs = false;

  static constexpr std::size_t scales = 4;

  /// The power of scale s: for k = 0 of a number's own axis, then of the next and of the one after; of a scale that is
  /// the same for all axes in the first place.
  [[nodiscard]] constexpr int power(std::size_t s, std::size_t k) const { return power_in(powers, s, k); }
  static constexpr int power_in(std::uint64_t of, std::size_t s, std::size_t k) {
    const int field = static_cast<int>(of >> shift(s, k) & 31);
    return field < 16 ? field : field - 32;
  }
  constexpr void set_power(std::size_t s, std::size_t k, int to) {
    powers &= ~(std::uint64_t{31} << shift(s, k));
    powers |= (static_cast<std::uint64_t>(to) & 31) << shift(s, k);
  }
  static constexpr int shift(std::size_t s, std::size_t k) { return 5 * static_cast<int>(3 * s + k); }
  [[nodiscard]] constexpr int total_power() const {
    int sum = 0;
    for (std::size_t s = 0; s < scales; ++s) {
      for (std::size_t k = 0; k < 3; ++k) sum += power(s, k) < 0 ? -power(s, k) : power(s, k);
    }
    return sum;
  }
  [[nodiscard]] constexpr bool is_of_axes(std::size_t s) const { return (each_axis >> s & 1) != 0; }

  static constexpr Fixed one = Fixed{1} << 32;

  friend constexpr bool operator==(const Track&, const Track&) = default;

  __extension__ using Wide = unsigned __int128;
  static constexpr Fixed checked(Wide x) {
    if (x >> 52) throw_bound_too_large();  // a unit pays for 2^-53 of anything smaller
    return static_cast<Fixed>(x);
  }
  /// Of pairs, whose errors nothing is multiplied by but what is accounted for.
  static constexpr Fixed checked_error(Wide x) {
    if (x >> 62) throw_bound_too_large();
    return static_cast<Fixed>(x);
  }
  static constexpr Wide wide_product(Fixed a, Fixed b) { return (static_cast<Wide>(a) * b + (one - 1)) >> 32; }
  static constexpr Fixed product(Fixed a, Fixed b) { return checked(wide_product(a, b)); }
};

namespace arith::track {

/// A number as given: itself, not rounded.
constexpr Track given(std::size_t scale, const Track& of_world) {
  Track t = of_world;
  t.size = Track::one;
  t.set_power(scale, 0, 1);
  return t;
}
/// A difference of two numbers as given, rounded once, or kept as a pair; the scale knows the rounded one.
constexpr Track difference(std::size_t scale, const Track& of_world) {
  Track t = given(scale, of_world);
  (t.of_pairs ? t.low : t.error) = Track::one;
  return t;
}
/// A difference that is no larger than two of them together, of which the scale is the sum, or each no more than it.
constexpr Track within(std::size_t scale, const Track& of_world, Track::Fixed scales = 1) {
  Track t = difference(scale, of_world);
  t.size = scales * Track::one + 1;  // for what they were rounded
  Track::Fixed& off = t.of_pairs ? t.low : t.error;
  off = scales == 1 ? off : t.size;
  return t;
}
/// A number as given of which the scale `over` times itself is in `scale`.
constexpr Track weight(std::size_t scale, std::size_t over, const Track& of_world) {
  Track t = given(scale, of_world);
  t.size = Track::one + 1;  // for the roundings of that product and sum
  t.set_power(over, 0, -1);
  return t;
}

/// A number in [0, 1], of no scale.
constexpr Track portion(const Track& of_world) {
  Track t = of_world;
  t.size = Track::one;
  return t;
}

/// A difference of which `scale` has the product with two others.
constexpr Track crosswise(std::size_t scale, std::size_t j, std::size_t k, const Track& of_world) {
  Track t = within(scale, of_world);
  (t.of_pairs ? t.low : t.error) = t.size;
  t.set_power(j, 0, -1), t.set_power(k, 0, -1);
  return t;
}

constexpr Track::Fixed larger(Track::Fixed a, Track::Fixed b) { return a > b ? a : b; }

/// Have both the same power of each scale, whatever its axes?
constexpr bool of_one_degree(std::uint64_t a, std::uint64_t b) {
  for (std::size_t s = 0; s < Track::scales; ++s) {
    int more = 0;
    for (std::size_t k = 0; k < 3; ++k) more += Track::power_in(a, s, k) - Track::power_in(b, s, k);
    if (more != 0) return false;
  }
  return true;
}
constexpr bool same_powers(const Track& a, const Track& b) { return a.powers == b.powers && a.others == b.others; }

/// Of a sum of pairs whose operands have these lows, errors and sizes together.
constexpr Track sum_of_pairs(const Track& of, Track::Wide low, Track::Wide error, Track::Wide size) {
  Track t = of;
  t.low = Track::checked(low + size + 1);
  t.error = t.root = Track::checked_error(low == 0 ? error : error + low + t.low + 1);
  t.size = Track::checked(size + 1);
  return t;
}
/// Of a + b and of a - b whose scales differ: M is the sum of both products.
constexpr Track sum_of_unlike(const Track& a, const Track& b) {
  if (a.others != 0 || b.others != 0 || a.powers == b.powers) throw_unequal_powers();
  Track t = a;
  t.powers = a.powers < b.powers ? a.powers : b.powers;
  t.others = a.powers < b.powers ? b.powers : a.powers;
  if (a.of_pairs) return sum_of_pairs(t, larger(a.low, b.low), larger(a.error, b.error), larger(a.size, b.size));
  t.size = larger(a.size, b.size);
  t.root = larger(a.error, b.error);
  t.error = Track::checked(static_cast<Track::Wide>(t.root) + t.size);
  ++t.size;
  return t;
}
/// Of a + b and of a - b.  Where the scales' axes differ, as in a cross product, they are unlike.
constexpr Track sum(const Track& a, const Track& b) {
  if (a.of_pairs && same_powers(a, b)) return sum_of_pairs(a, a.low + b.low, a.error + b.error, a.size + b.size);
  if (!same_powers(a, b)) {
    if (!of_one_degree(a.powers, b.powers)) throw_unequal_powers();
    return sum_of_unlike(a, b);
  }
  Track t = a;
  t.root = Track::checked(a.error + b.error);
  t.error = Track::checked(t.root + a.size + b.size);
  t.size = Track::checked(a.size + b.size + 1);  // the unit for the rounding, here and below
  return t;
}
/// Of x + x, which rounds nothing.
constexpr Track twice(const Track& a) {
  Track t = a;
  t.size = Track::checked(2 * a.size), t.error = 2 * a.error, t.root = 2 * a.root;
  if (!t.of_pairs) Track::checked(t.error);
  t.low = Track::checked(2 * a.low);
  return t;
}
constexpr Track product(const Track& a, const Track& b) {
  if (a.others != 0 || b.others != 0) throw_unequal_powers();  // of use to nobody yet
  Track t = a;
  for (std::size_t s = 0; s < Track::scales; ++s) {
    for (std::size_t k = 0; k < 3; ++k) t.set_power(s, k, a.power(s, k) + b.power(s, k));
  }
  if (t.total_power() > t.highest) throw_powers_too_high();
  const Track::Fixed size = Track::product(a.size, b.size);
  if (a.of_pairs) {
    const Track::Fixed across = Track::product(a.size, b.low) + Track::product(b.size, a.low);
    const Track::Wide inherited =
        Track::wide_product(a.size, b.error) + Track::wide_product(b.size, a.error) + Track::wide_product(a.low, b.low);
    // Errors times lows, and units for errors times errors and for underflow.
    const Track::Wide second =
        ((static_cast<Track::Wide>(a.low) * b.error + static_cast<Track::Wide>(b.low) * a.error) >> 85) + 3;
    t.low = Track::checked(static_cast<Track::Wide>(across) + size + 1);
    t.error = Track::checked_error(inherited + second +
                                   (across == 0 ? 0 : 2 * static_cast<Track::Wide>(across) + size + t.low));
    t.root = t.error;
    t.size = Track::checked(size + 1);
    return t;
  }
  // The product of both errors, and a unit for underflow: 2^-32 u M is more than 2^-1075.
  const auto second = static_cast<Track::Fixed>((static_cast<Track::Wide>(a.error) * b.error >> 85) + 2);
  t.root = Track::checked(static_cast<Track::Wide>(Track::product(a.size, b.error)) + Track::product(b.size, a.error) +
                          second);
  t.error = Track::checked(static_cast<Track::Wide>(t.root) + size);
  t.size = Track::checked(size + 1);
  return t;
}
/// Of the sum of three such products, of all that is crosswise: what `scale` has of each adds up to it, so that errors and
/// sizes do not; but what underflows does, and two sums are rounded.
constexpr Track sum_crosswise(const Track& crosswise, const Track& other) {
  Track t = product(crosswise, other);
  t.root = Track::checked(static_cast<Track::Wide>(t.error) + t.size + 4);
  t.error = Track::checked(static_cast<Track::Wide>(t.root) + t.size + 1);
  t.size = Track::checked(t.size + 2);
  return t;
}
/// Of the larger or the smaller of two, or of either of them: errors do not add.
constexpr Track either(const Track& a, const Track& b) {
  if (!same_powers(a, b)) throw_unequal_powers();
  Track t = a;
  t.size = larger(a.size, b.size), t.error = larger(a.error, b.error), t.root = larger(a.root, b.root);
  t.low = larger(a.low, b.low);
  return t;
}
/// Of the one that looks larger, or smaller: of pairs that differ by less than their difference is off it may be either.
constexpr Track extreme(const Track& a, const Track& b) {
  Track t = either(a, b);
  if (t.of_pairs) {
    const Track difference = sum(a, b);
    t.error = t.root = Track::checked_error(t.error + a.low + b.low + difference.low);
  }
  return t;
}
/// Of (1 - t) a + t b, for t in [0, 1].
constexpr Track between(const Track& a, const Track& b) {
  Track t = either(a, b);
  t.root = Track::checked(static_cast<Track::Wide>(t.error) + 2 * t.size + 4);  // units for underflow and second orders
  t.error = Track::checked(static_cast<Track::Wide>(t.root) + t.size + 1);
  t.size = Track::checked(t.size + 2);
  return t;
}
/// Of numbers of three axes that take one another's places: lane k has what lane k + 1 had.
constexpr std::uint64_t turned(std::uint64_t powers, const Track& of) {
  Track t = of;
  t.powers = powers;
  for (std::size_t s = 0; s < Track::scales; ++s) {
    if (!of.is_of_axes(s)) continue;
    for (std::size_t k = 0; k < 3; ++k) t.set_power(s, k, Track::power_in(powers, s, (k + 2) % 3));
  }
  return t.powers;
}
constexpr Track turned(const Track& a) {
  Track t = a;
  t.powers = turned(a.powers, a);
  if (a.others != 0) {
    const std::uint64_t others = turned(a.others, a);
    t.others = others < t.powers ? t.powers : others;
    t.powers = others < t.powers ? others : t.powers;
  }
  return t;
}
/// May numbers of different axes be added up?
constexpr bool alike(const Track& a) { return turned(a) == a; }
/// Of a number of one axis that all lanes have.
constexpr Track alike_in_all(const Track& a) {
  if (!alike(a)) throw_unequal_powers();
  return a;
}
/// The sum of three lanes.
constexpr Track total(const Track& a) { return sum(sum(alike_in_all(a), a), a); }

/// The first scale and axis from this one on, as 3 s + k, that has a part in it; 3 times the scales where none has.
constexpr std::size_t next_part(std::uint64_t powers, std::size_t from) {
  while (from < 3 * Track::scales && Track::power_in(powers, from / 3, from % 3) == 0) ++from;
  return from;
}

/// What a computed number must exceed for its sign to be certain, M being one; some roundings of its product with M, a
/// double of up to a dozen factors, are paid for.
constexpr double threshold(const Track& t) {
  return static_cast<double>(t.root) * (t.of_pairs ? 0x1p-138 : 0x1p-85) * (1 + 0x1p-47);
}

/// How far a computed number may be from the exact one, likewise.
constexpr double reach(const Track& t) {
  return static_cast<double>(t.error) * (t.of_pairs ? 0x1p-138 : 0x1p-85) * (1 + 0x1p-47);
}

/// What is taken from a computed number, or added to it, so that the exact one is no less, or no more, than the double that
/// this is rounded to.
constexpr double margin(const Track& t) { return static_cast<double>(t.error + t.size) * 0x1p-85 * (1 + 0x1p-47); }

/// The least power of two that a scale starts from, and the greatest that it may reach is one over it.  The low parts
/// of pairs need room below.
constexpr double floor_of(int highest, bool of_pairs = false) {
  double x = 1;
  for (int i = 0; i < (of_pairs ? 880 : 968) / highest; ++i) x /= 2;
  return x;
}

}  // namespace arith::track

}  // namespace plumb
