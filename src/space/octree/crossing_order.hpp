// Which border does a ray cross first, and is it in a cell at all?  A cell is where the ray is between its borders:
// behind the last that it crosses inward, before the first that it crosses outward.
//
// Laws: those of cell_walk.hpp.
// Source: RTCD 5.3.3, 7.4.1.
// Cost: a comparison of doubles for borders of one axis; a product each where axes differ and doubles tell.
#pragma once

#include <algorithm>
#include <optional>

#include "plumb/space/octree/cell_walk.hpp"
#include "space/octree/crossing_sign.hpp"

namespace plumb::space {

inline constexpr std::uint8_t at_beginning = 8, at_end = 9;

template <std::size_t D>
class CrossingsOf {
 public:
  using Crossing = CellCrossing;
  /// What is crossed inward last and outward first.
  struct Passage {
    Crossing entry, exit;
  };

  CrossingsOf(const CellWay<D>& way, WalkedCells walk) : way_(way), half_open_(walk == WalkedCells::half_open) {}

  /// Negative where a is crossed before b.
  [[nodiscard]] int order(const Crossing& a, const Crossing& b) const {
    if (a.axis >= D || b.axis >= D) return rank(a) - rank(b);
    if (a.axis == b.axis) {
      const int by_border = (a.border > b.border) - (a.border < b.border);
      return way_.side[a.axis] * by_border;
    }
    const Sign s = crossing_order(way_.ends, a.border, way_.from[a.axis], way_.to[a.axis], b.border, way_.from[b.axis],
                                  way_.to[b.axis]);
    return static_cast<int>(s) * way_.side[a.axis] * way_.side[b.axis];
  }
  /// Of what is entered: what is without the place is entered behind it.
  [[nodiscard]] int entry_order(const Crossing& a, const Crossing& b) const {
    const int by_place = order(a, b);
    return by_place != 0 ? by_place : static_cast<int>(a.open) - static_cast<int>(b.open);
  }

  /// Through a cell with these borders; none where it has no place of the way.
  [[nodiscard]] std::optional<Passage> passage(const std::array<double, D>& low,
                                               const std::array<double, D>& high) const {
    Passage p{{at_beginning, false, 0}, {at_end, false, 0}};
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double from = way_.from[axis];
      if (way_.side[axis] == 0) {
        if (from < low[axis] || from > high[axis] || (half_open_ && from == high[axis])) return std::nullopt;
        continue;
      }
      const bool up = way_.side[axis] > 0;
      const Crossing in = crossing(axis, up ? low[axis] : high[axis], half_open_ && !up),
                     out = crossing(axis, up ? high[axis] : low[axis], half_open_ && up);
      if (is_before_beginning(axis, out.border) || is_behind_end(axis, in.border)) return std::nullopt;
      if (!is_before_beginning(axis, in.border) && entry_order(p.entry, in) < 0) p.entry = in;
      if (!is_behind_end(axis, out.border) && exit_order(out, p.exit) < 0) p.exit = out;
    }
    const int between = order(p.entry, p.exit);
    if (between > 0 || (between == 0 && (p.entry.open || p.exit.open))) return std::nullopt;
    return p;
  }

 private:
  /// Told as the beginning or the end where it is there.
  [[nodiscard]] Crossing crossing(std::size_t axis, double border, bool open) const {
    if (border == way_.from[axis]) return {at_beginning, open, border};
    if (way_.ends && border == way_.to[axis]) return {at_end, open, border};
    return {static_cast<std::uint8_t>(axis), open, border};
  }
  [[nodiscard]] bool is_before_beginning(std::size_t axis, double border) const {
    return way_.side[axis] > 0 ? border < way_.from[axis] : border > way_.from[axis];
  }
  [[nodiscard]] bool is_behind_end(std::size_t axis, double border) const {
    if (!way_.ends) return border - border != 0 && !is_before_beginning(axis, border);
    return way_.side[axis] > 0 ? border > way_.to[axis] : border < way_.to[axis];
  }
  [[nodiscard]] int exit_order(const Crossing& a, const Crossing& b) const {
    const int by_place = order(a, b);
    return by_place != 0 ? by_place : static_cast<int>(b.open) - static_cast<int>(a.open);
  }
  static int rank(const Crossing& c) { return c.axis == at_beginning ? 0 : c.axis == at_end ? 2 : 1; }

  const CellWay<D>& way_;
  bool half_open_;
};

}  // namespace plumb::space
