// What is wrong with a hull?  Corners held against the true ones, in rationals.
//
// Laws: (1) exact for all finite doubles; the library's signs are not asked; (2) equal points are one corner, whichever
// of them is named.
// Source: RTCD 3.9.
// Cost: true corners times claimed corners, a microsecond or some each.
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

#include "lab/stability/hull_ways.hpp"
#include "plumb/arith/point.hpp"

namespace plumb::lab::stability {

struct HullFlaws {
  bool not_convex = false;   // turns right somewhere
  bool leaves_out = false;   // a point lies outside of an edge
  bool lost = false;         // an extreme point is no corner
  bool no_corner = false;    // a corner that is no extreme point, or is named twice
  double worst_outside = 0;  // how far a point lies outside, as a share of the true hull's width; for pictures
};

class HullJudge {
 public:
  explicit HullJudge(std::span<const Point2> points);

  [[nodiscard]] HullFlaws flaws(const std::vector<std::uint32_t>& corners) const;
  [[nodiscard]] const std::vector<std::uint32_t>& corners() const { return corners_; }

  /// Where all points lie when the true hull is stretched to the unit square: along the line of its first and last
  /// corner, and across it.  Straight lines stay straight, and sides stay sides.
  [[nodiscard]] std::vector<std::array<double, 2>> stretched() const;
  /// How many times farther apart points stand across than along; 1 for equal scales.
  [[nodiscard]] double stretch() const;

 private:
  [[nodiscard]] mpq_class area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] mpq_class along(std::uint32_t p) const;
  [[nodiscard]] mpq_class across(std::uint32_t p) const;

  std::vector<std::array<mpq_class, 2>> points_;
  std::vector<std::uint32_t> corners_;  // counterclockwise from the first by x, then y
  std::uint32_t last_ = 0;              // by x, then y
  mpq_class least_along_, length_, least_across_, width_;
};

}  // namespace plumb::lab::stability
