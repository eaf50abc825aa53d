#include "tool/trial/predicate_task.hpp"

namespace plumb::tool::trial {

Task orient2d_task() {
  return predicate_task<predicates::Orient2d>("on which side of a line is a point?", Degeneracy::collinear,
                                              [](auto a, auto b, auto c, auto out) { orient2d(a, b, c, out); });
}

Task orient3d_task() {
  return predicate_task<predicates::Orient3d>(
      "on which side of a plane is a point?", Degeneracy::coplanar,
      [](auto a, auto b, auto c, auto d, auto out) { orient3d(a, b, c, d, out); });
}

}  // namespace plumb::tool::trial
