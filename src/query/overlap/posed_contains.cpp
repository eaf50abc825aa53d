// An outer figure is convex, so that it holds a hull where it holds what the hull is of: points, balls and disks.  Halfspaces
// are seen by the inner figure as it is before its pose; a round outer one sees the parts as it is before its own.
#include <algorithm>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/axis_relation.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/posed_set.hpp"
#include "query/convex/round_parts.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb::query {
namespace {

FlatSet point_set(const Exact3& p) { return {{p}, {}, {}, {}}; }

/// What the map maps to the halfspace; of the plane along the plane alone.
ExactHalfspace before(const ExactHalfspace& h, const ExactMap& map, int dimension) {
  const auto& c = map.columns;
  return {{dot(c[0], h.normal), dot(c[1], h.normal), dimension == 3 ? dot(c[2], h.normal) : mpq_class(0)},
          h.offset - dot(h.normal, map.translation)};
}

class PosedHolding {
 public:
  PosedHolding(const PosedView& outer, const PosedView& inner)
      : outer_(posed_set(outer)), inner_(posed_set(inner)), parts_(round_parts(inner.figure)), figure_(outer.figure) {
    if (is_polygon(outer.figure)) {
      require_convex_outer(outer.figure);
      outer_.core.points = exact_chains("contains", outer.figure)[0];
    }
    // What maps to a point has no radius.
    if (squared_scale(inner_.map, inner_.dimension) == 0) {
      for (RoundPart& part : parts_.parts) part.radius = 0;
    }
  }

  bool operator()() const {
    if (parts_.parts.empty()) return true;
    if (!outer_.is_round() && !outer_.has_axis()) return flat_holds();
    const bool is_bounded = std::ranges::all_of(parts_.directions, [&](const Exact3& d) { return vanishes(d); }) &&
                            std::ranges::all_of(parts_.lines, [&](const Exact3& l) { return vanishes(l); });
    if (!is_bounded) return false;
    const bool is_round = std::ranges::any_of(parts_.parts, [](const RoundPart& part) { return sgn(part.radius) > 0; });
    return is_round ? round_holds_round() : round_holds_points();
  }

 private:
  bool vanishes(const Exact3& way) const { return is_zero(turned(inner_.map, way)); }

  bool flat_holds() const {
    const FlatSet outer = image(outer_);
    return !outer.points.empty() && std::ranges::all_of(halfspaces_of(outer), [&](const ExactHalfspace& h) {
      return halfspace_holds(before(h, inner_.map, inner_.dimension), parts_);
    });
  }

  bool round_holds_points() const {
    return std::ranges::all_of(parts_.parts, [&](const RoundPart& part) {
      const FlatSet seen = preimage(outer_.map, point_set(image(inner_.map, part.at))).set;
      if (outer_.has_axis()) return relate_axis_shape(seen, *outer_.axis) != Relation::disjoint;
      const auto square = squared_distance(outer_.core, seen);
      return square && *square <= outer_.radius * outer_.radius;
    });
  }

  bool round_holds_round() const {
    const bool regular = !is_singular(outer_.map);
    const ExactMap seen = regular ? composed(inverse(outer_.map), inner_.map) : exact_identity();
    const auto scale = regular ? squared_scale(seen, outer_.dimension) : std::nullopt;
    if (!scale) {
      throw UnevenPose(std::string("contains: neither pose is a similarity to the other; of round figures ")
                           .append(rigid_instead)
                           .append(", or columns at right angles and of one length, or both one pose"));
    }
    const RoundBody round = round_body(figure_).value();  // no other kind holds what is round
    return all_ends(round, [&](const ExactHalfspace& end) { return halfspace_holds(before(end, seen, 3), parts_); }) &&
           std::ranges::all_of(parts_.parts, [&](const RoundPart& part) {
             const RoundPart moved{image(seen, part.at), part.radius, part.is_disk, turned(seen, part.axis)};
             return holds_near_core(round, moved, *scale);
           });
  }

  PosedSet outer_, inner_;
  RoundParts parts_;
  const FigureView& figure_;  // the outer one
};

}  // namespace

bool posed_contains(const PosedView& outer, const PosedView& inner) {
  require_posed("contains", "outer", outer);
  require_posed("contains", "inner", inner);
  return PosedHolding(outer, inner)();
}

}  // namespace plumb::query
