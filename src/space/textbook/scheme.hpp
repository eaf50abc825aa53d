// What is asked of a scheme that keeps boxes: where is a box, and which may overlap one?
//
// A scheme has a Place for each box (cells, a level, a code) and
//   Scheme(asked, options)                throws where the options are none
//   place_of(box)                         boxes of equal places are kept in the same cells
//   make_room(asked, handle, place)       so that put need not throw
//   put(handle, place), take(handle, place); move(handle, place) where that is less than both
//   give_up(place)                        once nothing may be there any more; where the scheme has it
//   visit_near(box, once, stored, visit)  visit(handle) of all that may meet the box, once unless that is not asked for
//   parts(), memory()
// and for all pairs either pairs(options, stored), or level_of(place) and row_of(box, place, level) for
// level_join.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/space/textbook/box_store.hpp"
#include "space/grid/grid_boxes.hpp"
#include "space/textbook/box_slots.hpp"

namespace plumb::space {

inline constexpr std::uint32_t no_handle = ~std::uint32_t{0};

/// Of a table of 2^k lists; and at which a cell is.
inline constexpr std::size_t least_places = 64;

template <std::size_t n>
std::uint64_t hash_of(const CellNumber<n>& cell) {
  constexpr std::uint64_t odd[3] = {0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u};
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < n; ++k) hash += static_cast<std::uint32_t>(cell[k]) * odd[k];
  return hash ^ hash >> 32;  // the upper bits depend on all
}

template <class Box, class Place>
struct StoredBoxes {
  BoxSlots<Box> boxes;
  std::vector<Place> places;  // of each handle
};

/// The function that was called, named where something is wrong.
struct AskedFunction {
  std::string_view index, verb;

  [[nodiscard]] std::string text() const { return std::string(index) + (verb.empty() ? "" : "::") + std::string(verb); }
  void require_memory(double bytes, std::size_t most, const char* mend = "choose larger cells") const {
    if (bytes > static_cast<double>(most)) space::require_memory(text(), bytes, most, mend);
  }
};

}  // namespace plumb::space
