// What does a wrong hull in space look like?  The faces that were computed, and what is wrong with them.
//
// Law: the true hull's box is drawn as a cube, so that thin and long ones are seen; straight lines stay straight, and
// sides stay sides.
// Source: none.
// Cost: a millisecond.
#pragma once

#include <string>

#include "lab/stability/space_hull_judge.hpp"

namespace plumb::lab::stability {

/// Of points that span space.
std::string space_hull_picture(const std::string& title, const std::string& subtitle, const SpaceHullJudge& judge,
                               const Faces& faces);

}  // namespace plumb::lab::stability
