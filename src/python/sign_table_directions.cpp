#include "plumb/certify/direction.hpp"
#include "python/sign_question.hpp"

namespace plumb::python {
namespace {

/// They are asked in the plane and in space; the arguments are points or vectors alike.
template <class Function>
std::vector<SignForm> of_two(std::array<const char*, 2> names, Function function) {
  return {form<Point2, Point2>(names, function), form<Point3, Point3>(names, function)};
}
template <class Function>
std::vector<SignForm> of_two_vectors(Function function) {
  return {form<Vector2, Vector2>({"a", "b"}, function), form<Vector3, Vector3>({"a", "b"}, function)};
}
template <class Function>
std::vector<SignForm> of_three(Function function) {
  return {form<Point2, Point2, Point2>({"a", "b", "c"}, function),
          form<Point3, Point3, Point3>({"a", "b", "c"}, function)};
}

}  // namespace

std::vector<SignQuestion> direction_questions() {
  return {
      {"compare_lexicographically", "The order of a and b by x, where these are equal by y, then by z.",
       of_two({"a", "b"}, [](const auto&... p) { return compare_lexicographically(p...); })},
      {"compare_along_direction",
       "Does a lie farther along the direction than b?",
       {form<Point2, Point2, Vector2>({"a", "b", "direction"},
                                      [](const auto&... p) { return compare_along_direction(p...); }),
        form<Point3, Point3, Vector3>({"a", "b", "direction"},
                                      [](const auto&... p) { return compare_along_direction(p...); })}},
      {"compare_along_line",
       "Does a lie farther than b along the line from c to d?",
       {form<Point2, Point2, Point2, Point2>({"a", "b", "c", "d"},
                                             [](const auto&... p) { return compare_along_line(p...); }),
        form<Point3, Point3, Point3, Point3>({"a", "b", "c", "d"},
                                             [](const auto&... p) { return compare_along_line(p...); })}},
      {"are_ordered_along_line", "Does b lie on the segment from a to c, its ends included?",
       of_three([](const auto&... p) { return are_ordered_along_line(p...); }), true},
      {"dot_sign", "The sign of a . b: 1 for an acute angle between the vectors, 0 for a right one.",
       of_two_vectors([](const auto&... v) { return dot_sign(v...); })},
      {"angle_sign", "Is the angle at b, between the directions to a and to c, acute (1), right (0) or obtuse (-1)?",
       of_three([](const auto&... p) { return angle_sign(p...); })},
      {"cross_sign",
       "Does the vector b point to the left of a?  0 if they are parallel.",
       {form<Vector2, Vector2>({"a", "b"}, [](const auto&... v) { return cross_sign(v...); })}},
      {"perpendicular", "Are the vectors at right angles?",
       of_two_vectors([](const auto&... v) { return perpendicular(v...); }), true},
      {"parallel", "Have the vectors the same or the opposite direction?",
       of_two_vectors([](const auto&... v) { return parallel(v...); }), true},
      {"collinear", "Do the points lie on one line?", of_three([](const auto&... p) { return collinear(p...); }), true},
  };
}

}  // namespace plumb::python
