#include "tool/trial/predicate_task.hpp"

namespace plumb::tool::trial {

Task incircle_task() {
  return predicate_task<predicates::InCircle>(
      "is a point inside a circle?", Degeneracy::cocircular,
      [](auto a, auto b, auto c, auto d, auto out) { incircle(a, b, c, d, out); });
}

Task insphere_task() {
  return predicate_task<predicates::InSphere>(
      "is a point inside a sphere?", Degeneracy::cospherical,
      [](auto a, auto b, auto c, auto d, auto e, auto out) { insphere(a, b, c, d, e, out); });
}

}  // namespace plumb::tool::trial
