// Guess: which plane divides figures to advantage?  By the surface-area heuristic, over planes at the ends of some.
//
// Law: what it says changes the tree, and no answer.
// Source: RTCD 7.3.7; MacDonald and Booth 1990.
// Cost: two binary searches for each axis and figure.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

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

  /// The cheapest, where it is cheaper than to ask all n; from(i, axis) and to(i, axis) are the ends of figure i.
  template <class From, class To>
  std::optional<SplitPlane> best(const SplitCell<d>& cell, std::size_t n, const From& from, const To& to) const {
    std::optional<SplitPlane> best;
    double least = static_cast<double>(n) - 1;  // a plane costs as much as a figure
    std::array<double, d> length;
    for (std::size_t a = 0; a < d; ++a) length[a] = length_of(cell.low[a], cell.high[a]);
    const double longest = *std::max_element(length.begin(), length.end());
    if (!(longest > 0)) return best;
    for (double& x : length) x /= longest;
    const double whole = area(length);
    for (std::size_t a = 0; a < d; ++a) {
      const std::vector<double> planes = candidates(cell, a, n, from, to);
      std::vector<std::size_t> starts(planes.size() + 1, 0), ends(planes.size() + 1, 0);
      for (std::size_t i = 0; i < n; ++i) {
        ++starts[place(planes, from(i, a))];
        ++ends[place(planes, to(i, a))];
      }
      std::size_t lower = 0, upper = n;
      for (std::size_t k = 0; k < planes.size(); ++k) {
        lower += starts[k];  // begin below this plane
        upper -= ends[k];    // all but those that end below it
        auto below = length, above = length;
        below[a] = length_of(cell.low[a], planes[k]) / longest;
        above[a] = length_of(planes[k], cell.high[a]) / longest;
        const double cost =
            (area(below) * static_cast<double>(lower) + area(above) * static_cast<double>(upper)) / whole;
        if (cost < least) least = cost, best = SplitPlane{planes[k], static_cast<std::uint8_t>(a), lower, upper};
      }
    }
    return best;
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
  /// How many planes are at most x.
  static std::size_t place(const std::vector<double>& planes, double x) {
    return static_cast<std::size_t>(std::upper_bound(planes.begin(), planes.end(), x) - planes.begin());
  }
  /// Where some begin, and right behind where they end, so that they are in one half.
  template <class From, class To>
  static std::vector<double> candidates(const SplitCell<d>& cell, std::size_t a, std::size_t n, const From& from,
                                        const To& to) {
    constexpr std::size_t most = 24;
    std::vector<double> planes;
    const std::size_t count = std::min(n, most);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = (2 * k + 1) * n / (2 * count);
      for (const double x : {from(i, a), std::nextafter(to(i, a), std::numeric_limits<double>::infinity())}) {
        if (cell.low[a] < x && x <= cell.high[a]) planes.push_back(x);
      }
    }
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    return planes;
  }

  double unit_ = 1;
};

}  // namespace plumb::space::kd
