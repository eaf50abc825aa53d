// The nearest points of the images' cores, told as those of figures that stand.
#include "plumb/query/separation/posed.hpp"

#include <string>

#include "plumb/arith/error.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/posed_radius.hpp"
#include "query/convex/search.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/separation/cores.hpp"
#include "query/separation/edge_sums.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

constexpr std::string_view asked_of_posed = "closest_points";

struct SeenUnderPose {
  PosedSet set;
  SeenFigure seen;

  explicit SeenUnderPose(const PosedView& v)
      : set(posed_set(v)), seen{v.figure, radius_of_image(asked_of_posed, v, set)} {
    if (is_polygon(v.figure)) {
      static_cast<void>(exact_chains(asked_of_posed, v.figure));  // throws where it is not planar
    } else if (set.core.points.empty()) {
      throw InvalidShape(std::string(asked_of_posed)
                             .append(": ")
                             .append(spoken(v.figure))
                             .append(" is empty, and nothing is nearest; give one that has a point"));
    }
  }
};

}  // namespace

Closest posed_closest_points(const PosedView& a, const PosedView& b, WhichPair common) {
  if (const auto c = closest_of_sums(a, b)) return *c;
  if (const auto c = closest_by_search(a, b, common)) return *c;
  require_posed(asked_of_posed, a, b);
  SeenUnderPose p(a), q(b);
  p.seen.map = &p.set.map, q.seen.map = &q.set.map;
  const NearestPair pair = *nearest_of_cores({a.figure, p.set.map}, {b.figure, q.set.map}, WhichPair::first);
  return told_pair(pair, p.seen, q.seen);
}

}  // namespace plumb::query
