// The order of axes of two boxes, four at once; which is the least is a guess that is proved.
#include "query/penetration/near_axes.hpp"

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/penetration/near_axes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "query/penetration/many_vectors.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::parting::near_axes::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

using namespace many_vectors::HWY_NAMESPACE;  // NOLINT: all of it is of this text

/// The same number stands in all lanes.
struct BoxNumbers {
  std::array<Space<Many>, 6> axis;
  std::array<Twofolds, 6> length;
  Space<Twofolds> middle;
};
HWY_INLINE Twofolds length_of(const GivenBox::Ends& e) { return Twofolds::difference(of_all(e.to), of_all(e.from)); }
HWY_INLINE BoxNumbers numbers_of(const GivenBox& a, const GivenBox& b) {
  const auto middle = [&](std::size_t k) HWY_ATTR { return length_of(a.middle[k]) - length_of(b.middle[k]); };
  return {{all_of(a.axes[0]), all_of(a.axes[1]), all_of(a.axes[2]), all_of(b.axes[0]), all_of(b.axes[1]),
           all_of(b.axes[2])},
          {length_of(a.length[0]), length_of(a.length[1]), length_of(a.length[2]), length_of(b.length[0]),
           length_of(b.length[1]), length_of(b.length[2])},
          {middle(0), middle(1), middle(2)}};
}
/// Times both weights.
HWY_INLINE BoxNumbers numbers_of(const PosedBox& a, const PosedBox& b) {
  const Many of_a = of_all(a.weight), of_b = of_all(b.weight);
  const auto turned = [&](const PosedBox& p, const Many& beside) HWY_ATTR {
    const Twofolds x = length_of(p.local[0]), y = length_of(p.local[1]), z = length_of(p.local[2]);
    const auto row = [&](double u, double v, double t)
                         HWY_ATTR { return ((x * of_all(u) + y * of_all(v)) + z * of_all(t)) * beside; };
    const auto& [u, v, t] = p.columns;
    return Space<Twofolds>{row(u.x, v.x, t.x), row(u.y, v.y, t.y), row(u.z, v.z, t.z)};
  };
  const Space<Twofolds> first = turned(a, of_b), second = turned(b, of_a);
  const auto way = [&](double to, double from) HWY_ATTR {
    const Twofolds x = length_of({from, to});
    return (x + x) * of_a * of_b;
  };
  const auto length = [&](const PosedBox& p, std::size_t k, const Many& beside)
                          HWY_ATTR { return length_of(p.length[k]) * beside; };
  return {{all_of(a.axes[0]), all_of(a.axes[1]), all_of(a.axes[2]), all_of(b.axes[0]), all_of(b.axes[1]),
           all_of(b.axes[2])},
          {length(a, 0, of_b), length(a, 1, of_b), length(a, 2, of_b), length(b, 0, of_a), length(b, 1, of_a),
           length(b, 2, of_a)},
          {way(a.at.x, b.at.x) + (first.x - second.x), way(a.at.y, b.at.y) + (first.y - second.y),
           way(a.at.z, b.at.z) + (first.z - second.z)}};
}

HWY_INLINE Twofolds magnitude_of_each(const Twofolds& x) {
  const Truth is_below = above(of_all(0), x.high + x.low);
  return {chosen(is_below, Twofolds::negated(x.high), x.high), chosen(is_below, Twofolds::negated(x.low), x.low),
          x.magnitude, x.error, x.width};
}
/// Lane by lane, a bit each.
struct SignBits {
  unsigned positive, negative;
  [[nodiscard]] Sign operator[](std::size_t lane) const {
    return static_cast<Sign>(static_cast<int>(positive >> lane & 1) - static_cast<int>(negative >> lane & 1));
  }
};
HWY_INLINE SignBits signs_of_each(const Twofolds& x) {
  const Many most = x.reach() * of_all(1 + Twofolds::slack), sum = x.high + x.low;
  return {bits_of(above(sum, most)), bits_of(above(Twofolds::negated(most), sum))};
}

struct Axes4 {
  Twofolds square, middle, overlap;
  std::array<SignBits, 6> along;
};
/// Of what an axis is at right angles to, nothing leads along it: that may be added as well.
HWY_INLINE Axes4 along_normals(const BoxNumbers& g, const Space<Many>& u, const Space<Many>& v) {
  const Space<Twofolds> n = cross_of(u, v);
  const std::array<Twofolds, 6> lead{dot_of(n, g.axis[0]), dot_of(n, g.axis[1]), dot_of(n, g.axis[2]),
                                     dot_of(n, g.axis[3]), dot_of(n, g.axis[4]), dot_of(n, g.axis[5])};
  const auto reach = [&](std::size_t k) HWY_ATTR { return magnitude_of_each(lead[k]) * g.length[k]; };
  const Twofolds middle = dot_of(n, g.middle);
  const Twofolds all = ((reach(0) + reach(1)) + (reach(2) + reach(3))) + (reach(4) + reach(5));
  return {dot_of(n, n),
          middle,
          all - magnitude_of_each(middle),
          {signs_of_each(lead[0]), signs_of_each(lead[1]), signs_of_each(lead[2]), signs_of_each(lead[3]),
           signs_of_each(lead[4]), signs_of_each(lead[5])}};
}

template <class Box>
HWY_INLINE Space<Many> axes_at(const Box& a, const Box& b, const std::array<std::uint32_t, 4>& k) {
  Four x, y, z;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const Vector3& v = (k[lane] < 3 ? a : b).axes[k[lane] % 3];
    x[lane] = v.x, y[lane] = v.y, z[lane] = v.z;
  }
  return {loaded_four(x), loaded_four(y), loaded_four(z)};
}

HWY_INLINE One lane_of(const Twofolds& x, std::size_t lane) {
  Four high, low, magnitude;
  store(x.high, high), store(x.low, low), store(x.magnitude, magnitude);
  return {high[lane], low[lane], magnitude[lane], x.error, x.width};
}
/// How far they overlap less than one axis, over their lengths: a guess.
HWY_INLINE std::uint32_t guessed_least(std::span<const Axes4> all, std::size_t size) {
  const One square = first_of(all[0].square), overlap = first_of(all[0].overlap.squared());
  std::uint32_t least = 0;
  double most = 0;
  for (std::size_t k = 0; k < all.size() && size > 1; ++k) {
    const Twofolds less = of_all(overlap) * all[k].square - all[k].overlap.squared() * of_all(square);
    Four by, of;
    store(less.high, by), store(all[k].square.high, of);
    for (std::size_t lane = 0; lane < 4 && 4 * k + lane < size; ++lane) {
      if (by[lane] > most * of[lane]) most = by[lane] / of[lane], least = static_cast<std::uint32_t>(4 * k + lane);
    }
  }
  return least;
}

template <class Box>
[[maybe_unused]] NearAxisSigns signs(const Box& a, const Box& b, std::span<const NearAxes::Pair> pairs) {
  const BoxNumbers g = numbers_of(a, b);
  std::array<Axes4, 4> fours;
  const auto all = std::span(fours).first((pairs.size() + 3) / 4);
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::array<std::uint32_t, 4> p{}, q{};
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const NearAxes::Pair& of = pairs[4 * k + lane < pairs.size() ? 4 * k + lane : 0];
      p[lane] = of[0], q[lane] = of[1];
    }
    all[k] = along_normals(g, axes_at(a, b, p), axes_at(a, b, q));
  }
  NearAxisSigns told;
  told.least = guessed_least(all, pairs.size());
  const Axes4& least = all[told.least / 4];
  const std::size_t at = told.least % 4;
  told.overlap = signs_of_each(least.overlap)[at], told.middle = signs_of_each(least.middle)[at];
  for (std::size_t k = 0; k < 6; ++k) told.along[k] = least.along[k][at];
  if (pairs.size() == 1) return told;
  const Twofolds square = of_all(lane_of(least.square, at)), overlap = of_all(lane_of(least.overlap.squared(), at));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const SignBits sides = signs_of_each(all[k].overlap),
                   order = signs_of_each(all[k].overlap.squared() * square - overlap * all[k].square);
    for (std::size_t lane = 0; lane < 4 && 4 * k + lane < pairs.size(); ++lane) {
      const Sign side = sides[lane];
      const bool are_known = side != Sign::zero && told.overlap != Sign::zero;
      told.order[4 * k + lane] = !are_known ? Sign::zero : side != told.overlap ? side : side * order[lane];
    }
  }
  return told;
}

#else

template <class Box>
[[maybe_unused]] NearAxisSigns signs(const Box&, const Box&, std::span<const NearAxes::Pair>) {
  return {};
}

#endif

}  // namespace
}  // namespace plumb::query::parting::near_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query::parting {

NearAxisSigns near_axis_signs(const GivenBox& a, const GivenBox& b, std::span<const NearAxes::Pair> pairs) {
  return PLUMB_BY_LANES(near_axes, signs(a, b, pairs));
}
NearAxisSigns near_axis_signs(const PosedBox& a, const PosedBox& b, std::span<const NearAxes::Pair> pairs) {
  return PLUMB_BY_LANES(near_axes, signs(a, b, pairs));
}

}  // namespace plumb::query::parting
#endif
