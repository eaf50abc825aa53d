// Minkowski difference: on which side of a plane through three of its points is a fourth?  Points that are a corner of
// one body less a corner of the other, and signs of what is computed of them.
//
// Laws: a sign is that of real arithmetic: doubles with running errors are asked first, then integers of a thousand
// bits, then integers of any length.
// Source: RTCD 3.11, 9.5; docs/proof.md.
// Cost: 10 to 20 ns where doubles decide, about a microsecond where integers do.
#pragma once

#include <bit>
#include <limits>

#include "certify/carried_errors.hpp"
#include "query/penetration/corners_by_pairs.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query::parting {

using arith::cross, arith::dot;
using Ends = DifferenceCorners::Ends;

template <class T>
const T& along_axis(const Vec<T>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The sign of value<T>(), which says the same over every number type; after doubles.
template <class Value>
Sign exact_sign_of(const Value& value) {
  return sign_in<SignWorlds<StackDyadic, BigDyadic>>(value);
}
template <class Value>
Sign sign_of(const Value& value) {
  return sign_in<SignWorlds<Running, StackDyadic, BigDyadic>>(value);
}

/// From one corner to another; of a sum along an edge by that edge alone.
template <class T>
Vec<T> between(const CoreCorners& c, std::uint32_t from, std::uint32_t to) {
  const std::uint32_t bits = from ^ to;
  if (!c.is_sum() || !std::has_single_bit(bits)) return corner_of<T>(c, to) - corner_of<T>(c, from);
  const Vec<T> edge = edge_of<T>(c, static_cast<std::size_t>(std::countr_zero(bits)));
  return to > from ? edge : Vec<T>{T(0.0), T(0.0), T(0.0)} - edge;
}

/// All a - b for a and b in the hulls of the corners.
struct Difference {
  const CoreCorners& a;
  const CoreCorners& b;

  template <class T>
  [[nodiscard]] Vec<T> at(const Ends& e) const {
    return corner_of<T>(a, e[0]) - corner_of<T>(b, e[1]);
  }
  /// From one point to another: what both have in common takes no part in it.
  template <class T>
  [[nodiscard]] Vec<T> between(const Ends& from, const Ends& to) const {
    if (from[1] == to[1]) return parting::between<T>(a, from[0], to[0]);
    const Vec<T> of_b = parting::between<T>(b, to[1], from[1]);
    return from[0] == to[0] ? of_b : parting::between<T>(a, from[0], to[0]) + of_b;
  }
};

/// Of a triangle of difference points, which is counterclockwise seen from where its normal leads.
template <class T>
struct PlaneOf {
  Vec<T> normal;
  Vec<T> point;

  PlaneOf(const Vec<T>& p, const Vec<T>& q, const Vec<T>& r) : normal(cross(q - p, r - p)), point(p) {}
  PlaneOf(const Vec<T>& n, const Vec<T>& p) : normal(n), point(p) {}
  [[nodiscard]] T height() const { return dot(normal, point); }  // of the origin below it, times the normal's length
  [[nodiscard]] T beyond(const Vec<T>& p) const { return dot(normal, p - point); }
};

/// Integers that are computed once.  Where they left the range, they leave it each time that they are asked.
class Kept {
 public:
  explicit Kept(const Vec<StackDyadic>& v) : v_(v), is_lost_(StackDyadic::left_range()) {}
  [[nodiscard]] const Vec<StackDyadic>& get() const {
    if (is_lost_) static_cast<void>(StackDyadic(std::numeric_limits<double>::quiet_NaN()));
    return v_;
  }

 private:
  Vec<StackDyadic> v_;
  bool is_lost_;
};

/// A normal that is computed once over each number type that is asked.
template <class Of>
class Normal {
 public:
  explicit Normal(Of of) : of_(std::move(of)) {}

  template <class T>
  [[nodiscard]] const Vec<T>& as() {
    if constexpr (std::is_same_v<T, Running>) {
      if (!rough_) rough_ = of_.template operator()<Running>();
      return *rough_;
    } else if constexpr (std::is_same_v<T, StackDyadic>) {
      if (!short_) short_.emplace(of_.template operator()<StackDyadic>());
      return short_->get();
    } else {
      if (!big_) big_ = of_.template operator()<BigDyadic>();
      return *big_;
    }
  }

 private:
  Of of_;
  std::optional<Vec<Running>> rough_;
  std::optional<Kept> short_;
  std::optional<Vec<BigDyadic>> big_;
};

/// Corners of a body that are known to be level with the first of them; of what has ways all that these lead to.
class KnownLevel {
 public:
  KnownLevel(const CoreCorners& c, std::uint32_t first) : corner_{first, first, first}, by_ways_(c.ways() > 0) {}

  [[nodiscard]] bool has(std::uint32_t i) const {
    if (by_ways_) return ((i ^ corner_[0]) & ~ways_) == 0;
    return i == corner_[0] || i == corner_[1] || i == corner_[2];
  }
  void add(std::uint32_t i) {
    if (!by_ways_) {
      corner_[1] == corner_[0] ? corner_[1] = i : corner_[2] = i;
    } else if (const std::uint32_t new_ways = (i ^ corner_[0]) & ~ways_; std::has_single_bit(new_ways)) {
      ways_ |= new_ways;
    }
  }

 private:
  std::array<std::uint32_t, 3> corner_;
  std::uint32_t ways_ = 0;
  bool by_ways_;
};

/// What is known of the plane through three points without arithmetic: two differences in it that share a corner of one
/// body have corners of the other that are level, too.
struct KnownPlane {
  KnownLevel a, b;

  KnownPlane(const Difference& d, const std::array<Ends, 3>& e) : a(d.a, e[0][0]), b(d.b, e[0][1]) {
    for (int round = 0; round < 3; ++round) {
      for (std::size_t k = 1; k < 3; ++k) {
        const bool in_a = a.has(e[k][0]), in_b = b.has(e[k][1]);
        if (in_a && !in_b) b.add(e[k][1]);
        if (in_b && !in_a) a.add(e[k][0]);
      }
    }
  }
  [[nodiscard]] bool has(const Ends& e) const { return a.has(e[0]) && b.has(e[1]); }
};

}  // namespace plumb::query::parting
