// Separating axis test: along which of fifteen axes are two oriented boxes apart, or one and one with the axes of space?
// Stated once, over any world whose numbers have an axis a lane (certify/three_axes.hpp, certify/exact_axes.hpp).
//
// The matrix of a box's cofactors (its rows are the box's face normals n_i) maps it to an axis-aligned one, and another
// parallelepiped to one of its kind, and separating axes to separating axes.  There the fifteen axes cost nearly what
// they do for orthonormal ones, but no axes need be orthonormal: every gap is a polynomial's value times a square.
// Scales: what lies between the centers, and in it the half extents times the largest coordinate of their box's axes;
// the axes of a; those of b.
// Included once for each target by files that Highway compiles for several.
// Laws: the relation is that of the closed sets, as far as the world tells it: doubles leave open where a gap is about
// zero, so all parallel edges; a first box whose axes lie in a plane gets its answer where a gap is above zero.
//
// That the axes of a are independent is enough, whatever the half extents.  Made longer by any amount a has an inside,
// and the facets of the boxes' difference have normals among the fifteen axes.  So boxes that are apart are so along
// one of them for lengths as near to those given as one likes, and of finitely many axes along one for the lengths
// themselves.  Likewise, where the difference holds the origin in its boundary, and the center not there, an origin
// moved out a little is outside along one axis: the gap there is zero, and the center's part is not.  Where both are
// zero all of it lies in that plane, and nothing is told (Gaps::heed_from).
// Source: RTCD 4.4.1, table 4.1.
// Cost: that of the world.
#if defined(PLUMB_FIFTEEN_AXES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_FIFTEEN_AXES
#undef PLUMB_FIFTEEN_AXES
#else
#define PLUMB_FIFTEEN_AXES
#endif

#include "certify/three_axes.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::fifteen_axes::HWY_NAMESPACE {

using certify::three_lanes::HWY_NAMESPACE::crossed, certify::three_lanes::HWY_NAMESPACE::parallel;

/// The sum of columns' parts along a vector, lane by lane: the dot products of the vectors that were transposed.
template <class C, class X>
HWY_INLINE auto along(const C& c, const X& x, const X& y, const X& z) {
  return plus_product(plus_product(c.x * x, c.y, y), c.z, z);
}
/// Of the columns of a matrix those of its cofactors: lane i is the cross product of rows i + 1 and i + 2.
template <class T>
struct CofactorsOf {
  T x, y, z;
};
template <class C>
HWY_INLINE auto cofactors(const C& c) {
  const auto x = turned(c.x), y = turned(c.y), z = turned(c.z);
  return CofactorsOf<decltype(turned(crossed(c.y, y, c.z, z)))>{
      turned(crossed(c.y, y, c.z, z)), turned(crossed(c.z, z, c.x, x)), turned(crossed(c.x, x, c.y, y))};
}
template <class C>
HWY_INLINE auto sums(const C& c) {
  return c.x + c.y + c.z;
}

/// In the frame of a: the way between the centers, a's half extents, b's axes one by one, b's half extents; which edges of
/// a an edge of b is parallel to, where that is known; and what is positive if a's axes are independent.
template <class W, class Gaps, class T, class H, class R, class K, class P, class... I>
HWY_INLINE Relation along_all(W& w, Gaps& gaps, const T& t, const H& h, const R& r, const K& k, const P& are_parallel,
                              const I&... independent) {
  const std::array k_of{spread<0>(k), spread<1>(k), spread<2>(k)};
  const std::array size_r{magnitude(r[0]), magnitude(r[1]), magnitude(r[2])};
  const auto beyond_a = magnitude(t) - h;
  const auto gap_a =
      minus_product(minus_product(minus_product(beyond_a, k_of[0], size_r[0]), k_of[1], size_r[1]), k_of[2], size_r[2]);
  w.require(w.is_real(gap_a));  // all numbers are in it
  gaps.heed_from(gap_a, magnitude(t));
  if (gaps.is_apart()) return Relation::disjoint;
  if (w.is_all(w.negative(beyond_a))) return Relation::overlapping;  // the center of b is inside a

  // The cofactors c of r, in the order (z, x, y), which is that of cross products.
  const std::array r_turned{turned(r[0]), turned(r[1]), turned(r[2])};
  const std::array c{crossed(r[1], r_turned[1], r[2], r_turned[2]), crossed(r[2], r_turned[2], r[0], r_turned[0]),
                     crossed(r[0], r_turned[0], r[1], r_turned[1])};
  const std::array size_c{magnitude(c[0]), magnitude(c[1]), magnitude(c[2])};
  const auto t_turned = turned(t);
  const auto h_turned = turned(h);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const auto of_a = plus_product(h * magnitude(r_turned[j]), h_turned, size_r[j]);
    const auto of_b = plus_product(k_of[j1] * size_c[j2], k_of[j2], size_c[j1]);
    const auto way = magnitude(crossed(t, t_turned, r[j], r_turned[j]));
    gaps.heed_from(way - (of_a + of_b), way, [&]() HWY_ATTR { return are_parallel(j); });
  }
  const auto determinant = magnitude(total(turned(r_turned[0]) * c[0]));
  const auto t_back = turned(t_turned);
  const auto h_back = turned(h_turned);
  const auto along_b = magnitude(sums(transposed(t_back * c[0], t_back * c[1], t_back * c[2])));
  const auto reach = sums(transposed(h_back * size_c[0], h_back * size_c[1], h_back * size_c[2]));
  gaps.heed_from(along_b - plus_product(reach, k, determinant), along_b);
  (gaps.need(w.positive(independent)), ...);
  return gaps.template relation<Relation>(independent...);
}

struct ObbPair {
  static constexpr int highest = 9;
  static constexpr Scales scales{.count = 3, .weights = 0b110, .maxima = 0b111};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Obb3& a, const Obb3& b) const {
    const std::array of_a{w.template number<1>(a.axes[0]), w.template number<1>(a.axes[1]),
                          w.template number<1>(a.axes[2])};
    const std::array of_b{w.template number<2>(b.axes[0]), w.template number<2>(b.axes[1]),
                          w.template number<2>(b.axes[2])};
    const auto d = w.difference(w.given(b.center), w.given(a.center));
    const auto half = magnitude(w.template weight<1>(w.given(a.half)));
    const auto k = magnitude(w.template weight<2>(w.given(b.half)));
    // Along the axes of space: what is far apart ends here.
    const auto reach = [](const auto& axes, const auto& h) HWY_ATTR {
      return plus_product(plus_product(magnitude(axes[0]) * spread<0>(h), magnitude(axes[1]), spread<1>(h)),
                          magnitude(axes[2]), spread<2>(h));
    };
    auto gaps = w.gaps();
    const auto gap = magnitude(d) - (reach(of_a, half) + reach(of_b, k));
    w.require(w.is_real(gap));
    gaps.heed_above(gap);
    if (gaps.is_apart()) return Relation::disjoint;

    const auto axes = transposed(of_a[0], of_a[1], of_a[2]);
    const auto normals = cofactors(axes);
    const auto volume = magnitude(along(normals, axes.x, axes.y, axes.z));  // three times, but for roundings
    const auto seen = [&](const auto& v) HWY_ATTR { return along(normals, spread<0>(v), spread<1>(v), spread<2>(v)); };
    const auto are_parallel = [&](std::size_t j) HWY_ATTR { return parallel<1, 2>(w, axes, of_b[j]); };
    return along_all(w, gaps, seen(d), half * volume, std::array{seen(of_b[0]), seen(of_b[1]), seen(of_b[2])}, k,
                     are_parallel, volume);
  }
};

/// Twice as far apart and twice as large, the box with the axes of space in the place of a.
struct BoxAndObb {
  static constexpr int highest = 3;
  static constexpr Scales scales{.count = 2, .weights = 0b10, .maxima = 0b11};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Aabb3& a, const Obb3& b) const {
    const auto min = w.given(a.min), max = w.given(a.max), center = w.given(b.center);
    const auto from_min = w.difference(center, min), from_max = w.difference(center, max);
    const auto widths = w.difference(max, min);
    const std::array of_b{w.template number<1>(b.axes[0]), w.template number<1>(b.axes[1]),
                          w.template number<1>(b.axes[2])};
    const auto k = twice(magnitude(w.template weight<1>(w.given(b.half))));
    auto gaps = w.gaps();
    const auto none_known = [](std::size_t) HWY_ATTR { return std::false_type(); };
    return along_all(w, gaps, from_min + from_max, widths, of_b, k, none_known);
  }
};

}  // namespace plumb::figure::fifteen_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
