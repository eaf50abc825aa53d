// Which sides of two boxes face each other, and on which side of each edge of the one is each corner of the other, seen along
// the normal?  A statement over any world of numbers.
//
// Along w, of the axes u, v, w of a box, a side has the normal u x v; of the sides that hold what is farthest out the one
// faces the other box whose normal makes the least angle with the direction d that leads out: (n . d)^2 / n . n is the
// greatest.  An edge along u has (d x u) . (q - p) > 0 on the inner side; on a parallelogram with the middle m the opposite
// edges tell |d . n| times the other edge, plus and minus (d x u) . (q - m).  Lengths are doubled throughout.
// Laws: nothing is told where the guess is not the side that faces the other box, or where another may be as well.
// Source: RTCD 4.4; Gregorius 2015.
// Cost: some 300 operations.
#pragma once

#include <span>

#include "query/penetration/box_axes.hpp"

namespace plumb::query::touching {

/// What faces another box: this side, or the one across where it is not `upper`; `forth`: its first edge leads along axis
/// + 1, then the second along axis + 2, as seen from where the direction leads; else one after the other from the end.
struct FacingSide {
  std::uint32_t axis = 0;
  bool upper = false, forth = true;
  friend bool operator==(const FacingSide&, const FacingSide&) = default;
};

/// Leads from the middle of a side of the first box to that of one of the second.
template <class W, class Axes, class Lengths>
auto way_between(W& w, const std::array<GivenBox, 2>& box, const Axes& axes, const Lengths& length,
                 const std::array<FacingSide, 2>& side) {
  const auto one = w.template number<1>(1);
  const auto center_of = [&](std::size_t i) {
    const FacingSide& s = side[i];
    const auto up = axes[i][s.axis];
    const auto& l = length[i][s.axis];
    const auto along = [&](std::size_t k, const auto& x) {
      const auto middle = w.difference(box[i].middle[k].to, box[i].middle[k].from);
      return s.upper ? middle * one + l * x : middle * one - l * x;
    };
    return vec_of(along(0, up.x), along(1, up.y), along(2, up.z));
  };
  const auto p = center_of(0), q = center_of(1);
  return vec_of(q.x - p.x, q.y - p.y, q.z - p.z);
}
template <class W, class Axes, class Lengths>
auto way_between(W& w, const std::array<PosedBox, 2>& box, const Axes& axes, const Lengths& length,
                 const std::array<FacingSide, 2>& side) {
  const auto way = middle_difference(w, box[1], box[0]);
  const auto &p = axes[0][side[0].axis], &q = axes[1][side[1].axis];
  const auto &of_p = length[0][side[0].axis], &of_q = length[1][side[1].axis];
  const auto part = [&](const auto& x, const auto& u, const auto& v) {
    const auto to = side[1].upper ? x + of_q * v : x - of_q * v;
    return side[0].upper ? to - of_p * u : to + of_p * u;
  };
  return vec_of(part(way.x, p.x, q.x), part(way.y, p.y, q.y), part(way.z, p.z, q.z));
}

template <class Box>
struct FacingSidesOf {
  static constexpr Scales scales{.count = 2, .maxima = 3};  // lengths; axes
  static constexpr int highest = 12;

  /// By bits: along which axes a box leads nowhere out, and on which side of the others it is farthest out.
  struct Level {
    std::uint32_t first, free;
  };
  struct Told {
    bool is_told = true;
    std::array<FacingSide, 2> side;
    std::array<std::array<Sign, 16>, 2> sign{};  // of edge i and the other's corner j: 4 i + j
    friend bool operator==(const Told&, const Told&) = default;
  };

  /// The direction from the first box to the second is u x v.  `guess(alongs, squares)`: of the three sides by n . d and
  /// n . n the one that faces the other box; it may be any.
  template <class W, class Guess>
  Told operator()(W& w, const std::array<Box, 2>& box, const std::array<Level, 2>& level, const Vector3& u,
                  const Vector3& v, const Guess& guess) const {
    const auto numbers = [&](const Vector3& x) {
      return vec_of(w.template number<1>(x.x), w.template number<1>(x.y), w.template number<1>(x.z));
    };
    const auto out = tracked_cross(numbers(u), numbers(v));
    const auto of_box = [&](std::size_t i, auto f) { return std::array{f(box[i], 0), f(box[i], 1), f(box[i], 2)}; };
    const auto axes_of = [&](const Box& b, std::size_t k) { return numbers(b.axes[k]); };
    const auto length_of = [&](const Box& b, std::size_t k) {
      return length_beside(w, b.length[k], box[&b == box.data() ? 1 : 0]);
    };
    const std::array axes{of_box(0, axes_of), of_box(1, axes_of)};
    const std::array length{of_box(0, length_of), of_box(1, length_of)};

    Told told;
    const auto width_of = [&](std::size_t i) {
      const auto& g = axes[i];
      const std::array normal{tracked_cross(g[1], g[2]), tracked_cross(g[2], g[0]), tracked_cross(g[0], g[1])};
      const std::array along{tracked_dot(normal[0], out), tracked_dot(normal[1], out), tracked_dot(normal[2], out)};
      const auto square_of = [](const auto& n) { return tracked_dot(n, n); };
      const std::array square{square_of(normal[0]), square_of(normal[1]), square_of(normal[2])};
      const std::uint32_t k = guess(i, along, square);
      const bool upper = (level[i].first >> k & 1) != 0;
      const Sign side = i == 0 ? w.sign(along[k]) : -w.sign(along[k]), turn = w.sign(tracked_dot(normal[k], g[k]));
      bool is_it = (level[i].free >> k & 1) == 0 && side * turn == (upper ? Sign::positive : Sign::negative);
      for (std::uint32_t j = 0; j < 3; ++j) {
        if (j == k || (level[i].free >> j & 1) != 0) continue;  // what is level leads off that side
        const Sign order = w.compare(along[k] * along[k] * square[j], along[j] * along[j] * square[k]);
        is_it = is_it && order == Sign::positive;
      }
      told.is_told = told.is_told && is_it;
      told.side[i] = {k, upper, side == Sign::positive};
      return magnitude(along[k]);
    };
    const std::array width{width_of(0), width_of(1)};
    if (!told.is_told || !w.certain()) return told;

    const auto between = way_between(w, box, axes, length, told.side);
    for (std::size_t i = 0; i < 2; ++i) {
      const FacingSide &s = told.side[i], &t = told.side[1 - i];
      const std::size_t of_t[2] = {(t.axis + 1) % 3, (t.axis + 2) % 3};
      for (std::size_t edge = 0; edge < 2; ++edge) {
        const std::size_t k = (s.axis + 1 + edge) % 3, across = (s.axis + 2 - edge) % 3;
        const auto inward = tracked_cross(out, axes[i][k]);
        const auto at_middle = tracked_dot(inward, between);
        const auto first = tracked_dot(inward, axes[1 - i][of_t[0]]) * length[1 - i][of_t[0]],
                   second = tracked_dot(inward, axes[1 - i][of_t[1]]) * length[1 - i][of_t[1]];
        const auto reach = width[i] * length[i][across];
        const std::size_t here = edge == 0 ? 0 : s.forth ? 1 : 3, opposite = edge == 0 ? 2 : s.forth ? 3 : 1;
        for (std::size_t j = 0; j < 4; ++j) {
          const std::size_t corner = t.forth ? j : 3 - j;
          // The second box sees the direction out and the way between the middles lead back: both cancel out.
          const bool is_first = (corner == 1 || corner == 2) == (i == 0), is_second = (corner > 1) == (i == 0);
          const auto to_first = is_first ? at_middle + first : at_middle - first;
          const auto lead = is_second ? to_first + second : to_first - second;
          told.sign[i][4 * here + j] = w.sign(reach + lead);
          told.sign[i][4 * opposite + j] = w.sign(reach - lead);
        }
      }
    }
    return told;
  }
};
using FacingSides = FacingSidesOf<GivenBox>;

}  // namespace plumb::query::touching
