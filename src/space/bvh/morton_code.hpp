// Which items are near each other?  Codes of 32 bits, of which each halves the longest side that is left of a cell.
//
// Laws: items in one half of a cell differ from those in the other in the bit of that halving, and in none before it.
// Source: Morton 1966; Lauterbach et al. 2009; bits by the longest side: Vinkler, Bittner and Havran 2017.
// Cost: six lookups a code; 3 x 2 tables of 256 entries.
#pragma once

#include <array>

#include "space/bvh/boxed_item.hpp"

namespace plumb::space {

class MortonCoder {
 public:
  /// For middles that lie here.
  explicit MortonCoder(const Extent& middles) : base_(middles.low) {
    const Lanes range = middles.high - middles.low;
    Lanes side = range;
    std::array<std::array<int, most_bits>, 3> place{};  // in the code, of each axis's bits from its highest on
    std::array<std::size_t, 3> bits{};
    for (int at = 31; at >= 0; --at) {
      std::size_t axis = 3;
      for (std::size_t k = 0; k < 3; ++k) {
        if (bits[k] < most_bits && (axis == 3 || side[k] > side[axis])) axis = k;
      }
      place[axis][bits[axis]++] = at;
      side[axis] /= 2;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      constexpr float below_count = 0.99999F;  // so that rounding never reaches the number of cells
      if (range[axis] > flat_spread) scale_[axis] = below_count * static_cast<float>(1 << bits[axis]) / range[axis];
      for (std::size_t b = 0; b < bits[axis]; ++b) {
        const std::size_t from_lowest = bits[axis] - 1 - b;
        for (std::size_t v = 0; v < 256; ++v) {
          if ((v >> from_lowest % 8 & 1) != 0) table_[axis][from_lowest / 8][v] |= std::uint32_t{1} << place[axis][b];
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t code(Lanes twice_middle) const {
    const IntLanes cell = __builtin_convertvector((twice_middle - base_) * scale_, IntLanes);
    std::uint32_t code = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto c = static_cast<std::uint32_t>(cell[axis]);
      code |= table_[axis][0][c & 255u] | table_[axis][1][c >> 8 & 255u];
    }
    return code;
  }

 private:
  static constexpr std::size_t most_bits = 16;  // of one axis
  Lanes base_, scale_ = {};
  std::array<std::array<std::array<std::uint32_t, 256>, 2>, 3> table_{};
};

}  // namespace plumb::space
