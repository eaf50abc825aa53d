#include "query/convex/axis_relation.hpp"

#include <algorithm>

#include "arith/root_sign.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/round_parts.hpp"

namespace plumb::query {
namespace {

/// The axis from its apex, or from an end; a point's height is its share of the axis.
struct ExactAxis {
  explicit ExactAxis(const RoundAxis& shape)
      : from(exact3(shape.from)),
        along(exact3(shape.to) - from),
        square(dot(along, along)),
        radius(shape.radius),
        is_cone(shape.is_cone) {}
  [[nodiscard]] mpq_class height(const Exact3& p) const { return dot(along, p - from) / square; }
  /// Of a point the way from the axis, turned by a right angle, times the length of the axis.
  [[nodiscard]] Exact3 off(const Exact3& p) const { return cross(along, p - from); }

  Exact3 from, along;
  mpq_class square, radius;
  bool is_cone;
};

/// What of a set lies between the planes of the ends, and whether its relative interior goes between them.
struct BetweenEnds {
  BetweenEnds(const FlatSet& set, const ExactAxis& axis) {
    bool above_start = false, below_end = false;
    const auto see_way = [&](const Exact3& d, bool both, std::vector<Exact3>& kept) {
      const int rise = sgn(dot(axis.along, d));
      above_start = above_start || rise > 0 || (both && rise != 0);
      below_end = below_end || rise < 0 || (both && rise != 0);
      if (rise == 0) kept.push_back(d);
    };
    for (const Exact3& d : set.directions) see_way(d, false, part.directions);
    for (const Exact3& d : set.lines) see_way(d, true, part.lines);
    for (const Exact3& p : set.points) {
      const mpq_class h = axis.height(p);
      above_start = above_start || sgn(h) > 0;
      below_end = below_end || h < 1;
      if (sgn(h) >= 0 && h <= 1) part.points.push_back(p);
    }
    const mpq_class start = dot(axis.along, axis.from);
    for (const mpq_class& end : {start, mpq_class(start + axis.square)}) {
      const FlatSet cut = section(set, axis.along, end).set;
      part.points.insert(part.points.end(), cut.points.begin(), cut.points.end());
      part.directions.insert(part.directions.end(), cut.directions.begin(), cut.directions.end());
      part.lines.insert(part.lines.end(), cut.lines.begin(), cut.lines.end());
    }
    goes_inside = above_start && below_end;
  }
  FlatSet part = {};
  bool goes_inside;
};

FlatSet only_point(const Exact3& p) { return {{p}, {}, {}, {}}; }
const Exact3 origin{0, 0, 0};

/// The sign of how far the set between the ends comes to the axis, minus the radius there; nothing where it has no more
/// than points level with the apex.
std::optional<int> sign_of_gap(const FlatSet& part, const ExactAxis& axis) {
  FlatSet seen;
  for (const Exact3& p : part.points) {
    const mpq_class share = axis.is_cone ? axis.height(p) : mpq_class(1);
    if (sgn(share) != 0) {
      seen.points.push_back(mpq_class(1 / share) * axis.off(p));
    } else if (const Exact3 way = axis.off(p); !is_zero(way)) {
      seen.directions.push_back(way);  // a point level with the apex is seen at infinity
    }
  }
  const auto see_ways = [&](const std::vector<Exact3>& ways, std::vector<Exact3>& to) {
    for (const Exact3& d : ways) to.push_back(cross(axis.along, d));
  };
  see_ways(part.directions, seen.directions);
  see_ways(part.lines, seen.lines);
  const auto gap = squared_distance(only_point(origin), seen);
  if (!gap) return {};
  return sgn(mpq_class(*gap - axis.radius * axis.radius * axis.square));
}

Relation relate_to_axis(const FlatSet& set, const ExactAxis& axis) {
  if (set.points.empty()) return Relation::disjoint;
  const BetweenEnds between(set, axis);
  if (between.part.points.empty()) return Relation::disjoint;
  const auto gap = sign_of_gap(between.part, axis);
  if (gap && *gap <= 0) return *gap < 0 && between.goes_inside ? Relation::overlapping : Relation::touching;
  return axis.is_cone && intersects(between.part, only_point(axis.from)) ? Relation::touching : Relation::disjoint;
}

Relation relate_to_axis(const ExactChains& chains, const ExactAxis& axis) {
  Relation most = Relation::disjoint;
  const auto see = [&](const FlatSet& piece, Relation at_most) {
    if (most < at_most) most = std::max(most, std::min(relate_to_axis(piece, axis), at_most));
  };
  if (!normal_of(chains)) {
    for (const auto& [piece, has_inside] : pieces_on_line(chains))
      see(piece, has_inside ? Relation::overlapping : Relation::touching);
    return most;
  }
  for (const FlatSet& cell : trapezoids(chains)) see(cell, Relation::overlapping);
  for (const FlatSet& edge : edges_of(chains)) see(edge, Relation::touching);
  return most;
}

/// The sign of how far the point is from the shape, minus a radius above zero.
Sign sign_of_distance(const Exact3& p, const mpq_class& reach, const ExactAxis& axis) {
  const mpq_class &r = axis.radius, &length = axis.square, h = axis.height(p), beyond = h - 1, off_axis = h * length;
  const Exact3 off = axis.off(p);
  const mpq_class width = dot(off, off) / length;  // the square of the way to the axis
  const auto with_root = [&](const mpq_class& a, const mpq_class& b) { return sign_of_root(a, b, width); };
  // From the rim of a disk that is so far along the axis.
  const auto from_rim = [&](const mpq_class& squared_rise) {
    return with_root(width + r * r + squared_rise - reach, -2 * r);
  };
  const auto from_plane = [&](const mpq_class& squared_rise) {
    return sign_of_rational(mpq_class(squared_rise - reach));
  };
  if (!axis.is_cone) {
    const mpq_class out = sgn(h) < 0 ? h : sgn(beyond) > 0 ? beyond : mpq_class(0), rise = out * out * length;
    return width <= r * r ? from_plane(rise) : from_rim(rise);
  }
  if (sgn(beyond) >= 0 && width <= r * r) return from_plane(beyond * beyond * length);  // of the base
  if (sgn(beyond) >= 0) return from_rim(beyond * beyond * length);
  if (sgn(h) >= 0 && width <= r * r * h * h) return Sign::negative;
  // Where is its foot on the line from the apex to the rim?  Before it: h length + r root(width) <= 0.
  if (with_root(off_axis, r) != Sign::positive) return from_plane(h * h * length + width);
  if (with_root(length + r * r - off_axis, -r) != Sign::positive) return from_rim(beyond * beyond * length);
  return with_root(length * (width + r * r * h * h) - reach * (length + r * r), -2 * length * r * h);
}

}  // namespace

Relation relate_axis_shape(const FlatSet& set, const RoundAxis& shape) { return relate_to_axis(set, ExactAxis(shape)); }
Relation relate_axis_shape(const ExactChains& chains, const RoundAxis& shape) {
  return relate_to_axis(chains, ExactAxis(shape));
}
Relation relate_axis_shape(const Exact3& center, const mpq_class& squared_radius, const RoundAxis& shape) {
  return static_cast<Relation>(-static_cast<int>(sign_of_distance(center, squared_radius, ExactAxis(shape))));
}

}  // namespace plumb::query
