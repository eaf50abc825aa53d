// What is seen of a question: its figures, what the answer names of them, and the steps of the search between two?
//
// A figure is drawn as the hull of its extreme points along many directions, whatever its kind; one without an end as what a
// box around all others has in common with it.
// Laws: (1) every question has a drawing; a figure that has none is told in words, and why.  (2) Coordinates are rounded,
// and scaled by one power of two, so that the largest are about one: pictures are near to what was decided, they decide
// nothing.  (3) Steps are those of GJK between the cores of two convex bodies of space.
// Source: RTCD 2.7.1, 9.5.
// Cost: some hundred extreme points a figure.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/variant/question_line.hpp"

namespace plumb::tool {

struct DrawnFigure {
  std::string name, text;  // "a", and how it is written
  std::string why_not;     // empty where it is drawn
  std::vector<Point3> points;
  std::set<std::array<std::size_t, 2>> edges;
  std::vector<Point3> corners;  // of its core, as the search numbers them
};
/// A point, or what leads from one to another.
struct DrawnMark {
  std::string title;
  std::vector<Point3> points;
};
struct DrawnQuestion {
  std::vector<DrawnFigure> figures;
  std::vector<DrawnMark> marks;
  std::vector<GjkStep> steps;
};

DrawnQuestion drawn_question(const QuestionLine& line);

}  // namespace plumb::tool
