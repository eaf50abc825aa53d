// What is wrong with a hull in space?  Faces held against the true hull, exactly.
//
// Laws: (1) exact for all finite doubles: sides are those of orient3d, and the extreme points those of a hull that
// verify_hull proves; (2) equal points are one, whichever of them is named; (3) a face of more than three corners is
// judged by the triangles from its first corner, so that it must be flat.
// Source: RTCD 3.9.
// Cost: corners of faces times extreme points, a sign each.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "lab/stability/space_hull_ways.hpp"
#include "plumb/arith/point.hpp"

namespace plumb::lab::stability {

struct SpaceHullFlaws {
  /// Faces of points in a plane, or none of points that span space: the rest is not judged.
  bool wrong_dimension = false;
  std::vector<std::uint32_t> lost;                 // extreme points that are no corner
  std::vector<std::size_t> seen;                   // faces that have a point on their outer side
  std::vector<std::size_t> flat;                   // faces of which three corners lie on a line
  std::vector<std::array<std::uint32_t, 2>> torn;  // edges that have not one face on either side

  friend bool operator==(const SpaceHullFlaws&, const SpaceHullFlaws&) = default;
};

class SpaceHullJudge {
 public:
  /// Throws Error where the library's hull is not proved to be one, which would be a bug.
  explicit SpaceHullJudge(std::span<const Point3> points);

  [[nodiscard]] SpaceHullFlaws flaws(const Faces& faces) const;
  [[nodiscard]] bool is_flat() const { return flat_; }
  [[nodiscard]] std::span<const Point3> points() const { return points_; }
  [[nodiscard]] std::span<const std::uint32_t> extreme() const { return extreme_; }

 private:
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> torn_edges(const Faces& faces) const;

  std::vector<Point3> points_;
  std::vector<std::uint32_t> first_equal_;  // of each point: the first of those that equal it
  std::vector<std::uint32_t> extreme_;
  bool flat_;
};

}  // namespace plumb::lab::stability
