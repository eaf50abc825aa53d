// Minkowski difference: on which side of a plane through three of its points is a fourth?  Points that are a corner of one
// body less a corner of the other, and signs of what is computed of them.
//
// Laws: a sign is that of real arithmetic: doubles with running errors are asked first, then integers of a thousand bits,
// then integers of any length.
// Source: RTCD 3.11, 9.5; docs/proof.md.
// Cost: 10 to 20 ns where doubles decide, about a microsecond where integers do.
#pragma once

#include "arith/running_error.hpp"
#include "arith/short_dyadic.hpp"
#include "plumb/arith/big.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query::parting {

using arith::cross, arith::dot;
using Ends = DifferenceCorners::Ends;

/// The sign of value<T>(), which says the same over every number type.
template <class Value>
Sign sign_of(const Value& value) {
  if (const Unsure<Sign> s = value.template operator()<Running>().sign(); s.certain()) return s.value();
  if (const Unsure<Sign> s = value.template operator()<ShortDyadic>().sign(); s.certain()) return s.value();
  return value.template operator()<BigDyadic>().sign();
}

/// All a - b for a and b in the hulls of the corners.
struct Difference {
  const CoreCorners& a;
  const CoreCorners& b;

  template <class T>
  [[nodiscard]] Vec<T> at(const Ends& e) const {
    return a.at<T>(e[0]) - b.at<T>(e[1]);
  }
};

/// Of a triangle of difference points, which is counterclockwise seen from where its normal leads.
template <class T>
struct PlaneOf {
  Vec<T> normal;
  Vec<T> point;

  PlaneOf(const Vec<T>& p, const Vec<T>& q, const Vec<T>& r) : normal(cross(q - p, r - p)), point(p) {}
  [[nodiscard]] T height() const { return dot(normal, point); }  // of the origin below it, times the normal's length
  [[nodiscard]] T beyond(const Vec<T>& p) const { return dot(normal, p - point); }
};

/// A normal that is computed once over each number type that is asked.
template <class Of>
class Normal {
 public:
  explicit Normal(Of of) : of_(std::move(of)), rough_(of_.template operator()<Running>()) {}

  template <class T>
  [[nodiscard]] const Vec<T>& as() {
    if constexpr (std::is_same_v<T, Running>) {
      return rough_;
    } else if constexpr (std::is_same_v<T, ShortDyadic>) {
      if (!short_) short_ = of_.template operator()<ShortDyadic>();
      return *short_;
    } else {
      if (!big_) big_ = of_.template operator()<BigDyadic>();
      return *big_;
    }
  }

 private:
  Of of_;
  Vec<Running> rough_;
  std::optional<Vec<ShortDyadic>> short_;
  std::optional<Vec<BigDyadic>> big_;
};

}  // namespace plumb::query::parting
