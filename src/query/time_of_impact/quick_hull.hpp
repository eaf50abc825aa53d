// Support mapping: what do points, segments, triangles and boxes need to be asked along a direction?  A place, and ways
// from it.
//
// A woven shape is its place plus any part of each of its ways: from none to all of them, or of boxes with a center as
// much back as forth.  A triangle has its first vertex for a place.
// Laws: over any number type, and the same over all; vertices of woven shapes are numbered by bits, 1 at the upper end
// of a way.
// Source: RTCD 4.4.1, 5.2.1, 5.2.9.
// Cost: a dot product for each way.
#pragma once

#include <array>
#include <cmath>

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query::quick {

inline Approximate opposite(const Approximate& a) { return {-a.value, a.magnitude, a.error}; }

/// Products of vectors whose numbers are of different types.
template <class A, class B>
[[gnu::always_inline]] inline auto inner(const Vec3<A>& a, const Vec3<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
[[gnu::always_inline]] inline auto outer(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.x * b.y - a.y * b.x)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A point of a hull: parts of its ways, or weights of its vertices.
using Parts = std::array<double, 3>;

/// The least and the most.
template <class L, class H>
struct Reaches {
  L low;
  H high;
};
template <class L, class H>
Reaches(L, H) -> Reaches<L, H>;

template <class T, std::size_t Ways, bool centered>
struct Woven {
  static constexpr std::size_t way_count = Ways, face_count = Ways == 3 ? 3 : 0, dimension = Ways;
  static constexpr bool is_triangle = false;

  Point3 place;
  std::array<Vec3<T>, Ways == 0 ? 1 : Ways> ways;

  /// Its vectors made into others.
  [[gnu::always_inline]] inline auto made(const auto& vector) const {
    using Other = Woven<decltype(vector(ways[0]).x), Ways, centered>;
    if constexpr (Ways == 3) {
      return Other{place, {vector(ways[0]), vector(ways[1]), vector(ways[2])}};
    } else {
      static_assert(Ways < 2);
      return Other{place, {vector(ways[0])}};
    }
  }
  [[nodiscard]] const Vec3<T>& way(std::size_t i) const { return ways[i]; }
  [[nodiscard]] Vec3<T> whole_way(std::size_t i) const { return centered ? ways[i] + ways[i] : ways[i]; }
  /// The ways that face number i lies along.
  static constexpr std::array<std::size_t, 2> of_face(std::size_t i) { return {(i + 1) % 3, (i + 2) % 3}; }

  /// How far the hull reaches along n from its place, of a woven shape that has ways.
  template <class N>
  [[gnu::always_inline]] inline auto along(const Vec3<N>& n) const {
    const auto of_way = [&](std::size_t i) { return inner(n, ways[i]); };
    const auto all = [&](const auto& part) {
      if constexpr (Ways == 3) {
        return part(of_way(0)) + part(of_way(1)) + part(of_way(2));
      } else {
        static_assert(Ways == 1);
        return part(of_way(0));
      }
    };
    using At = decltype(of_way(0));
    if constexpr (centered) {
      const auto high = all([](const At& at) { return magnitude(at); });
      return Reaches{negated(high), high};
    } else {
      return Reaches{all([](const At& at) { return smaller(at, At{0.0}); }),
                     all([](const At& at) { return larger(at, At{0.0}); })};
    }
  }
  /// The vertex that is farthest along n; is that certain?  Ways of the mask are normal to n, and end at 0.
  [[nodiscard]] std::pair<unsigned, bool> farthest(const Vec3<Approximate>& n, unsigned normal) const {
    unsigned bits = 0;
    bool sure = true;
    for (unsigned i = 0; i < Ways; ++i) {
      if ((normal >> i & 1) != 0) continue;
      const T at = dot(n, ways[i]);
      bits |= at.value > 0 ? 1U << i : 0;
      sure &= certain_sign(at) != 0;
    }
    return {bits, sure};
  }
  /// Of a vertex, from the place.
  [[nodiscard]] Vec3<T> at(unsigned bits) const {
    Vec3<T> p{T(0.0), T(0.0), T(0.0)};
    for (std::size_t i = 0; i < Ways; ++i) {
      if ((bits >> i & 1) != 0) {
        p = p + ways[i];
      } else if (centered) {
        p = p - ways[i];
      }
    }
    return p;
  }
  /// Way i from a vertex at its lower end.
  static constexpr unsigned upper(unsigned bits, std::size_t i) { return bits | 1U << i; }
  /// A point by its parts of the ways, and where they begin.
  static constexpr double least = centered ? -1 : 0;
  static constexpr Parts middle() { return centered ? Parts{0, 0, 0} : Parts{0.5, 0.5, 0.5}; }
  [[nodiscard]] Vec3<T> at(const Parts& parts) const {
    Vec3<T> p{T(0.0), T(0.0), T(0.0)};
    for (std::size_t i = 0; i < Ways; ++i) p = p + ways[i] * T(parts[i]);
    return p;
  }
  [[nodiscard]] Vec3<T> middle_point() const {
    if constexpr (centered) return {T(0.0), T(0.0), T(0.0)};
    return at(middle());
  }
  /// How far may the point go along a way, back and forth?
  static constexpr std::array<double, 2> room(const Parts& parts, std::size_t i) {
    return {least - parts[i], 1 - parts[i]};
  }
  static constexpr void go(Parts& parts, std::size_t i, double by) {
    parts[i] += by;
    if (parts[i] < least) parts[i] = least;
    if (parts[i] > 1) parts[i] = 1;
  }

  static Feature vertex(unsigned bits) { return {FeatureKind::vertex, bits}; }
  static Feature edge(std::size_t i, unsigned bits) {
    if constexpr (Ways == 1) return {FeatureKind::edge, 0};
    const unsigned u = i == 0 ? 1 : 0, v = i == 2 ? 1 : 2;
    return {FeatureKind::edge, static_cast<std::uint32_t>(4 * i) + (bits >> u & 1) + 2 * (bits >> v & 1)};
  }
  static Feature face(std::size_t i, unsigned bits) {
    return {FeatureKind::face, static_cast<std::uint32_t>(2 * i) + (bits >> i & 1)};
  }
};

/// Vertices are numbered as the triangle's; way i is its edge i.
template <class T>
struct ThreeCorners {
  static constexpr std::size_t way_count = 3, face_count = 1, dimension = 2;
  static constexpr bool is_triangle = true;

  Point3 place;
  std::array<Vec3<T>, 3> ways;  // ab, bc, ca

  [[gnu::always_inline]] inline auto made(const auto& vector) const {
    return ThreeCorners<decltype(vector(ways[0]).x)>{place, {vector(ways[0]), vector(ways[1]), vector(ways[2])}};
  }
  [[nodiscard]] const Vec3<T>& way(std::size_t i) const { return ways[i]; }
  [[nodiscard]] const Vec3<T>& whole_way(std::size_t i) const { return ways[i]; }
  static constexpr std::array<std::size_t, 2> of_face(std::size_t) { return {0, 1}; }

  template <class N>
  [[gnu::always_inline]] inline auto along(const Vec3<N>& n) const {
    const auto ab = inner(n, ways[0]), ac = negated(inner(n, ways[2]));
    using At = std::remove_cvref_t<decltype(ab)>;
    return Reaches{smaller(smaller(ab, ac), At{0.0}), larger(larger(ab, ac), At{0.0})};
  }
  [[nodiscard]] std::pair<unsigned, bool> farthest(const Vec3<Approximate>& n, unsigned normal) const {
    if (normal == 7) return {0, true};
    const T ab = dot(n, ways[0]), bc = dot(n, ways[1]), ca = dot(n, ways[2]);
    // An edge that is normal to n has to be farther than the third vertex.
    for (unsigned i = 0; i < 3; ++i) {
      if (normal != 1U << i) continue;
      const T& from_third = i == 0 ? ca : i == 1 ? ab : bc;  // to the start of the edge, from the vertex before it
      return {i, certain_sign(from_third) > 0};
    }
    const double b = ab.value, c = -ca.value;
    const unsigned far = b > 0 ? (c > b ? 2 : 1) : c > 0 ? 2 : 0;
    const std::array<const T*, 3> edges{&ab, &bc, &ca};
    return {far, certain_sign(*edges[(far + 2) % 3]) > 0 && certain_sign(*edges[far]) < 0};
  }
  [[nodiscard]] Vec3<T> at(unsigned vertex) const {
    if (vertex == 1) return ways[0];
    const T none(0.0);
    return vertex == 0 ? Vec3<T>{none, none, none} : Vec3<T>{none, none, none} - ways[2];
  }
  static constexpr unsigned upper(unsigned, std::size_t i) { return static_cast<unsigned>(i + 1) % 3; }
  /// A point by the weights of the vertices.
  static constexpr Parts middle() { return {0.25, 0.375, 0.375}; }
  [[nodiscard]] Vec3<T> at(const Parts& parts) const {
    if constexpr (std::is_same_v<T, double>) {  // a guess
      return ways[0] * parts[1] - ways[2] * parts[2];
    } else {
      // Weights are off by their roundings.  These two add up to no more than 1: the rest of a double of at most 1 is
      // rounded to a multiple of half an ulp of 1, so that the rest of the rest is exact.
      const double rest = parts[1] < 1 ? 1 - parts[1] : 0, second = parts[2] < rest ? parts[2] : rest;
      return ways[0] * T(1 - rest) - ways[2] * T(second);
    }
  }
  [[nodiscard]] Vec3<T> middle_point() const { return at(middle()); }
  static constexpr std::array<double, 2> room(const Parts& parts, std::size_t i) {
    return {-parts[(i + 1) % 3], parts[i]};
  }
  static constexpr void go(Parts& parts, std::size_t i, double by) {
    const std::size_t j = (i + 1) % 3;
    parts[j] += by, parts[i] -= by;
    if (parts[i] <= 0) parts[j] += parts[i], parts[i] = 0;
    if (parts[j] <= 0) parts[i] += parts[j], parts[j] = 0;
  }
  static Feature vertex(unsigned i) { return {FeatureKind::vertex, i}; }
  static Feature edge(std::size_t i, unsigned) { return {FeatureKind::edge, static_cast<std::uint32_t>(i)}; }
  static Feature face(std::size_t, unsigned) { return {FeatureKind::face, 0}; }
};

inline double reach_of(const auto& shape) {
  if constexpr (requires { shape.radius; }) {
    return shape.radius;
  } else {
    return 0;
  }
}

/// Goes along way number i to where the difference of points becomes least; the hull's point counts with this sign.
template <class Hull>
void come_nearer(const Hull& hull, Parts& parts, std::size_t i, double sign, Vec3<double>& difference) {
  const Vec3<double>& way = hull.way(i);
  const double length = dot(way, way);
  if (!(length > 0)) return;
  const auto [back, forth] = Hull::room(parts, i);
  double by = -sign * dot(difference, way) / length;
  by = by < back ? back : by > forth ? forth : by;
  Hull::go(parts, i, by);
  difference = difference + way * (sign * by);
}

template <class T>
[[gnu::always_inline]] inline Woven<T, 0, false> hull_of(const Point3& p) {
  const T none(0.0);
  return {p, {Vec3<T>{none, none, none}}};  // never asked for
}
template <class T>
[[gnu::always_inline]] inline Woven<T, 0, false> hull_of(const Sphere3& s) {
  return hull_of<T>(s.center);
}
template <class T>
[[gnu::always_inline]] inline Woven<T, 1, false> hull_of(const Capsule3& c) {
  return {c.a, {between<T>(c.a, c.b)}};
}
template <class T>
[[gnu::always_inline]] inline Woven<T, 1, false> hull_of(const Segment3& s) {
  return {s.a, {between<T>(s.a, s.b)}};
}
template <class T>
[[gnu::always_inline]] inline Woven<T, 3, false> hull_of(const Aabb3& b) {
  const Vec3<T> d = between<T>(b.min, b.max);
  const T none(0.0);
  return {b.min, {Vec3<T>{d.x, none, none}, Vec3<T>{none, d.y, none}, Vec3<T>{none, none, d.z}}};
}
template <class T>
[[gnu::always_inline]] inline Woven<T, 3, true> hull_of(const Obb3& b) {
  return {b.center,
          {vector_of<T>(b.axes[0]) * T(std::fabs(b.half.x)), vector_of<T>(b.axes[1]) * T(std::fabs(b.half.y)),
           vector_of<T>(b.axes[2]) * T(std::fabs(b.half.z))}};
}
template <class T>
[[gnu::always_inline]] inline ThreeCorners<T> hull_of(const Triangle3& t) {
  return {t.a, {between<T>(t.a, t.b), between<T>(t.b, t.c), between<T>(t.c, t.a)}};
}

}  // namespace plumb::query::quick
