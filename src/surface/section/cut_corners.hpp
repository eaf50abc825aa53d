// What lies where among the corners of a section?  Exact decisions on points that are held as edges.
//
// Laws: those of real numbers on the exact corners; coordinates are the two that show the plane (cut_plane.hpp), and
// turns are as seen from the normal's side.  A nearest double is moved by rounding, but never past another one: where
// two differ, they say the order; else intervals between the neighboring doubles, else rational numbers.
// Cost: a comparison, some 100 ns where intervals decide, some 10 us where they cannot, once for each corner.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>

#include "plumb/arith/interval.hpp"
#include "plumb/surface/section/section.hpp"
#include "surface/section/cut_plane.hpp"

namespace plumb::surface {

class CutCorners {
 public:
  CutCorners(const TriangleMesh& mesh, const CutPlane& plane, std::span<const SectionCorner> corners)
      : mesh_(mesh), plane_(plane), corners_(corners) {}

  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] double nearest(std::uint32_t corner, std::size_t k) const {
    return coordinate(corners_[corner].nearest, plane_.shown()[k]);
  }
  [[nodiscard]] Interval between(std::uint32_t corner, std::size_t k) const;
  [[nodiscard]] const RationalPoint2& rational(std::uint32_t corner) const;

  /// Of coordinate k.
  [[nodiscard]] Sign compare(std::uint32_t a, std::uint32_t b, std::size_t k) const;
  [[nodiscard]] bool equal(std::uint32_t a, std::uint32_t b) const;
  /// Positive when they turn counterclockwise.
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// That of the area which they go around.
  [[nodiscard]] Sign turn(std::span<const std::uint32_t> loop) const;

 private:
  [[nodiscard]] bool is_given(std::uint32_t corner, std::size_t k) const;

  const TriangleMesh& mesh_;
  const CutPlane& plane_;
  std::span<const SectionCorner> corners_;
  mutable std::unordered_map<std::uint32_t, RationalPoint2> rational_;  // those that were asked for
};

}  // namespace plumb::surface
