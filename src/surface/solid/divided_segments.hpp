// Where do segments of a plane meet, and into which pieces do their points divide them?
//
// Laws: (1) a segment's points, in order from its first end to its last, are its ends, the ends of others that are on
// it, and where others cross it: exact, each once.  (2) A segment may be a point: then it divides others.
// Source: RTCD 5.1.9.1.
// Cost: four signs for each pair whose boxes meet; some 10 us for each crossing.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "surface/solid/plane_view.hpp"
#include "surface/solid/point_table.hpp"

namespace plumb::surface {

/// Points of one plane, by numbers of their own, and as they are seen.
class SeenPoints {
 public:
  SeenPoints(PointTable& table, const PlaneView& view) : table_(table), view_(view) {}

  std::uint32_t add(std::uint32_t number_in_table);
  /// Tells where the lines ab and cd cross.
  std::uint32_t add_crossing(const std::array<std::uint32_t, 2>& ab, const std::array<std::uint32_t, 2>& cd);

  [[nodiscard]] std::size_t size() const { return seen_.size(); }
  [[nodiscard]] std::uint32_t number_in_table(std::uint32_t i) const { return numbers_[i]; }
  [[nodiscard]] const ExactPoint2& seen(std::uint32_t i) const { return seen_[i]; }
  /// Gives the point away, after which nothing is seen of it.
  ExactPoint2 take_seen(std::uint32_t i) { return std::move(seen_[i]); }
  /// Is the point known to be on the line of the segment, without a sign?
  [[nodiscard]] bool is_noted_on(std::uint32_t i, const std::array<std::uint32_t, 2>& ends) const {
    const std::uint32_t a = numbers_[ends[0]], b = numbers_[ends[1]];
    return table_.is_noted_on(numbers_[i], {std::min(a, b), std::max(a, b)});
  }
  [[nodiscard]] HeldPoint point(std::uint32_t i) const { return table_.points().at(numbers_[i]); }

 private:
  PointTable& table_;
  const PlaneView& view_;
  std::vector<std::uint32_t> numbers_;
  std::vector<ExactPoint2> seen_;
  std::unordered_map<std::uint32_t, std::uint32_t> known_;
};

using SegmentEnds = std::array<std::uint32_t, 2>;  // numbers in SeenPoints

std::vector<std::vector<std::uint32_t>> points_along(SeenPoints& points, std::span<const SegmentEnds> segments);

}  // namespace plumb::surface
