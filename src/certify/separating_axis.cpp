#include "plumb/certify/separating_axis.hpp"

#include <algorithm>

#include "plumb/predicates/cross_products.hpp"
#include "plumb/predicates/direction.hpp"

namespace plumb::certify::separating_axis {
namespace {

using predicates::BoxGap;

// Arguments of BoxGap by their first coordinate.
constexpr std::size_t center_a = 0, center_b = 3, u = 6, v = 9, first_reach = 12, reaches = 4;

bool is_zero_axis(const Input& p) {
  const auto cross_is_zero = [&p](std::size_t i, std::size_t j) {
    return decide<predicates::Cross2d>({p[u + i], p[u + j], p[v + i], p[v + j]}) == Sign::zero;
  };
  return cross_is_zero(1, 2) && cross_is_zero(2, 0) && cross_is_zero(0, 1);
}

// Sign of (to - from) . L.
Sign along_axis(const Input& p, const std::array<double, 3>& from, std::size_t to) {
  return decide<predicates::OrderAlongCross>(
      {p[u], p[u + 1], p[u + 2], p[v], p[v + 1], p[v + 2], from[0], from[1], from[2], p[to], p[to + 1], p[to + 2]});
}

}  // namespace

std::optional<Sign> decide_exactly(Input p) {
  if (!std::ranges::all_of(p, [](double x) { return x - x == 0; }))
    throw_non_finite(BoxGap::name, arguments<BoxGap>, p);
  if (is_zero_axis(p)) return std::nullopt;
  if (along_axis(p, {p[center_a], p[center_a + 1], p[center_a + 2]}, center_b) == Sign::negative) {
    std::swap_ranges(&p[center_a], &p[center_a] + 3, &p[center_b]);
  }
  for (std::size_t k = 0; k < reaches; ++k) {
    const std::size_t w = first_reach + 3 * k;
    if (along_axis(p, {0, 0, 0}, w) != Sign::negative) continue;
    for (std::size_t i = w; i < w + 3; ++i) p[i] = -p[i];
  }
  return decide<BoxGap>(p);
}

}  // namespace plumb::certify::separating_axis
