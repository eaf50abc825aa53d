#include "space/sort_and_sweep/ordinal_map.hpp"

namespace plumb::space {

OrdinalMap::Piece::Piece(double from, double to, double last_step) : min(from), last(last_step) {
  constexpr double most = std::numeric_limits<double>::max();
  halved = to - from <= most ? 1 : 0.5;
  start = from * halved;
  const double length = to * halved - start;
  scale = length > 0 ? std::min(last / length, most) : 0;
}

OrdinalMap::OrdinalMap(const SetBounds& bounds, const std::array<std::size_t, 3>& order, const std::array<int, 3>& bits)
    : order_(order) {
  for (std::size_t k = 0; k < 3; ++k) {
    whole_[k] = Piece(bounds.min[order[k]], bounds.max[order[k]], std::ldexp(1.0, bits[k]) - 1);
    widening_[k] = bounds.min[order[k]] == bounds.max[order[k]] ? 1 : 0;
    for (const std::size_t i : {order[k], order[k] + 3}) {
      six_.halved[i] = whole_[k].halved, six_.start[i] = whole_[k].start;
      six_.scale[i] = whole_[k].scale, six_.last[i] = whole_[k].last;
    }
  }
}

OrdinalMap::OrdinalMap(const SetBounds& bounds, const std::array<std::size_t, 3>& order, const std::array<int, 3>& bits,
                       std::array<std::vector<double>, 3> knots)
    : OrdinalMap(bounds, order, bits) {
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double>& ends = knots[order[k]];
    ends.insert(ends.end(), {bounds.min[order[k]], bounds.max[order[k]]});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    if (ends.size() <= 2) continue;
    const std::int32_t steps = (std::int32_t{1} << bits[k]) / static_cast<std::int32_t>(ends.size());
    is_even_ = false;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      axes_[k].emplace_back(ends[i], ends[i + 1], steps - 1);
      axes_[k].back().first = static_cast<std::int32_t>(i) * steps;
    }
  }
}

}  // namespace plumb::space
