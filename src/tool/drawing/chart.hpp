// How do methods compare in two numbers each?  A scatter chart as SVG: logarithmic axes, one named point a method.
//
// Exact zeros have no place on a logarithmic axis: they stand in a band of their own below a break in the y axis,
// marked 0.  Colors are those of Okabe and Ito, told apart by color-blind readers, and every point has a shape of its
// own as well; the chart follows the reader's choice of light or dark.  Plain SVG text, no script, no font of its own.
//
// Laws: (1) well-formed XML whatever the labels hold; (2) labels never overlap each other or a marker (the chart grows
// where there is no room); (3) greater values lie further right or up, zero lies below all; (4) same input, same text.
// Source: none.
// Cost: well below a millisecond.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tool/drawing/label_placement.hpp"

namespace plumb::tool {

struct ChartPoint {
  std::string label;
  double x;               // positive
  double y;               // zero or positive
  bool complete = true;   // what does not answer everything is drawn faintly and is no part of the frontier
  std::string key = {};   // marks what is drawn of the point, for scripts
  std::string hint = {};  // shown where the reader points at it; its label and numbers when empty
  double most = 0;        // where it is above y, a thin line goes up to it
};

struct ChartText {
  std::string title, subtitle;
  std::string x_axis, y_axis;
  bool frontier = false;  // join the points that no other beats in both numbers
};

/// Where everything stands, in pixels.
struct ChartLayout {
  double width, height;
  Box plot;         // with the band of zeros
  double break_at;  // the top of that band; the plot's bottom where no value is zero
  std::vector<Box> markers;
  std::vector<LabelPlace> labels;
};

/// The complete points that no other complete one beats: none is both as far left and as far down.  From left to right.
std::vector<std::size_t> frontier_of(std::span<const ChartPoint> points);

/// Both throw plumb::Error where a point has no place (x not positive, y or most negative, not finite).
ChartLayout lay_out_chart(std::span<const ChartPoint> points);
std::string scatter_chart(const ChartText& text, std::span<const ChartPoint> points);

/// What all charts share: their classes in light and dark, and text as XML holds it.
extern const std::string_view chart_style;
std::string escaped(std::string_view text);

}  // namespace plumb::tool
