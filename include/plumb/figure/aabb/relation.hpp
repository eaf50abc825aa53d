// Bounding volumes (AABB): do two axis-aligned boxes meet, and does one hold the other?  In each of their three
// representations.
//
// Laws: (1) the closed sets of the numbers in real arithmetic decide: min + widths and center + half are never rounded.
// (2) relate and intersects are symmetric; intersects(a, b) is relate(a, b) != disjoint.  (3) An empty box meets
// nothing, and every box holds it.  (4) The three representations of one box answer alike.
// NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 4.2.1, 6.5.1.
// Cost: min-max boxes less than twice that of the plain test, without branches on what is found: the sum of all numbers
// is finite only where each is.  Nothing is searched.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

namespace figure::box {

/// Two numbers that stand together, of which one operation of the machine makes two others: numbers i and i + 1.
using Two = double __attribute__((vector_size(16)));
template <class Box>
[[gnu::always_inline]] inline Two two_of(const Box& box, std::size_t i) {
  Two two;
  __builtin_memcpy(&two, reinterpret_cast<const char*>(&box) + i * sizeof(double), sizeof two);
  return two;
}
template <class Box>
inline constexpr std::size_t numbers_in = sizeof(Box) / sizeof(double);

/// What the boxes have in common along axes k and k + 1: what lies between these, if anything does.
struct Common {
  Two starts, ends;
};
template <class Box>
[[gnu::always_inline]] inline Common common(const Box& a, const Box& b, std::size_t k) {
  const std::size_t end = k + numbers_in<Box> / 2;
  const Two a_starts = two_of(a, k), b_starts = two_of(b, k), a_ends = two_of(a, end), b_ends = two_of(b, end);
  return {a_starts > b_starts ? a_starts : b_starts, a_ends < b_ends ? a_ends : b_ends};
}
/// Along all of them; in the plane twice.
template <class Box>
[[gnu::always_inline]] inline std::array<Common, 2> common(const Box& a, const Box& b) {
  return {common(a, b, 0), common(a, b, numbers_in<Box> / 2 - 2)};
}
/// The sum of all numbers: it is finite only where each is.
template <class Box>
[[gnu::always_inline]] inline double sum_of(const Box& a, const Box& b) {
  Two all = two_of(a, 0) + two_of(b, 0);
  for (std::size_t i = 2; i < numbers_in<Box>; i += 2) all += two_of(a, i) + two_of(b, i);
  return all[0] + all[1];
}

/// For boxes that touch, are flat, or whose numbers add up to no double; `function` is what a failure names.
Relation relate_exactly(std::string_view function, const Aabb2& a, const Aabb2& b);
Relation relate_exactly(std::string_view function, const Aabb3& a, const Aabb3& b);

template <class Box>
Relation relate(const Box& a, const Box& b) {
  const double sum = sum_of(a, b);
  const auto [first, second] = common(a, b);
  const Two gaps = first.starts - first.ends, others = second.starts - second.ends;
  const Two most = gaps > others ? gaps : others;
  const double gap = (most[0] > most[1] ? most[0] : most[1]) + (sum - sum);
  if (gap > 0) return Relation::disjoint;
  if (gap < 0) return Relation::overlapping;
  return relate_exactly("relate", a, b);
}

template <class Box>
bool intersects(const Box& a, const Box& b) {
  const double sum = sum_of(a, b);
  if (!(sum - sum == 0)) [[unlikely]]
    return relate_exactly("intersects", a, b) != Relation::disjoint;
  const auto [first, second] = common(a, b);
  const auto in = (first.starts <= first.ends) & (second.starts <= second.ends);
  return (in[0] & in[1]) != 0;
}

}  // namespace figure::box

inline Relation relate(const Aabb2& a, const Aabb2& b) { return figure::box::relate(a, b); }
inline Relation relate(const Aabb3& a, const Aabb3& b) { return figure::box::relate(a, b); }
Relation relate(const AabbWidths3& a, const AabbWidths3& b);
Relation relate(const AabbCenter3& a, const AabbCenter3& b);

inline bool intersects(const Aabb2& a, const Aabb2& b) { return figure::box::intersects(a, b); }
inline bool intersects(const Aabb3& a, const Aabb3& b) { return figure::box::intersects(a, b); }
bool intersects(const AabbWidths3& a, const AabbWidths3& b);
bool intersects(const AabbCenter3& a, const AabbCenter3& b);

/// Does the outer box hold every point of the inner one?
bool contains(const Aabb2& outer, const Aabb2& inner);
bool contains(const Aabb3& outer, const Aabb3& inner);
bool contains(const AabbWidths3& outer, const AabbWidths3& inner);
bool contains(const AabbCenter3& outer, const AabbCenter3& inner);

}  // namespace plumb
