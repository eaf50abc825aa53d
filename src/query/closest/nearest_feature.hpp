// Which feature of a triangle, or of an oriented box, is nearest to a point?  Stated once, over any world whose
// numbers have an axis a lane (certify/three_axes.hpp, certify/exact_axes.hpp).
//
// Included once for each target by files that Highway compiles for several.
// Laws: what is told is so; where a sign that matters is zero the question is left open, in every world.
// Source: RTCD 5.1.5, 5.1.4.
// Cost: that of the world.
#if defined(PLUMB_NEAREST_FEATURE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_NEAREST_FEATURE
#undef PLUMB_NEAREST_FEATURE
#else
#define PLUMB_NEAREST_FEATURE
#endif

#include "certify/three_axes.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::nearest_feature::HWY_NAMESPACE {

using certify::three_lanes::HWY_NAMESPACE::crossed;

/// The dot products of a vector with those that were transposed.
template <class C, class V>
HWY_INLINE auto dots(const C& columns, const V& v) {
  return plus_product(plus_product(columns.x * spread<0>(v), columns.y, spread<1>(v)), columns.z, spread<2>(v));
}

/// With d along ab and e along ac of the ways from a, b, c to p: a is nearest where p is behind it along both, an
/// edge where p is between its ends and on its outer side, d_i e_k - d_k e_i, the face where p is on all inner sides.
struct OfTriangle {
  static constexpr int highest = 4;
  static constexpr Scales scales{};

  template <class W>
  HWY_INLINE Feature operator()(W& w, const Triangle3& t, const Point3& p) const {
    const auto a = w.given(t.a), at = w.given(p);
    const auto ab = w.difference(w.given(t.b), a), ac = w.difference(w.given(t.c), a);
    const auto ways = transposed(w.difference(at, a), w.difference(at, w.given(t.b)), w.difference(at, w.given(t.c)));
    const auto d = dots(ways, ab), e = dots(ways, ac);
    const auto turn = e - d;  // that along bc
    const unsigned behind_b = bits(w.negative(d)), behind_c = bits(w.negative(e)), past_b = bits(w.positive(d)),
                   past_c = bits(w.positive(e)), to_b = bits(w.negative(turn)), to_c = bits(w.positive(turn));
    constexpr unsigned of_a = 1, of_b = 2, of_c = 4;
    if ((behind_b & behind_c & of_a) != 0) return {FeatureKind::vertex, 0};
    if ((past_b & to_b & of_b) != 0) return {FeatureKind::vertex, 1};
    if ((past_c & to_c & of_c) != 0) return {FeatureKind::vertex, 2};
    const auto side = minus_product(d * turned(e), turned(d), e);  // of ab, bc, ca
    const unsigned outer = bits(w.negative(side));
    if ((outer & 1) != 0 && (past_b & of_a) != 0 && (behind_b & of_b) != 0) return {FeatureKind::edge, 0};
    if ((outer & 2) != 0 && (to_c & of_b) != 0 && (to_b & of_c) != 0) return {FeatureKind::edge, 1};
    if ((outer & 4) != 0 && (past_c & of_a) != 0 && (behind_c & of_c) != 0) return {FeatureKind::edge, 2};
    if (!w.is_all(w.positive(side))) w.leave_open();
    return {FeatureKind::face, 0};
  }
};

/// Is the point nearest that was guessed?  `count` axes are free there, between their ends: none, the first, all but
/// the first, or all; `ends` are where along the others it is, and the half extents of the free ones; bit i of
/// `upper`: end i is above zero.
template <int count>
struct OfBox {
  static constexpr int highest = 4;
  static constexpr Scales scales{.count = 2, .weights = 0b10};

  template <class W>
  HWY_INLINE bool operator()(W& w, const Point3& p, const Point3& center, const std::array<const Vector3*, 3>& axes,
                             const auto& ends, unsigned upper) const {
    const auto way = w.difference(w.given(p), w.given(center));
    const auto u = w.template number<1>(w.given(*axes[0])), v = w.template number<1>(w.given(*axes[1])),
               n = w.template number<1>(w.given(*axes[2]));
    const auto at = w.template weight<1>(w.given(ends));
    const auto columns = transposed(u, v, n);
    const auto along = dots(columns, way);
    const auto is_beyond = [&](const auto& x, unsigned lanes) HWY_ATTR {
      const unsigned above = bits(w.positive(x)), below = bits(w.negative(x));
      return (((upper & above) | (~upper & below)) & lanes) == lanes;
    };
    const auto is_within = [&](const auto& x, const auto& most, unsigned lanes) HWY_ATTR {
      return (bits(w.positive(most - x)) & bits(w.positive(most + x)) & lanes) == lanes;
    };
    bool is_so = true;
    if constexpr (count == 0) {
      const auto left = ((along - spread<0>(at) * dots(columns, u)) - spread<1>(at) * dots(columns, v)) -
                        spread<2>(at) * dots(columns, n);
      is_so = is_beyond(left, 0b111);
    } else if constexpr (count == 1) {
      const auto of_u = dots(columns, u);
      const auto left = (along - spread<1>(at) * dots(columns, v)) - spread<2>(at) * dots(columns, n);
      is_so = is_within(left, at * of_u, 0b001) && is_beyond(spread<0>(of_u) * left - of_u * spread<0>(left), 0b110);
    } else if constexpr (count == 2) {
      const auto left = along - spread<0>(at) * dots(columns, u);
      const auto squares = columns.x * columns.x + columns.y * columns.y + columns.z * columns.z;
      const auto both = spread<2>(dots(columns, v));
      const auto whole = spread<1>(squares) * spread<2>(squares) - both * both;
      const auto first = turned(squares) * left - both * turned(left);             // of v
      const auto second = turned_back(squares) * left - both * turned_back(left);  // of n
      const auto normal = crossed(v, turned(v), n, turned(n));
      const auto volume = total(normal * turned_back(u));
      const auto height = total(normal * turned_back(way)) - spread<0>(at) * volume;
      const bool is_left = w.is_all(w.negative(volume));
      is_so = is_within(first, at * whole, 0b010) && is_within(second, at * whole, 0b100) &&
              (is_left || w.is_all(w.positive(volume))) &&
              w.is_all(((upper & 1) != 0) != is_left ? w.positive(height) : w.negative(height));
    } else {
      const auto at_u = turned(u), at_v = turned(v), at_n = turned(n);
      const auto normal = crossed(v, at_v, n, at_n);
      const auto normals = transposed(normal, crossed(n, at_n, u, at_u), crossed(u, at_u, v, at_v));
      const auto heights =
          plus_product(plus_product(normals.x * spread<2>(way), normals.y, spread<0>(way)), normals.z, spread<1>(way));
      is_so = is_within(heights, at * magnitude(total(normal * turned_back(u))), 0b111);
    }
    if (!is_so) w.leave_open();
    return is_so;
  }
};

}  // namespace plumb::query::nearest_feature::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
