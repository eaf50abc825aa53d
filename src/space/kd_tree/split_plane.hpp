// Guess: which plane divides figures to advantage?  By the surface-area heuristic, over planes at the ends of some.
//
// Law: what it says changes the tree, and no answer.
// Source: RTCD 7.3.7; MacDonald and Booth 1990.
// Cost: two binary searches for each axis and figure, of 512 at the most, and two comparisons for each of many.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace plumb::space::kd {

template <std::size_t d>
struct SplitCell {
  std::array<double, d> low, high;
};

struct SplitPlane {
  double plane;
  std::uint8_t axis;
  std::size_t lower, upper;  // so many figures at the most
};

template <std::size_t d>
class PlaneChooser {
 public:
  /// Lengths of this cell, which holds all, are doubles once halved.
  explicit PlaneChooser(const SplitCell<d>& all) {
    for (std::size_t a = 0; a < d; ++a) {
      if (!std::isfinite(all.high[a] - all.low[a])) unit_ = 0.5;
    }
  }

  /// The cheapest, where it is cheaper than to ask all n; from(i, axis) and to(i, axis) are the ends of figure i.  Of many
  /// figures some are asked which plane that is.
  template <class From, class To>
  std::optional<SplitPlane> best(const SplitCell<d>& cell, std::size_t n, const From& from, const To& to) const {
    std::optional<SplitPlane> best;
    std::array<double, d> length;
    for (std::size_t a = 0; a < d; ++a) length[a] = length_of(cell.low[a], cell.high[a]);
    const double longest = *std::max_element(length.begin(), length.end());
    if (!(longest > 0)) return best;
    for (double& x : length) x /= longest;
    const double whole = area(length);
    const auto cost_of = [&](double plane, std::size_t a, std::size_t lower, std::size_t upper) {
      auto below = length, above = length;
      below[a] = length_of(cell.low[a], plane) / longest;
      above[a] = length_of(plane, cell.high[a]) / longest;
      return (area(below) * static_cast<double>(lower) + area(above) * static_cast<double>(upper)) / whole;
    };
    const std::size_t some = std::min(n, most_asked);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < d; ++a) {
      const Planes planes = candidates(cell, a, n, from, to);
      std::array<std::uint32_t, most_planes + 1> starts{}, ends{};
      for (std::size_t k = 0; k < some; ++k) {
        const std::size_t i = some == n ? k : k * n / some;
        ++starts[place(planes, from(i, a))];
        ++ends[place(planes, to(i, a))];
      }
      std::size_t lower = 0, upper = some;
      for (std::size_t k = 0; k < planes.count; ++k) {
        lower += starts[k];  // begin below this plane
        upper -= ends[k];    // all but those that end below it
        const double cost = cost_of(planes.at[k], a, lower, upper);
        if (cost < least) least = cost, best = SplitPlane{planes.at[k], static_cast<std::uint8_t>(a), lower, upper};
      }
    }
    if (!best) return best;
    if (some < n) {
      best->lower = best->upper = 0;
      for (std::size_t i = 0; i < n; ++i) {
        best->lower += from(i, best->axis) < best->plane ? 1 : 0;
        best->upper += to(i, best->axis) >= best->plane ? 1 : 0;
      }
      least = cost_of(best->plane, best->axis, best->lower, best->upper);
    }
    // A plane costs as much as a figure.
    return least < static_cast<double>(n) - 1 ? best : std::nullopt;
  }

 private:
  [[nodiscard]] double length_of(double low, double high) const { return high * unit_ - low * unit_; }
  /// Flat cells have one as well.
  static double area(const std::array<double, d>& length) {
    constexpr double least = 0x1p-10;  // a guess like the rest: of the longest side
    const auto at = [&](std::size_t a) { return std::max(length[a], least); };
    if constexpr (d == 2) {
      return at(0) + at(1);
    } else {
      return at(0) * at(1) + at(1) * at(2) + at(2) * at(0);
    }
  }
  static constexpr std::size_t most_asked = 512, most_ends = 24, most_planes = 63;
  /// Ascending; behind the last ones infinity.
  struct Planes {
    std::array<double, most_planes> at;
    std::size_t count = 0;
  };
  /// How many planes are at most x.  No branch depends on it.
  static std::size_t place(const Planes& planes, double x) {
    std::size_t k = 0;
    for (std::size_t step = (most_planes + 1) / 2; step != 0; step /= 2) k += planes.at[k + step - 1] <= x ? step : 0;
    return k;
  }
  /// Where some begin, and right behind where they end, so that they are in one half.
  template <class From, class To>
  static Planes candidates(const SplitCell<d>& cell, std::size_t a, std::size_t n, const From& from, const To& to) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    static_assert(2 * most_ends <= most_planes);
    Planes planes;
    planes.at.fill(infinite);
    const std::size_t count = std::min(n, most_ends);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = (2 * k + 1) * n / (2 * count);
      for (const double x : {from(i, a), std::nextafter(to(i, a), infinite)}) {
        if (cell.low[a] < x && x <= cell.high[a]) planes.at[planes.count++] = x;
      }
    }
    const auto first = planes.at.begin(), last = first + static_cast<std::ptrdiff_t>(planes.count);
    std::sort(first, last);
    planes.count = static_cast<std::size_t>(std::unique(first, last) - first);
    std::fill(first + static_cast<std::ptrdiff_t>(planes.count), last, infinite);
    return planes;
  }

  double unit_ = 1;
};

}  // namespace plumb::space::kd
