#include "surface/planar/insertion_order.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "space/bvh/radix_sort.hpp"

namespace plumb::surface {
namespace {

struct Placed {
  std::array<double, 2> at;
  std::uint32_t index;
};

using Place = std::vector<Placed>::iterator;
constexpr std::ptrdiff_t few = 4;  // whose order hardly matters

Place halve(Place from, Place to, std::size_t axis, bool up) {
  const Place middle = from + (to - from) / 2;
  if (up) {
    std::nth_element(from, middle, to, [axis](const Placed& l, const Placed& r) { return l.at[axis] < r.at[axis]; });
  } else {
    std::nth_element(from, middle, to, [axis](const Placed& l, const Placed& r) { return l.at[axis] > r.at[axis]; });
  }
  return middle;
}

void along_curve(Place from, Place to, std::size_t axis, bool up, bool other_up) {
  if (to - from <= few) return;
  const Place second = halve(from, to, axis, up);
  const Place first = halve(from, second, 1 - axis, other_up), third = halve(second, to, 1 - axis, !other_up);
  along_curve(from, first, 1 - axis, other_up, up);
  along_curve(first, second, axis, up, other_up);
  along_curve(second, third, axis, up, other_up);
  along_curve(third, to, 1 - axis, !other_up, !up);
}

/// Squares along a Hilbert curve, 2^16 on a side, from the least coordinates of some points to the greatest.
class Squares {
 public:
  explicit Squares(std::span<const Placed> points) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [least, most] = std::minmax_element(
          points.begin(), points.end(), [k](const Placed& l, const Placed& r) { return l.at[k] < r.at[k]; });
      least_[k] = least->at[k];
      const double scale = last / (most->at[k] - least_[k]);
      scale_[k] = scale < most_scale ? scale : 0;
    }
  }

  [[nodiscard]] std::uint32_t along_curve(const Placed& p) const {
    const std::uint32_t x = step(p, 0), y = step(p, 1);
    std::uint32_t along = 0, turned = 0, swapped = 0;
    for (int bit = 15; bit >= 0; --bit) {
      const std::uint32_t u = (x >> bit ^ turned) & 1, v = (y >> bit ^ turned) & 1, other = (u ^ v) & swapped;
      const std::uint32_t right = u ^ other, up = v ^ other;
      along = along << 2 | ((3 * right) ^ up);
      turned ^= right & ~up;
      swapped ^= ~up & 1;
    }
    return along;
  }

 private:
  static constexpr double last = 0xffff, most_scale = 0x1p1000;
  [[nodiscard]] std::uint32_t step(const Placed& p, std::size_t axis) const {
    const double at = (p.at[axis] - least_[axis]) * scale_[axis];
    return at <= last ? static_cast<std::uint32_t>(at) : 0;
  }
  std::array<double, 2> least_{}, scale_{};
};

/// A curve through squares of one size, which few points share unless they are in clusters: those are halved at medians.
void along_curve(Place from, Place to) {
  constexpr std::ptrdiff_t many = 256;  // worth a sort of another kind
  if (to - from < many) return along_curve(from, to, 0, false, false);
  const std::span<const Placed> points(from, to);
  const Squares squares(points);
  std::vector<std::uint64_t> keys(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = std::uint64_t{squares.along_curve(points[i])} << 32 | i;
  space::radix_sort_upper(Execution::serial, keys);
  std::vector<Placed> sorted;
  sorted.reserve(keys.size());
  std::size_t first = 0;
  for (std::size_t i = 0; i <= keys.size(); ++i) {
    if (i == keys.size() || keys[i] >> 32 != keys[first] >> 32) {
      along_curve(sorted.begin() + static_cast<std::ptrdiff_t>(first), sorted.end(), 0, false, false);
      first = i;
    }
    if (i < keys.size()) sorted.push_back(points[static_cast<std::uint32_t>(keys[i])]);
  }
  std::copy(sorted.begin(), sorted.end(), from);
}

}  // namespace

int rounds_before_last(std::uint32_t index) {
  std::uint64_t x = index + 0x9e3779b97f4a7c15U;  // splitmix64
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return std::countr_zero(x ^ (x >> 31)) / 3;  // a coin of eight sides
}

std::vector<std::uint32_t> insertion_order(std::span<const Point2> at) {
  std::vector<std::uint32_t> round_sizes;
  std::vector<Placed> placed(at.size());
  const auto round_of = [&](std::uint32_t i) {
    const auto r = static_cast<std::size_t>(rounds_before_last(i));
    if (r >= round_sizes.size()) round_sizes.resize(r + 1);
    return r;
  };
  const auto n = static_cast<std::uint32_t>(at.size());
  for (std::uint32_t i = 0; i < n; ++i) ++round_sizes[round_of(i)];
  std::vector<std::uint32_t> ends(round_sizes.size());
  std::uint32_t end = 0;
  for (std::size_t r = round_sizes.size(); r-- > 0;) {
    ends[r] = end;
    end += round_sizes[r];
  }
  for (std::uint32_t i = 0; i < n; ++i) placed[ends[round_of(i)]++] = {{at[i].x, at[i].y}, i};
  for (std::size_t r = 0; r < ends.size(); ++r) {
    const auto to = placed.begin() + ends[r];
    along_curve(to - round_sizes[r], to);
  }
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t i = 0; i < n; ++i) order[i] = placed[i].index;
  return order;
}

}  // namespace plumb::surface
