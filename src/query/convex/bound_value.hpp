// Clipping: how large is a bound's value at a vertex, and how fast does it grow along an edge?  In the numbers of a
// computation.
//
// Laws: value is what value_sign tells the sign of; slope is its derivative.  What no doubles hold (Given, exact
// vertices) is for BigDyadic alone: whoever computes in other numbers leaves such sets to it.
// Cost: up to 25 operations.
#pragma once

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "query/convex/set.hpp"

namespace plumb::query::meeting {

template <class T>
T minus(double x, double y) {
  return coordinate_difference<T>(x, y);
}
template <class T>
T minus(const T& x, double y) {
  return x - T(y);
}
template <class T, std::size_t N>
const T& part(const Vec<T, N>& p, std::size_t axis) {
  return p[axis];
}

template <class T>
T det2(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}
template <class T>
T det3(const Vec<T, 3>& a, const Vec<T, 3>& b, const Vec<T, 3>& c) {
  return a[0] * det2(b[1], b[2], c[1], c[2]) - a[1] * det2(b[0], b[2], c[0], c[2]) +
         a[2] * det2(b[0], b[1], c[0], c[1]);
}
template <class T>
Vec<T, 3> from_to(const Point3& a, const Point3& b) {
  return {minus<T>(b.x, a.x), minus<T>(b.y, a.y), minus<T>(b.z, a.z)};
}
template <class T>
Vec<T, 2> from_to(const Point2& a, const Point2& b) {
  return {minus<T>(b.x, a.x), minus<T>(b.y, a.y)};
}
template <class T, std::size_t N>
Vec<T, N> made(const Point<N>& p) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return Vec<T, N>{T(part(p, I))...}; }
  (std::make_index_sequence<N>{});
}
template <class T, std::size_t N>
Vec<T, N> made(const Vector<N>& p) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return Vec<T, N>{T(part(p, I))...}; }
  (std::make_index_sequence<N>{});
}

/// At a point as given, or (Position is Vec) at any.
template <class T, std::size_t N, class Position>
T value(const Bound<N>& b, const Position& p) {
  using Kind = typename Bound<N>::Kind;
  const auto [right, up] = b.look();
  const auto from = [&](const Point<N>& a, std::size_t axis) {
    return T(0.0) - minus<T>(part(p, axis), part(a, axis));
  };
  switch (b.kind) {
    case Kind::axis:
      return minus<T>(part(p, b.axis), b.offset);
    case Kind::line:
      return det2(from(b.a, right), from(b.a, up), from(b.b, right), from(b.b, up));
    case Kind::toward:
      return T(part(b.direction, up)) * from(b.a, right) - T(part(b.direction, right)) * from(b.a, up);
    case Kind::face:
      if constexpr (N == 3) {
        const auto row = [&](const Point3& a) { return Vec<T, 3>{from(a, 0), from(a, 1), from(a, 2)}; };
        return det3(row(b.a), row(b.b), row(b.c));
      }
      [[fallthrough]];
    case Kind::normal: {
      T sum = T(part(b.direction, 0)) * T(part(p, 0)) - T(b.offset);
      for (std::size_t axis = 1; axis < N; ++axis) sum = sum + T(part(b.direction, axis)) * T(part(p, axis));
      return sum;
    }
    default:
      if constexpr (std::is_same_v<T, BigDyadic>) {
        T sum = T(0.0) - b.given->offset;
        for (std::size_t axis = 0; axis < N; ++axis) sum = sum + b.given->gradient[axis] * T(part(p, axis));
        return sum;
      }
      return T(0.0);
  }
}

template <class T, std::size_t N>
T slope(const Bound<N>& b, const Vec<T, N>& along) {
  using Kind = typename Bound<N>::Kind;
  const auto [right, up] = b.look();
  switch (b.kind) {
    case Kind::axis:
      return along[b.axis];
    case Kind::line: {
      const Vec<T, N> d = from_to<T>(b.a, b.b);
      return det2(d[right], d[up], along[right], along[up]);
    }
    case Kind::toward:
      return det2(T(part(b.direction, right)), T(part(b.direction, up)), along[right], along[up]);
    case Kind::face:
      if constexpr (N == 3) return T(0.0) - det3(from_to<T>(b.a, b.b), from_to<T>(b.a, b.c), along);
      [[fallthrough]];
    case Kind::normal: {
      T sum = T(part(b.direction, 0)) * along[0];
      for (std::size_t axis = 1; axis < N; ++axis) sum = sum + T(part(b.direction, axis)) * along[axis];
      return sum;
    }
    default:
      if constexpr (std::is_same_v<T, BigDyadic>) {
        T sum = b.given->gradient[0] * along[0];
        for (std::size_t axis = 1; axis < N; ++axis) sum = sum + b.given->gradient[axis] * along[axis];
        return sum;
      }
      return T(0.0);
  }
}

template <class T, std::size_t N>
T vertex_value(const ConvexSet<N>& set, int vertex, const Bound<N>& b) {
  const auto v = static_cast<std::size_t>(vertex);
  if constexpr (std::is_same_v<T, BigDyadic>) {
    if (set.is_exact()) return value<T, N>(b, set.exact_vertices[v]);
  }
  return value<T, N>(b, set.vertices[v]);
}

template <std::size_t N>
Sign vertex_sign(const ConvexSet<N>& set, std::size_t v, const Bound<N>& b) {
  return set.is_exact() ? value<BigDyadic, N>(b, set.exact_vertices[v]).sign() : value_sign(b, set.vertices[v]);
}

}  // namespace plumb::query::meeting
