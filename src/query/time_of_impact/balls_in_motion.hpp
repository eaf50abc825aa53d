// Two balls in straight motion: what is the quadratic of time that is not positive where they meet?
//
// A statement over a world: c + 2 h t + e t^2, its value and half its slope at time 1, a quarter of its discriminant.
// Law: of floats all are as near to those of the exact numbers as their types say; the distance is of scale 0, the motion
// of scale 1, and what has both of scale 2.
// Source: RTCD 5.5.5.
// Cost: three dot products, and one more.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "query/time_of_impact/quick_hull.hpp"

namespace plumb::query::quick {

template <class Listener = NoBoundListener>
using BallsWorld = certify::one_lane::Floats<double, 4, Scales{.count = 3, .squares = 0b111}, Listener>;

template <class W>
class BallsInMotion {
  template <std::size_t scale>
  using Leaf = decltype(std::declval<W&>().template difference<scale>(0.0, 0.0));
  using Radius = decltype(std::declval<W&>().template number<0>(0.0));

 public:
  BallsInMotion(W& w, const Point3& a, const Point3& b, double of_a, double of_b, const Vector3& by_a,
                const Vector3& by_b)
      : apart_{w.template difference<0>(a.x, b.x), w.template difference<0>(a.y, b.y),
               w.template difference<0>(a.z, b.z)},
        by_{w.template difference<1>(by_a.x, by_b.x), w.template difference<1>(by_a.y, by_b.y),
            w.template difference<1>(by_a.z, by_b.z)},
        of_a_(w.template number<0>(of_a)),
        of_b_(w.template number<0>(of_b)) {
    if constexpr (has_scales) {  // in this order, so that the sum of squares of scale 0 is the beginning of this one
      const auto add = [&](const auto&... x) { (w.template number<2>(x.value), ...); };
      add(apart_.x, apart_.y, apart_.z, of_a_, of_b_, by_.x, by_.y, by_.z);
    }
  }

  [[nodiscard]] auto c() const { return excess(apart_, of_a_ + of_b_); }
  [[nodiscard]] auto h() const { return inner(apart_, by_); }
  [[nodiscard]] auto e() const { return inner(by_, by_); }
  [[nodiscard]] auto discriminant() const { return h() * h() - e() * c(); }
  [[nodiscard]] auto slope_at_end() const {
    return inner(of_both(apart_), of_both(by_)) + inner(of_both(by_), of_both(by_));
  }
  [[nodiscard]] auto value_at_end() const {
    const auto d = of_both(apart_);
    return (excess(d, of_both(of_a_) + of_both(of_b_)) + inner(d, of_both(by_))) + slope_at_end();
  }

 private:
  static constexpr bool has_scales = requires(const W& w) { w.template square_of_scale<0>(); };

  static auto excess(const auto& d, const auto& reach) { return inner(d, d) - reach * reach; }
  /// The same number; of floats of the scale that no other exceeds.
  static auto of_both(const Radius& x) {
    if constexpr (has_scales) {
      return Number{x.value};
    } else {
      return x;
    }
  }
  template <class N>
  static auto of_both(const Vec3<N>& v) {
    if constexpr (has_scales) {
      return Vec3<Leaf<2>>{{v.x.value}, {v.y.value}, {v.z.value}};
    } else {
      return v;
    }
  }
  using Number = decltype(std::declval<W&>().template number<2>(0.0));

  Vec3<Leaf<0>> apart_;
  Vec3<Leaf<1>> by_;
  Radius of_a_, of_b_;
};

}  // namespace plumb::query::quick
