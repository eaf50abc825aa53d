// Does a ray pass a triangle by?  Seen along an axis, all corners lie on one side of the ray's line.
//
// Laws: true only where they do not meet, in real arithmetic; false says nothing.
// Source: RTCD 5.3.4 (the sides of a triangle's corners, seen along the ray).
// Cost: six products for each axis.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "space/kd_tree/plane_walk.hpp"

namespace plumb::space::kd {

/// The side of the line on which three places are, along two axes a and b; zero where that is not one.
template <bool is_segment>
struct SideOfCorners {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};

  template <class W>
  Sign operator()(W& w, double from_a, double from_b, double to_a, double to_b, double p_a, double p_b, double q_a,
                  double q_b, double r_a, double r_b) const {
    const auto along = [&](double to, double from) {
      if constexpr (is_segment) {
        return w.template difference<1>(to, from);
      } else {
        return w.template number<1>(to);
      }
    };
    const auto way_a = along(to_a, from_a), way_b = along(to_b, from_b);
    const auto side = [&](double a, double b) {
      return w.compare(w.difference(b, from_b) * way_a, w.difference(a, from_a) * way_b);
    };
    const Sign first = side(p_a, p_b);
    return first != Sign::zero && side(q_a, q_b) == first && side(r_a, r_b) == first ? first : Sign::zero;
  }
};

/// Of a triangle; of what is none it is not asked.
template <std::size_t d, class Figure>
bool is_passed_by(const Path<d>& path, const Figure& figure) {
  if constexpr (requires { figure.c; }) {
    const auto p = coordinates(figure.a), q = coordinates(figure.b), r = coordinates(figure.c);
    for (std::size_t a = 0; a < (d == 3 ? 3 : 1); ++a) {
      const std::size_t b = (a + 1) % d;
      const auto ask = [&](const auto& statement) {
        return certainly(statement, path.from[a], path.from[b], path.to[a], path.to[b], p[a], p[b], q[a], q[b], r[a],
                         r[b]);
      };
      if ((path.is_ray ? ask(SideOfCorners<false>{}) : ask(SideOfCorners<true>{})) != Sign::zero) return true;
    }
  }
  return false;
}

}  // namespace plumb::space::kd
