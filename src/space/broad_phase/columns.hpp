// Boxes in columns: each stands in every column of a grid that it reaches.
//
// Laws: (1) where two boxes overlap, they have exactly one column in common in which no mark says of both that they
// began before it: that of the later starts.  (2) The order within a column is that of the
// boxes that were divided.
// Source: RTCD 7.1.6, 7.1.7.
// Cost: three passes over the boxes.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "space/sort_and_sweep/ordinal_box.hpp"

namespace plumb::space {

struct Columns {
  std::unique_ptr<OrdinalBox[]> boxes;
  std::vector<std::uint32_t> begin;  // of each column, and the end of the last

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const OrdinalBox> operator[](std::size_t column) const {
    return {boxes.get() + begin[column], begin[column + 1] - begin[column]};
  }
};

/// The strip of an ordinal, of this many.
constexpr std::uint32_t strip_of(std::int32_t ordinal, std::uint32_t strips) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(static_cast<std::uint32_t>(ordinal)) * strips) >>
                                    ordinal_bits);
}

/// In how many columns boxes stand, all together, at the most: a guess of what pays.
constexpr std::size_t most_copies_of(std::size_t boxes) { return 4 * boxes + 4096; }

/// Where more copies than those were needed, of half as many strips, which are told.
Columns divide_into_columns(Execution execution, std::span<const OrdinalBox> boxes,
                            std::array<std::uint32_t, 2>& strips);

}  // namespace plumb::space
