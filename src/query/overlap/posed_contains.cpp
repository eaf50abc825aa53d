// An outer figure is convex, so that it holds a hull where it holds what the hull is of: points, and balls around them.
#include <algorithm>

#include "plumb/arith/error.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/posed_set.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb::query {
namespace {

/// Its corners, and its core's, before the pose.
PosedSet held_set(const PosedView& v) {
  PosedSet s = posed_set(v);
  if (!is_polygon(v.figure)) return s;
  for (const auto& chain : exact_chains("contains", v.figure))
    s.core.points.insert(s.core.points.end(), chain.begin(), chain.end());
  return s;
}

/// The square of how far its balls reach along the normal, times that of the normal.
mpq_class squared_reach(const PosedSet& s, const Exact3& normal) {
  mpq_class square = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(s.dimension); ++k) {
    const mpq_class along = dot(s.map.columns[k], normal);
    square += along * along;
  }
  return square * s.radius * s.radius;
}

bool flat_holds(const FlatSet& outer, const PosedSet& inner, const FlatSet& held) {
  if (outer.points.empty()) return false;
  return std::ranges::all_of(halfspaces_of(outer), [&](const ExactHalfspace& h) {
    const mpq_class reach = squared_reach(inner, h.normal);
    const auto is_below = [&](const Exact3& p) {
      const mpq_class room = h.offset - dot(h.normal, p);
      return sgn(room) >= 0 && room * room >= reach;
    };
    return std::ranges::all_of(held.points, is_below) &&
           std::ranges::all_of(held.directions, [&](const Exact3& d) { return sgn(dot(h.normal, d)) <= 0; }) &&
           std::ranges::all_of(held.lines, [&](const Exact3& l) { return sgn(dot(h.normal, l)) == 0; });
  });
}

bool round_holds(const PosedSet& outer, const PosedSet& inner, const FlatSet& held) {
  if (!held.directions.empty() || !held.lines.empty()) return false;
  mpq_class reach = 0;
  if (inner.is_round()) {
    const bool regular = !is_singular(outer.map);
    const auto scale = regular ? squared_scale(composed(inverse(outer.map), inner.map), outer.dimension) : std::nullopt;
    if (!scale) {
      throw UnevenPose(
          "contains: neither pose is a similarity to the other; give round figures poses of columns at right angles "
          "and of one length, or one pose");
    }
    reach = inner.radius * inner.radius * *scale;
  }
  return std::ranges::all_of(held.points, [&](const Exact3& p) {
    const FlatSet seen = preimage(outer.map, FlatSet{{p}, {}, {}}).set;
    const auto square = squared_distance(outer.core, seen);
    return square && sign_of_roots(*square, reach, mpq_class(outer.radius * outer.radius)) <= 0;
  });
}

}  // namespace

bool posed_contains(const PosedView& outer, const PosedView& inner) {
  require_posed("contains", "outer", outer);
  require_posed("contains", "inner", inner);
  const PosedSet out = posed_set(outer), in = held_set(inner);
  const FlatSet held = image(in);
  if (held.points.empty()) return true;
  return out.is_round() ? round_holds(out, in, held) : flat_holds(image(out), in, held);
}

}  // namespace plumb::query
