// What does a method see around a point?  Fields of signs side by side, one panel a method.
//
// Laws: (1) every sign is one square of one color, blue, yellow or vermilion, which color-blind readers tell apart and
// which show on light and on dark; (2) well-formed XML whatever the texts hold.
// Source: Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom examples of robustness problems in geometric
// computations".
// Cost: a millisecond or some.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plumb/arith/sign.hpp"

namespace plumb::lab::stability {

struct SignPanel {
  std::string title, subtitle;
  std::vector<Sign> signs;  // of a square field, row by row from the bottom
};

struct SignPictureText {
  std::string title, subtitle;
  std::string negative, zero, positive;  // what the colors mean: "right of the line"
};

/// Three panels in a row, all of the same number of signs.
std::string sign_picture(const SignPictureText& text, std::span<const SignPanel> panels);

}  // namespace plumb::lab::stability
