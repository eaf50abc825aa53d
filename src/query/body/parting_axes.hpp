// Separating axis test (SAT): are two boxes under poses apart along one of their fifteen axes, or do they overlap along
// all of them?  A statement over any world of numbers.
//
// Along n = u x v, of two of the six axes, the boxes reach sum s |n . w| over the other four, s the lengths; c is the
// way between their middles, everything times two and both weights: the gap is |n . c| less that.
// Laws: nothing is told of boxes without an inside, where a gap is zero, or about zero in a world that does not know.
// Source: RTCD 4.4.1; Gottschalk, Lin and Manocha 1996.
// Cost: some 60 operations an axis, up to the first along which they are apart.
#pragma once

#include <array>
#include <optional>

#include "plumb/certify/certainly.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "query/body/box_parts.hpp"

namespace plumb::query {

struct PartingAxes {
  static constexpr Scales scales{.count = 2, .maxima = 3};  // lengths; axes and weights
  static constexpr int highest = 6;

  /// Faces come first: along their normals most boxes that are apart are so.
  static constexpr std::array<std::array<std::size_t, 2>, 15> pairs{{{1, 2},
                                                                     {2, 0},
                                                                     {0, 1},
                                                                     {4, 5},
                                                                     {5, 3},
                                                                     {3, 4},
                                                                     {0, 3},
                                                                     {0, 4},
                                                                     {0, 5},
                                                                     {1, 3},
                                                                     {1, 4},
                                                                     {1, 5},
                                                                     {2, 3},
                                                                     {2, 4},
                                                                     {2, 5}}};

  /// Those of two edges that are parallel, by bits.
  static std::uint32_t parallel(const PosedBox& a, const PosedBox& b) {
    std::uint32_t all = 0;
    for (std::uint32_t i = 6; i < pairs.size(); ++i) {
      if (are_parallel(a.axes[pairs[i][0]], b.axes[pairs[i][1] - 3])) all |= 1U << i;
    }
    return all;
  }

  /// `left_out`: pairs of axes that are parallel, by bits.
  template <class W>
  std::optional<Relation> operator()(W& w, const PosedBox& a, const PosedBox& b, std::uint32_t left_out) const {
    const auto axis = [&](std::size_t k) {
      const Vector3& v = (k < 3 ? a : b).axes[k % 3];
      return vec_of(w.template number<1>(v.x), w.template number<1>(v.y), w.template number<1>(v.z));
    };
    const std::array g{axis(0), axis(1), axis(2), axis(3), axis(4), axis(5)};
    const auto length = [&](std::size_t k) {
      return k < 3 ? length_beside(w, a.length[k], b) : length_beside(w, b.length[k - 3], a);
    };
    const std::array s{length(0), length(1), length(2), length(3), length(4), length(5)};
    for (const auto& of : s) {
      if (!is_positive(w, of)) return {};
    }
    const auto c = middle_difference(w, a, b);
    bool is_open = false;
    for (std::size_t of = 0; of < pairs.size(); ++of) {
      if ((left_out >> of & 1) != 0) continue;
      const auto [i, j] = pairs[of];
      const auto n = tracked_cross(g[i], g[j]);
      const auto reach = [&](std::size_t k) { return magnitude(tracked_dot(n, g[k])) * s[k]; };
      const auto& other = axes_beside[6 * i + j];
      const auto gap =
          magnitude(tracked_dot(n, c)) - ((reach(other[0]) + reach(other[1])) + (reach(other[2]) + reach(other[3])));
      if (is_positive(w, gap)) return Relation::disjoint;
      is_open = is_open || !w.negative(gap);
    }
    for (const std::size_t k : {0U, 3U}) {
      if (is_open || !is_positive(w, magnitude(tracked_dot(tracked_cross(g[k], g[k + 1]), g[k + 2])))) return {};
    }
    return Relation::overlapping;
  }

 private:
  template <class W, class T>
  static bool is_positive(W& w, const T& x) {
    if constexpr (requires { w.positive(x); }) {
      return w.positive(x);
    } else {
      return w.sign(x) == Sign::positive;
    }
  }
};

}  // namespace plumb::query
