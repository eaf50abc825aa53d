// How do cases get into the lanes of vectors, and their signs out?  Arrays of points, arrays of coordinates.
//
// Points that lie one after the other are not sorted fully: x, y and z end in three vectors that agree in which case a
// lane holds (blends and two rotations in space, interleaving in the plane), in an order of its own, which the table of
// signs undoes at no cost.  Differences are taken before that, so that it is done once for two points.
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BATCH_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BATCH_LANES
#undef PLUMB_BATCH_LANES
#else
#define PLUMB_BATCH_LANES
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
inline constexpr std::size_t lanes = HWY_LANES(double);
static_assert(lanes == 2 || lanes == 4 || lanes == 8);

/// A computed value, and what it must be beyond to have the exact sign.
struct Judged {
  V value, threshold;
};

HWY_INLINE V broadcast(double x) { return hn::Set(D(), x); }

/// One bit a lane, lane 0 the lowest.
HWY_INLINE unsigned bits_of(Mask mask) {
  std::uint8_t bits[8];
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0];
}

/// What was in lane l + By is in lane l.
template <std::size_t By>
HWY_INLINE V rotated(V v) {
  alignas(64) static constexpr auto from = [] {
    std::array<std::int64_t, lanes> lane{};
    for (std::size_t l = 0; l < lanes; ++l) lane[l] = static_cast<std::int64_t>((l + By) % lanes);
    return lane;
  }();
  return hn::TableLookupLanes(v, hn::SetTableIndices(D(), from.data()));
}

/// Three vectors of x y z x y z ... to one of x, one of y and one of z, all in one order of the cases: coordinate k of
/// case i is number 3 i + k, hence in lane (3 i + k) % lanes of some vector, where no other k needs that lane.
HWY_INLINE void arrange_in_space(V* v) {
  const V a = v[0], b = v[1], c = v[2];
  if constexpr (lanes == 2) {
    v[0] = hn::OddEven(b, a);
    v[1] = hn::CombineShiftRightBytes<8>(D(), c, a);
    v[2] = hn::OddEven(c, b);
  } else if constexpr (lanes == 4) {
    const V ab = hn::OddEven(a, b), bc = hn::OddEven(b, c), ca = hn::OddEven(c, a);
    v[0] = hn::ConcatUpperLower(D(), ab, ca);
    v[1] = rotated<1>(hn::ConcatUpperLower(D(), bc, ab));
    v[2] = rotated<2>(hn::ConcatUpperLower(D(), ca, bc));
  } else {
    constexpr std::uint8_t third[3][8] = {{0b01001001}, {0b10010010}, {0b00100100}};  // lanes l by l % 3
    const Mask m0 = hn::LoadMaskBits(D(), third[0]), m1 = hn::LoadMaskBits(D(), third[1]);
    const Mask m2 = hn::LoadMaskBits(D(), third[2]);
    v[0] = hn::IfThenElse(m0, a, hn::IfThenElse(m1, b, c));
    v[1] = rotated<1>(hn::IfThenElse(m1, a, hn::IfThenElse(m2, b, c)));
    v[2] = rotated<2>(hn::IfThenElse(m2, a, hn::IfThenElse(m0, b, c)));
  }
}

inline std::size_t cases_to_boundary(const double* at, std::size_t stride) {
  constexpr std::size_t bytes = lanes * sizeof(double);
  const auto address = reinterpret_cast<std::uintptr_t>(at);
  for (std::size_t i = 0; i < lanes; ++i) {
    if ((address + i * stride * sizeof(double)) % bytes == 0) return i;
  }
  return 0;
}

/// Points one after the other: x y z x y z ... at at[0].
struct ArrayOfPoints {
  template <std::size_t Dimension>
  static HWY_INLINE void load(const double* const* at, std::size_t first, V* raw) {
    for (std::size_t k = 0; k < Dimension; ++k) raw[k] = hn::LoadU(D(), at[0] + first * Dimension + k * lanes);
  }

  /// One point for all cases, as load would find it.
  template <std::size_t Dimension>
  static HWY_INLINE void repeat(const double* point, V* raw) {
    double all[Dimension * lanes];
    for (std::size_t i = 0; i < Dimension * lanes; ++i) all[i] = point[i % Dimension];
    for (std::size_t k = 0; k < Dimension; ++k) raw[k] = hn::LoadU(D(), all + k * lanes);
  }

  /// From vectors as loaded to one vector an axis.
  template <std::size_t Dimension>
  static HWY_INLINE void arrange(V* v) {
    if constexpr (Dimension == 2) {
      const V a = v[0], b = v[1];
      v[0] = hn::InterleaveLower(D(), a, b);
      v[1] = hn::InterleaveUpper(D(), a, b);
    } else {
      arrange_in_space(v);
    }
  }

  template <std::size_t Dimension>
  static constexpr std::size_t case_of_lane(std::size_t lane) {
    if constexpr (Dimension == 2) {
      return lane % 2 * (lanes / 2) + lane / 2;
    } else {
      std::size_t i = 0;
      while (3 * i % lanes != lane) ++i;
      return i;
    }
  }

  /// How many cases there are before one that begins where a vector does; 0 where there is none.
  template <std::size_t Dimension>
  static std::size_t to_boundary(const double* const* at) {
    return cases_to_boundary(at[0], Dimension);
  }

  /// Copies n cases to arrays of `lanes` cases, one after the other.
  template <std::size_t Dimension>
  static void copy(const double* const* at, std::size_t n, double* to) {
    std::memcpy(to, at[0], n * Dimension * sizeof(double));
  }
};

/// An array for each coordinate: x x x ... at at[0], y y y ... at at[1].
struct ArraysOfCoordinates {
  template <std::size_t Dimension>
  static HWY_INLINE void load(const double* const* at, std::size_t first, V* raw) {
    for (std::size_t k = 0; k < Dimension; ++k) raw[k] = hn::LoadU(D(), at[k] + first);
  }

  template <std::size_t Dimension>
  static HWY_INLINE void repeat(const double* point, V* raw) {
    for (std::size_t k = 0; k < Dimension; ++k) raw[k] = broadcast(point[k]);
  }

  template <std::size_t Dimension>
  static HWY_INLINE void arrange(V*) {}

  template <std::size_t Dimension>
  static constexpr std::size_t case_of_lane(std::size_t lane) {
    return lane;
  }

  template <std::size_t Dimension>
  static std::size_t to_boundary(const double* const* at) {
    return cases_to_boundary(at[0], 1);
  }

  template <std::size_t Dimension>
  static void copy(const double* const* at, std::size_t n, double* to) {
    for (std::size_t k = 0; k < Dimension; ++k) std::memcpy(to + k * lanes, at[k], n * sizeof(double));
  }
};

/// The signs of a vector's cases as bytes in the cases' order, for each set of lanes that are negative.
template <class Layout, std::size_t Dimension>
inline constexpr auto sign_bytes = [] {
  std::array<std::array<signed char, lanes>, 1u << lanes> table{};
  for (std::size_t negative = 0; negative < table.size(); ++negative) {
    for (std::size_t l = 0; l < lanes; ++l) {
      table[negative][Layout::template case_of_lane<Dimension>(l)] = (negative >> l & 1) != 0 ? -1 : 1;
    }
  }
  return table;
}();

/// Stores the signs of the values, and returns the set of lanes that are not beyond their threshold.
template <class Layout, std::size_t Dimension>
HWY_INLINE unsigned store_signs(const Judged& j, signed char* out) {
  std::memcpy(out, sign_bytes<Layout, Dimension>[bits_of(hn::Lt(j.value, hn::Zero(D())))].data(), lanes);
  return bits_of(hn::Gt(hn::Abs(j.value), j.threshold)) ^ ((1u << lanes) - 1);
}

/// Appends the numbers of the cases in these lanes that are in [low, high); the vector's first case is number `first`.
/// Returns the list's end.
template <class Layout, std::size_t Dimension>
HWY_INLINE std::uint32_t* list_cases(unsigned set_of_lanes, std::size_t first, std::size_t low, std::size_t high,
                                     std::uint32_t* list) {
  for (; set_of_lanes != 0; set_of_lanes &= set_of_lanes - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(set_of_lanes));
    const std::size_t i = first + Layout::template case_of_lane<Dimension>(lane);
    if (i >= low && i < high) *list++ = static_cast<std::uint32_t>(i);
  }
  return list;
}

/// One vector of cases, apart from the loop over all of them: at its ends.
template <class Judge>
HWY_NOINLINE unsigned filter_vector(const Judge& judge, const double* const* at, std::size_t first, signed char* out) {
  return store_signs<typename Judge::Points, Judge::dimension>(judge(at, first), out);
}

/// Fewer cases than lanes, beside zeros.
template <class Judge>
HWY_NOINLINE std::size_t filter_few(const Judge& judge, const double* const* at, std::size_t n, signed char* out,
                                    std::uint32_t* unsure) {
  using Points = typename Judge::Points;
  constexpr std::size_t dimension = Judge::dimension, to = Judge::coordinates;
  double padded[to * lanes] = {};
  const double* padded_at[to];
  signed char signs[lanes];
  for (std::size_t k = 0; k < to; ++k) padded_at[k] = padded + k * lanes;
  for (std::size_t k = Judge::first_coordinate; k < to; k += dimension) {
    Points::template copy<dimension>(at + k, n, padded + k * lanes);
  }
  const unsigned left = filter_vector(judge, padded_at, 0, signs);
  std::memcpy(out, signs, n);
  return static_cast<std::size_t>(list_cases<Points, dimension>(left, 0, 0, n, unsure) - unsure);
}

/// Filters n cases: their signs, and the list of those that are unsure, whose length it returns.
template <class Judge>
HWY_INLINE std::size_t filter_all(const Judge& judge, const double* const* at, std::size_t n, signed char* out,
                                  std::uint32_t* unsure) {
  using Points = typename Judge::Points;
  constexpr std::size_t dimension = Judge::dimension;
  const Judge at_ends = judge;  // the other one stays in registers
  if (n < lanes) return filter_few(at_ends, at, n, out, unsure);
  const double* mine[Judge::coordinates];  // nothing that a store to `out` could change
  for (std::size_t k = 0; k < Judge::coordinates; ++k) mine[k] = at[k];
  std::uint32_t* next = unsure;
  // Loads that cross cache lines take twice as long, so that the first vector overlaps the second; as the last does.
  std::size_t first = Points::template to_boundary<dimension>(at + Judge::first_coordinate);
  if (first != 0) next = list_cases<Points, dimension>(filter_vector(at_ends, at, 0, out), 0, 0, first, next);
  for (; first + lanes <= n; first += lanes) {
    const unsigned left = store_signs<Points, dimension>(judge(mine, first), out + first);
    if (HWY_UNLIKELY(left != 0)) next = list_cases<Points, dimension>(left, first, first, first + lanes, next);
  }
  if (first < n) {
    const std::size_t last = n - lanes;
    next = list_cases<Points, dimension>(filter_vector(at_ends, at, last, out + last), last, first, n, next);
  }
  return static_cast<std::size_t>(next - unsure);
}

}  // namespace plumb::certify::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // for this instruction set
