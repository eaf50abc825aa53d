// What the grids ask of boxes: are they sound, do two overlap, and which cell tells of a pair?
#pragma once

#include <array>
#include <charconv>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/grid/detail/cell_span.hpp"

namespace plumb::space {

/// What one task looks through.
inline constexpr std::size_t boxes_in_part = 1024;

/// Finite and not empty?
template <class Box>
bool is_sound_box(const Box& box) {
  const auto min = coordinates(box.min), max = coordinates(box.max);
  constexpr double most = std::numeric_limits<double>::max();
  bool sound = true;  // a NaN fails every comparison
  for (std::size_t a = 0; a < min.size(); ++a) sound &= -most <= min[a] && min[a] <= max[a] && max[a] <= most;
  return sound;
}
/// Of a box that is asked: is it not empty?  Throws NonFinite, naming the function.
template <class Box>
bool may_hold(std::string_view function, const Box& box, std::string_view name = "box") {
  if (is_sound_box(box)) [[likely]]
    return true;
  const std::string low = std::string(name) + ".min", high = std::string(name) + ".max";
  figure::require_finite_parts<decltype(box.min), decltype(box.max)>(function, {low, high}, box.min, box.max);
  return false;
}
/// Throws NonFinite and InvalidShape, naming the function and the box.
template <class Box>
void require_grid_box(std::string_view function, std::string_view name, const Box& box) {
  if (may_hold(function, box, name)) return;
  throw InvalidShape(std::string(function) + ": " + std::string(name) + " is empty; leave it out");
}
template <class Box>
void require_grid_boxes(const std::string& function, std::span<const Box> boxes) {
  bool sound = boxes.size() < std::numeric_limits<std::uint32_t>::max();
  for (const Box& box : boxes) sound &= is_sound_box(box);
  if (sound) return;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    require_grid_box(function, "boxes[" + std::to_string(i) + "]", boxes[i]);
  }
  throw InvalidShape(function + ": " + std::to_string(boxes.size()) + " boxes are more than 32 bits number");
}

/// Of sound boxes: no sum need be looked at for what is not finite.
template <class Box>
[[gnu::always_inline]] inline bool have_common(const Box& a, const Box& b) {
  const auto [first, second] = figure::box::common(a, b);
  const auto in = (first.starts <= first.ends) & (second.starts <= second.ends);
  return (in[0] & in[1]) != 0;
}
template <class Box>
[[gnu::always_inline]] inline bool is_pair(const Box& a, const Box& b, bool touching) {
  return have_common(a, b) && (touching || relate(a, b) == Relation::overlapping);
}

/// Of all cells that two boxes share, the lowest tells of the pair: so each is told once.
template <std::size_t n>
bool is_lowest_cell(const CellNumber<n>& cell, const CellNumber<n>& first_of_a, const CellNumber<n>& first_of_b) {
  bool is = true;
  for (std::size_t k = 0; k < n; ++k) is &= cell[k] == (first_of_a[k] > first_of_b[k] ? first_of_a[k] : first_of_b[k]);
  return is;
}

/// How many cells; infinite where nobody counts them.
template <std::size_t n>
double cell_count(const CellSpan<n>& span) {
  double count = 1;
  for (std::size_t k = 0; k < n; ++k) count *= static_cast<double>(span.last[k]) - span.first[k] + 1;
  return count;
}

/// Calls visit(cell) for each cell of the span, the first axis fastest.
template <std::size_t n, class Visit>
void for_cells(const CellSpan<n>& span, const Visit& visit) {
  CellNumber<n> cell = span.first;
  for (std::size_t a = 0; a < n;) {
    visit(cell);
    for (a = 0; a < n && cell[a] == span.last[a]; ++a) cell[a] = span.first[a];
    if (a < n) ++cell[a];
  }
}

template <std::size_t n>
bool holds_cell(const CellSpan<n>& span, const CellNumber<n>& cell) {
  bool in = true;
  for (std::size_t k = 0; k < n; ++k) in &= span.first[k] <= cell[k] && cell[k] <= span.last[k];
  return in;
}

/// Numbers a cell of the span, the first axis fastest.
template <std::size_t n>
std::size_t index_in(const CellSpan<n>& span, const CellNumber<n>& cell) {
  std::size_t index = 0;
  for (std::size_t k = n; k-- > 0;) {
    index = index * static_cast<std::size_t>(span.last[k] - span.first[k] + 1) +
            static_cast<std::size_t>(cell[k] - span.first[k]);
  }
  return index;
}

/// The reciprocal of a cell size, which must be above zero.
inline double per_cell_size(std::string_view function, double size, const char* name = "options.cell_size") {
  if (!(size - size == 0)) throw NonFinite(std::string(function) + ": " + name + " is " + std::to_string(size));
  if (!(size > 0))
    throw InvalidShape(std::string(function) + ": " + name + " is not above zero, but cells need a size");
  const double per_size = 1 / size;
  return per_size < std::numeric_limits<double>::max() ? per_size : std::numeric_limits<double>::max();
}

inline void require_memory(std::string_view function, double bytes, std::size_t most,
                           const char* mend = "choose larger cells") {
  if (bytes <= static_cast<double>(most)) return;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), bytes, std::chars_format::general, 15).ptr;
  throw Error(std::string(function) + ": the grid would take " + std::string(text.data(), end) +
              " bytes, but options.most_memory is " + std::to_string(most) + "; " + mend);
}

}  // namespace plumb::space
