// Which arguments does a function of a user's own kind take?  Read from words such as "ray:point3,vector3".
//
//   a:point2          one point of the plane            p:point3x4     four points in space, one after the other
//   hull:points3      any number of points, counted     poly:points2+3 three at least
//   d:vector3         a direction                       b:box3         the least corner and the largest
//   r:length          a number that is not negative     ray:point3,vector3   both in one argument
// Law: a word that is none of these throws Error, which shows them.
// Source: none.
// Cost: none.
#pragma once

#include <string>

#include "plumb/degenerate/kind.hpp"

namespace plumb::tool {

degenerate::Argument own_argument(const std::string& word);

/// sign, yes-no or number.
degenerate::AnswerForm own_answer(const std::string& word);

}  // namespace plumb::tool
