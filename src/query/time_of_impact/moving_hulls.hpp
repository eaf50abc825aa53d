// Minkowski difference, in motion: what moves linearly, seen as what bounds the differences of two figures?  Two edges,
// or a vertex and a triangle.
//
// Laws: over any number type; the difference of two points of the figures is that of their first vertices and parts of
// their ways, all linear in time, so what it changes by is made of the changes in the same way.
// Source: RTCD 5.5.
// Cost: a few sums and products.
#pragma once

#include "query/time_of_impact/contact_filter.hpp"
#include "query/time_of_impact/quick_hull.hpp"

namespace plumb::query::moving {

/// A vector that moves linearly.
template <class N>
struct Linear {
  Vec3<N> at_0, at_1;
  [[nodiscard]] Vec3<N> change() const { return at_1 - at_0; }
};
/// Where it is at a time between 0 and 1 of at most 53 places, or as long as that of numbers that know their errors.
struct Moment {
  double time;
  template <class N>
  [[nodiscard]] Vec3<N> operator()(const Linear<N>& v) const {
    return v.at_0 * N(1 - time) + v.at_1 * N(time);
  }
};
template <class N>
struct Span {
  N time;
  [[nodiscard]] Vec3<N> operator()(const Linear<N>& v) const { return v.at_0 + v.change() * time; }
};
struct Change {
  template <class N>
  [[nodiscard]] Vec3<N> operator()(const Linear<N>& v) const {
    return v.change();
  }
};

template <class N>
Linear<N> linear(const ContactQuestion& q, std::size_t from, std::size_t to) {
  return {between<N>(q.at_0[from], q.at_0[to]), between<N>(q.at_1[from], q.at_1[to])};
}

/// What moves: two edges, or a vertex and a triangle.  The difference of their points is the one of their first
/// vertices and parts of their ways.
template <class N>
struct Edges {
  using HullA = quick::Woven<N, 1, false>;
  using HullB = quick::Woven<N, 1, false>;

  explicit Edges(const ContactQuestion& q) : apart(linear<N>(q, 0, 2)), a(linear<N>(q, 0, 1)), b(linear<N>(q, 2, 3)) {}
  [[nodiscard]] HullA hull_a(const auto& when) const { return {{}, {when(a)}}; }
  [[nodiscard]] HullB hull_b(const auto& when) const { return {{}, {when(b)}}; }

  Linear<N> apart, a, b;
};
template <class N>
struct VertexAndTriangle {
  using HullA = quick::Woven<N, 0, false>;
  using HullB = quick::ThreeCorners<N>;

  explicit VertexAndTriangle(const ContactQuestion& q)
      : apart(linear<N>(q, 0, 1)), ways{linear<N>(q, 1, 2), linear<N>(q, 2, 3), linear<N>(q, 3, 1)} {}
  [[nodiscard]] HullA hull_a(const auto&) const { return {{}, {Vec3<N>{N(0.0), N(0.0), N(0.0)}}}; }
  [[nodiscard]] HullB hull_b(const auto& when) const { return {{}, {when(ways[0]), when(ways[1]), when(ways[2])}}; }

  Linear<N> apart;
  std::array<Linear<N>, 3> ways;
};

}  // namespace plumb::query::moving
