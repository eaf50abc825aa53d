// GJK: do two hulls meet, as far as doubles can prove it?  A search that ends at the first plane between them, or at four
// corners of their difference around the origin.
//
// Laws: what is told is so; `unsure` says nothing, and leaves the best corners found in `simplex`.  `direction` is that of the
// plane: all of a is strictly farther along than all of b.  What is handed in is a guess, and may be any.  Bodies with a
// radius are apart where a plane leaves a wider gap between the cores than the radii reach, and meet where points of the
// cores are strictly nearer.
// Source: Gilbert, Johnson and Keerthi 1988; van den Bergen 1999 (ending at a separating axis); RTCD 9.5, 9.5.4.
// Cost: 20 to 50 ns a corner; no allocation.
#pragma once

#include "plumb/query/gjk/gjk.hpp"
#include "query/gjk/quick_hull.hpp"

namespace plumb::query {

enum class Told : unsigned char { apart, meet, unsure };

inline BodyView body_of(const PosedView& v) { return {.figure = v.figure, .vertices = {}, .pose = v.pose}; }

/// A body and its corners in doubles; the body is asked where its corners are no doubles as given.
struct QuickBody {
  const BodyView& view;
  QuickHull hull = {};
  double radius = 0;
  const CoreCorners* core = nullptr;  // of what is no body; else those of the body

  /// Not of what QuickHull does not take, and of what is as round as a pose makes it.
  bool set();
  [[nodiscard]] CoreCorners corners() const { return core != nullptr ? *core : *CoreCorners::of(view); }
};

/// Both, as large as the weights of the poses make them.
std::array<CoreCorners, 2> corners_of(const QuickBody& a, const QuickBody& b);

/// Of hulls as given: is the origin strictly within these corners of the difference, as far as doubles prove it?
bool are_around_origin(const QuickHull& a, const QuickHull& b, const std::array<GjkCorner, 4>& corners);

Told quickly_told(const QuickBody& a, const QuickBody& b, GjkCache& found, std::uint32_t& steps);
/// The same of bodies that have a radius, one of them at least.
Told quickly_told_round(const QuickBody& a, const QuickBody& b, GjkCache& found, std::uint32_t& steps);

}  // namespace plumb::query
