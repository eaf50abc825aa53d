// Figures whose types were forgotten: each as a convex set, and what two of them have in common.
#include "plumb/query/section/intersection.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/convex_view.hpp"
#include "query/section/meet.hpp"

namespace plumb::query {

Intersection2 common_set2(const FigureView& a, const FigureView& b) {
  require_figures("intersection", a, b);
  return meeting::meet(meeting::convex_set2(a).value(), meeting::convex_set2(b).value());
}

Intersection3 common_set3(const FigureView& a, const FigureView& b) {
  require_figures("intersection", a, b);
  return meeting::meet(meeting::convex_set3(a).value(), meeting::convex_set3(b).value());
}

}  // namespace plumb::query
