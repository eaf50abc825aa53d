// What does a wrong hull look like?  The true hull, the claimed one, and the corners that it lost.
//
// Law: the picture is stretched along two axes as HullJudge says, so that what lies outside by an ulp is seen.
// Source: none.
// Cost: a millisecond.
#pragma once

#include <string>
#include <vector>

#include "lab/stability/hull_judge.hpp"

namespace plumb::lab::stability {

struct HullPictureText {
  std::string title, subtitle;
};

std::string hull_picture(const HullPictureText& text, const HullJudge& judge,
                         const std::vector<std::uint32_t>& claimed);

}  // namespace plumb::lab::stability
