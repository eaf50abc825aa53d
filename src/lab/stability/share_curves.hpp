// How does a share of failures depend on a number of many magnitudes?  Curves side by side, as SVG.
//
// Panels share one vertical axis, 0 to 100 percent, and the legend; each has a logarithmic axis of its own.  Every line
// has a color and a shape of marker, both those of chart.hpp, and its points tell their numbers where pointed at.
// Laws: (1) well-formed XML whatever the labels hold; (2) same input, same text.
// Source: none.
// Cost: microseconds.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/trial/terms.hpp"

namespace plumb::lab::stability {

struct SharePoint {
  double x;      // positive
  double share;  // of 1
};

struct ShareCurve {
  std::string label;  // of equal ones the legend shows one
  std::vector<SharePoint> points;
};

struct SharePanel {
  std::string title, x_axis;
  std::vector<ShareCurve> curves;
};

/// The title, and below it a line that says what is shown.
std::string share_curves(const std::string& title, const std::string& subtitle, std::span<const SharePanel> panels);

}  // namespace plumb::lab::stability
