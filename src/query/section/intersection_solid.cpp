// Two solids: as what bounds each, and what they have in common.
#include "plumb/query/section/solid.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/convex_view.hpp"
#include "query/section/meet_halfspaces.hpp"
#include "query/section/meet_solids.hpp"

namespace plumb::query {

using namespace meeting;

SolidIntersection3 common_solid(const FigureView& a, const FigureView& b) {
  require_figures("intersection", a, b);
  const auto of_a = convex_set3(a), of_b = convex_set3(b);
  const auto goes_on = [](const FigureView& v) { return v.kind == FigureKind::halfspace; };
  if (of_a && of_b && !(goes_on(a) && goes_on(b))) return meet_solids(*of_a, *of_b);
  std::vector<ExactHalfspace> all = halfspaces_of(a);
  for (ExactHalfspace& h : halfspaces_of(b)) all.push_back(std::move(h));
  return meet_halfspaces(all);
}

}  // namespace plumb::query
