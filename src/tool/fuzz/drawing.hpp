// How does a case look, to somebody who is to see what is wrong with it?  Its figures as SVG, and what all but
// coincides as a table.
//
// Where the figures are flatter than the eye sees, the drawing is stretched across: along the line through the two
// points farthest apart all is to scale, across it as much larger as it says.  That is an affine map: what crosses, is
// inside, or is on which side stays so, and what lies exactly in line stays in line.  Figures in space are seen from
// above the plane of their three points farthest apart.  Points that still fall together share a label, "=" where they
// are equal, and are drawn once more from near where they differ.
// Laws: (1) places are exact up to one rounding to pixels: differences are taken in rationals; (2) well-formed, and the
// same text for the same case; (3) the table has every pair of coordinates of one axis that the drawing cannot tell
// apart although they differ, each pair of numbers once, and how many doubles lie between.
// Source: none.
// Cost: some milliseconds, quadratic in the points.
#pragma once

#include <string>

#include "plumb/degenerate/kind.hpp"

namespace plumb::tool {

/// Each an <svg> in the classes of chart_style, in a <figure> that says its scale: the whole, and from near what
/// falls together in it.  Empty where there is nothing to draw.
std::string case_drawings(const degenerate::Kind& kind, const degenerate::Numbers& numbers);

/// The near coincidences as a table of HTML; empty where there are none.
std::string near_coincidences(const degenerate::Kind& kind, const degenerate::Numbers& numbers);

}  // namespace plumb::tool
