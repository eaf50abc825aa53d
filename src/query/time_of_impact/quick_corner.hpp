// GJK, Minkowski difference: which point of the differences of two shapes is nearest to the origin?  A guess, and what
// it takes to be sure.
//
// Laws: over numbers that know their errors, and whose signs certain_sign() tells, nearest() is sure: the origin's
// projection on the corner's point, line or plane is strictly within its ways, and the direction there leads nowhere
// back, so no other difference is as near.
// Source: RTCD 3.10, 5.1.2, 5.1.5, 5.1.9.
// Cost: three cross products, and a dot product for each way.
#pragma once

#include <array>
#include <optional>

#include "query/time_of_impact/quick_hull.hpp"

namespace plumb::query::quick {

/// Where a point is in a hull: at a vertex, from which some ways are all inside and others reach beyond.
struct ExtremeFace {
  unsigned vertex = 0;
  std::array<unsigned, 3> inside{}, beyond{};  // numbers of ways
  unsigned inside_count = 0, beyond_count = 0;
  Feature feature{};
};

template <class Hull>
ExtremeFace place_of(const Parts& parts) {
  ExtremeFace p;
  if constexpr (Hull::is_triangle) {
    unsigned count = 0, last = 0;
    for (unsigned i = 0; i < 3; ++i) {
      if (parts[i] > 0) ++count, last = i;
    }
    if (count == 3) return {0, {0, 2}, {}, 2, 0, Hull::face(0, 0)};
    if (count == 1) return {last, {}, {last, (last + 2) % 3}, 0, 2, Hull::vertex(last)};
    const unsigned edge = parts[2] == 0 ? 0 : parts[0] == 0 ? 1 : 2;
    return {edge, {edge}, {(edge + 2) % 3}, 1, 1, Hull::edge(edge, 0)};
  } else {
    for (unsigned i = 0; i < Hull::way_count; ++i) {
      constexpr double near = 0x1p-40;  // a guess: nearest() proves what is inside
      const bool low = parts[i] <= Hull::least + near, high = parts[i] >= 1 - near;
      if (high) p.vertex |= 1U << i;
      if (low || high) {
        p.beyond[p.beyond_count++] = i;
      } else {
        p.inside[p.inside_count++] = i;
      }
    }
    if (p.inside_count == 0) p.feature = Hull::vertex(p.vertex);
    if (p.inside_count == 1) p.feature = Hull::edge(p.inside[0], p.vertex);
    if (p.inside_count == 2) p.feature = Hull::face(p.beyond[0], p.vertex);
    return p;
  }
}

/// From the vertex along the way, into the hull.
template <class Hull>
auto inward(const Hull& hull, const ExtremeFace& place, unsigned way) {
  const auto whole = hull.whole_way(way);
  const bool back = Hull::is_triangle ? way != place.vertex : (place.vertex >> way & 1) != 0;
  using N = decltype(whole.x);
  return back ? Vec3<N>{N(0.0), N(0.0), N(0.0)} - whole : whole;
}

/// A corner of the differences, up to two ways within which the nearest one is, and others that have to lead away.
template <class N>
struct Corner {
  Vec3<N> at;
  std::array<Vec3<N>, 6> inside, beyond;
  unsigned inside_count = 0, beyond_count = 0;
  bool triangle = false;

  /// `apart` is from the place of a to that of b.
  template <class A, class B>
  Corner(const Vec3<N>& apart, const A& a, const B& b, const ExtremeFace& of_a, const ExtremeFace& of_b)
      : at((apart + b.at(of_b.vertex)) - a.at(of_a.vertex)),
        inside{none(), none(), none(), none(), none(), none()},
        beyond(inside),
        triangle((B::is_triangle && of_b.inside_count == 2) || (A::is_triangle && of_a.inside_count == 2)) {
    for (unsigned i = 0; i < of_b.inside_count; ++i) inside[inside_count++] = inward(b, of_b, of_b.inside[i]);
    for (unsigned i = 0; i < of_a.inside_count; ++i) inside[inside_count++] = none() - inward(a, of_a, of_a.inside[i]);
    for (unsigned i = 0; i < of_b.beyond_count; ++i) beyond[beyond_count++] = inward(b, of_b, of_b.beyond[i]);
    for (unsigned i = 0; i < of_a.beyond_count; ++i) beyond[beyond_count++] = none() - inward(a, of_a, of_a.beyond[i]);
  }
  static Vec3<N> none() { return {N(0.0), N(0.0), N(0.0)}; }

  /// The direction of the nearest difference; and parts x, y of the ways, times `whole`.
  struct Nearest {
    Vec3<N> direction;
    N whole, x, y;
  };
  [[nodiscard]] std::optional<Nearest> nearest() const {
    Nearest found{at, N(1.0), N(0.0), N(0.0)};
    if (inside_count == 1) {
      const Vec3<N>& way = inside[0];
      found.whole = dot(way, way);
      const N back = dot(at, way);
      if (certain_sign(back) >= 0 || certain_sign(found.whole + back) <= 0) return {};
      found.direction = at * found.whole - way * back;
      found.x = N(0.0) - back;
    } else if (inside_count == 2) {
      const Vec3<N>&x = inside[0], &y = inside[1], n = cross(x, y);
      const N whole = dot(n, n), gap = dot(at, n);
      found = {n, whole, dot(cross(y, at), n), dot(cross(at, x), n)};
      if (certain_sign(gap) == 0 || certain_sign(found.x) <= 0 || certain_sign(found.y) <= 0) return {};
      if (triangle ? certain_sign((whole - found.x) - found.y) <= 0
                   : certain_sign(whole - found.x) <= 0 || certain_sign(whole - found.y) <= 0)
        return {};
      if (certain_sign(gap) < 0) found.direction = none() - n;
    }
    for (unsigned i = 0; i < beyond_count; ++i) {
      if (certain_sign(dot(found.direction, beyond[i])) <= 0) return {};
    }
    return found;
  }
};

}  // namespace plumb::query::quick
