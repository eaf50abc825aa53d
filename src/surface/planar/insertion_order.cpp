#include "surface/planar/insertion_order.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace plumb::surface {
namespace {

struct Placed {
  std::array<double, 2> at;
  std::uint32_t index;
};

using Place = std::vector<Placed>::iterator;

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
  constexpr std::ptrdiff_t few = 4;  // whose order hardly matters
  if (to - from <= few) return;
  const Place second = halve(from, to, axis, up);
  const Place first = halve(from, second, 1 - axis, other_up), third = halve(second, to, 1 - axis, !other_up);
  along_curve(from, first, 1 - axis, other_up, up);
  along_curve(first, second, axis, up, other_up);
  along_curve(second, third, axis, up, other_up);
  along_curve(third, to, 1 - axis, !other_up, !up);
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
    along_curve(to - round_sizes[r], to, 0, false, false);
  }
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t i = 0; i < n; ++i) order[i] = placed[i].index;
  return order;
}

}  // namespace plumb::surface
