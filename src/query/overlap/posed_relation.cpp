// Straight figures by separating axes over numbers that know their errors, else by their images' generators; round ones
// by what goes into them under their pose, against them as they stand.

#include <algorithm>
#include <string>

#include "arith/exact_number.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/overlap/ellipsoid.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/axis_shape.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/axis_relation.hpp"
#include "query/convex/cap_relation.hpp"
#include "query/convex/ellipsoid_pair.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/posed_boxes.hpp"
#include "query/convex/posed_set.hpp"
#include "query/convex/search.hpp"
#include "query/convex/separating_axes.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb::query {
namespace {

Relation on_boundary_alone(Relation r) { return std::min(r, Relation::touching); }
Relation of_part(Relation r, bool of_inside) { return of_inside ? r : on_boundary_alone(r); }

/// Of balls around the sets, of radii whose squares these are.
Relation relate_near(const FlatSet& a, const mpq_class& a_reach, const FlatSet& b, const mpq_class& b_reach) {
  const auto square = squared_distance(a, b);
  return square ? static_cast<Relation>(sign_of_roots(a_reach, b_reach, *square)) : Relation::disjoint;
}

/// One question, of figures that doubles did not tell.
class PosedRelation {
 public:
  PosedRelation(std::string_view function, const PosedView& a, const PosedView& b)
      : function_(function), names_{spoken(a.figure), spoken(b.figure)}, a_(set_of(a)), b_(set_of(b)) {}
  PosedRelation(std::string_view function, const Ellipsoid3& a, const PosedView& b)
      : function_(function), names_{"ellipsoid", spoken(b.figure)}, a_(set_of(a)), b_(set_of(b)) {}
  PosedRelation(std::string_view function, const Ellipsoid3& a, const Ellipsoid3& b)
      : function_(function), names_{"ellipsoid", "ellipsoid"}, a_(set_of(a)), b_(set_of(b)) {}

  Relation operator()() const {
    if (a_.is_empty() || b_.is_empty()) return Relation::disjoint;
    if (a_.cap != nullptr) return cap_with(a_, b_);
    if (b_.cap != nullptr) return cap_with(b_, a_);
    if (a_.has_axis()) return axis_with(a_, b_);
    if (b_.has_axis()) return axis_with(b_, a_);
    if (a_.is_round() && b_.is_round()) return round_with_round();
    if (a_.is_round()) return round_with(a_, b_);
    if (b_.is_round()) return round_with(b_, a_);
    if (a_.is_polygon() && b_.is_polygon()) return relate_chains(image(a_.map, a_.chains), image(b_.map, b_.chains));
    if (a_.is_polygon()) return relate_chains(image(a_.map, a_.chains), image(b_));
    if (b_.is_polygon()) return relate_chains(image(b_.map, b_.chains), image(a_));
    return relate(image(a_), image(b_));
  }

 private:
  PosedSet set_of(const PosedView& v) const {
    PosedSet s = posed_set(v);
    if (is_flat_kind(v.figure.kind) && is_polygon(v.figure)) s.chains = exact_chains(function_, v.figure);
    return s;
  }

  /// The unit ball under the map of the half axes.
  static PosedSet set_of(const Ellipsoid3& e) {
    PosedSet s;
    s.core = flat_set(Point3{0, 0, 0});
    s.radius = 1;
    const std::array<double, 3> half{e.half.x, e.half.y, e.half.z};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [x, y, z] = e.axes[i];
      s.map.columns[i] = mpq_class(half[i]) * Exact3{x, y, z};
    }
    s.map.translation = {e.center.x, e.center.y, e.center.z};
    if (squared_scale(s.map, 3) == 0) s.radius = 0;
    return s;
  }

  [[noreturn]] void refuse(std::string_view why) const {
    throw UnevenPose(
        std::string(function_).append(": ").append(names_[0]).append(" and ").append(names_[1]).append(": ").append(
            why));
  }

  [[noreturn]] void refuse(std::string_view why, std::string_view or_else) const {
    refuse(std::string(why).append(rigid_instead).append(or_else));
  }

  Relation round_with(const PosedSet& round, const PosedSet& other) const {
    const mpq_class reach = round.radius * round.radius;
    if (!other.is_polygon()) {
      const Preimage part = preimage(round.map, image(other));
      return of_part(relate_near(round.core, reach, part.set, 0), part.of_inside);
    }
    if (is_singular(round.map)) refuse("a pose flattens what is round; of polygons ask their triangles");
    const ExactChains chains = image(composed(inverse(round.map), other.map), other.chains);
    Relation most = Relation::disjoint;
    if (!normal_of(chains)) {
      for (const auto& [piece, has_inside] : pieces_on_line(chains))
        most = std::max(most, of_part(relate_near(round.core, reach, piece, 0), has_inside));
      return most;
    }
    for (const FlatSet& cell : trapezoids(chains)) most = std::max(most, relate_near(round.core, reach, cell, 0));
    for (const FlatSet& edge : edges_of(chains)) {
      if (most != Relation::disjoint) break;
      most = on_boundary_alone(relate_near(round.core, reach, edge, 0));
    }
    return most;
  }

  /// As one of them sees the other, which must be as round to it.
  Relation round_with_round() const {
    const bool swap = is_singular(a_.map);
    const PosedSet &still = swap ? b_ : a_, &other = swap ? a_ : b_;
    if (!is_singular(still.map)) {
      const ExactMap seen = still.map == other.map ? exact_identity() : composed(inverse(still.map), other.map);
      if (const auto scale = squared_scale(seen, still.dimension)) {
        const mpq_class reach = other.radius * other.radius * *scale;
        return relate_near(still.core, mpq_class(still.radius * still.radius), image(seen, other.core), reach);
      }
    }
    if (is_ellipsoid(a_) && is_ellipsoid(b_)) return relate_ellipsoids(of_unit_ball(a_), of_unit_ball(b_));
    refuse("neither pose is a similarity to the other; of capsules and lozenges ",
           ", or columns at right angles and of one length, or both one pose");
  }

  /// Of a ball under a map that has an inverse.
  static bool is_ellipsoid(const PosedSet& s) { return s.core.points.size() == 1 && !is_singular(s.map); }
  static ExactMap of_unit_ball(const PosedSet& s) {
    ExactMap map = s.map;
    map.translation = image(s.map, s.core.points[0]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(s.dimension); ++k) map.columns[k] = s.radius * map.columns[k];
    return map;
  }

  /// As the shape sees the other before its pose.
  Relation axis_with(const PosedSet& round, const PosedSet& other) const {
    if (other.is_polygon() || other.is_round()) return axis_with_uneven(round, other);
    const Preimage part = preimage(round.map, image(other));
    return of_part(flat_with(part.set, *round.axis), part.of_inside);
  }
  Relation axis_with_uneven(const PosedSet& round, const PosedSet& other) const {
    if (is_singular(round.map)) refuse("a pose flattens the shape; give one whose matrix is not singular");
    const ExactMap seen = composed(inverse(round.map), other.map);
    if (other.is_polygon()) return relate_axis_shape(image(seen, other.chains), *round.axis);
    const auto scale = squared_scale(seen, 3);
    if (!scale) refuse("the ball is none as the shape sees it; ", ", or columns at right angles and of one length");
    return relate_axis_shape(image(seen, other.core.points[0]), other.radius * other.radius * *scale, *round.axis);
  }

  /// As the cap sees the other before its pose: a flat convex set or a ball.
  Relation cap_with(const PosedSet& s, const PosedSet& other) const {
    if (!other.is_round()) {
      const Preimage part = preimage(s.map, image(other));
      if (part.set.points.empty()) return Relation::disjoint;
      return of_part(relate_exact_cap(part.set, *s.cap), part.of_inside);
    }
    if (is_singular(s.map)) refuse("a pose flattens the cap; give one whose matrix is not singular");
    const ExactMap seen = composed(inverse(s.map), other.map);
    const auto scale = squared_scale(seen, 3);
    if (!scale) refuse("the ball is none as the cap sees it; ", ", or columns at right angles and of one length");
    return relate_exact_cap(image(seen, other.core.points[0]), other.radius * other.radius * *scale, *s.cap);
  }

  Relation flat_with(const FlatSet& s, const RoundAxis& shape) const {
    std::vector<Exact3> points = s.points, lines;
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.empty()) return Relation::disjoint;
    for (const Exact3& l : s.lines) {
      const bool is_new = lines.empty() || (lines.size() == 1 ? !is_zero(cross(lines[0], l))
                                                              : sgn(dot(cross(lines[0], lines[1]), l)) != 0);
      if (is_new && lines.size() < 3) lines.push_back(l);
    }
    const std::size_t ends = points.size(), ways = s.directions.size();
    if (lines.size() == 3) return Relation::overlapping;
    const auto vector = [&](const Exact3& v) {
      return arith::Vec<Rational>{exact_number(v[0]), exact_number(v[1]), exact_number(v[2])};
    };
    const auto line = [&](const Exact3& along, bool starts, bool stops) {
      return relate_exact_line(StraightAxis<Rational>{vector(points[0]), vector(along), starts, stops}, shape);
    };
    if (lines.empty() && ways == 0 && ends <= 2) return line(points.back() - points[0], true, true);
    if (lines.empty() && ways == 1 && ends == 1) return line(s.directions[0], true, false);
    if (lines.size() == 1 && ways == 0 && ends == 1) return line(lines[0], false, false);
    if (lines.size() == 2 && ways <= 1 && ends == 1) {
      Exact3 normal = cross(lines[0], lines[1]);
      if (ways == 1 && sgn(dot(normal, s.directions[0])) > 0) normal = mpq_class(-1) * normal;
      return relate_exact_plane({vector(normal), exact_number(dot(normal, points[0])), ways == 1}, shape);
    }
    return relate_axis_shape(s, shape);
  }

  std::string_view function_;
  std::array<std::string_view, 2> names_;
  PosedSet a_, b_;
};

/// Has the image points that are on no boundary?
bool has_inside(const PosedView& v) {
  const PosedSet s = posed_set(v);
  if (v.figure.dimension == 2 && is_flat_kind(v.figure.kind) && is_polygon(v.figure))
    return !is_singular(s.map) && normal_of(exact_chains("locate", v.figure)).has_value();
  if (is_singular(s.map) || s.is_empty()) return false;
  if (s.is_round() || s.has_axis() || s.cap != nullptr) return true;
  std::vector<Exact3> ways = s.core.directions;
  ways.insert(ways.end(), s.core.lines.begin(), s.core.lines.end());
  for (const Exact3& p : s.core.points) ways.push_back(p - s.core.points[0]);
  return rank_of(ways) == static_cast<std::size_t>(v.figure.dimension);
}

void require_ellipsoid(std::string_view function, std::string_view name, const Ellipsoid3& e) {
  const auto part = [&](std::string_view member) { return std::string(name).append(member); };
  require_finite_parts(function, {part(".center"), part(".axes[0]"), part(".axes[1]"), part(".axes[2]"), part(".half")},
                       e.center, e.axes[0], e.axes[1], e.axes[2], e.half);
}

std::optional<Relation> relate_posed_quickly(const PosedView& a, const PosedView& b) {
  if (!is_flat_kind(a.figure.kind) || !is_flat_kind(b.figure.kind)) return {};
  if (!has_axes(a.figure) || !has_axes(b.figure)) return {};
  return relate_by_axes(a, b);
}

}  // namespace

Relation relate_posed(std::string_view function, const PosedView& a, const PosedView& b) {
  if (const auto found = relate_posed_boxes(a, b)) return *found;
  if (function == name_of(Question::intersects)) {
    if (const auto meet = meet_by_search(a, b)) return *meet ? Relation::touching : Relation::disjoint;
  } else if (const auto found = relate_by_search(a, b)) {
    return *found;
  }
  require_posed(function, a, b);
  for (const PosedView* v : {&a, &b}) {
    if (with_figure(v->figure, [](const auto& s) { return is_nothing(s); })) return Relation::disjoint;
  }
  if (const auto quick = relate_posed_quickly(a, b)) return *quick;
  return PosedRelation(function, a, b)();
}

Location posed_locate(const PosedView& figure, const FigureView& point) {
  const Relation relation = relate_posed("locate", figure, {point});
  if (relation == Relation::disjoint) return Location::outside;
  return relation == Relation::overlapping && has_inside(figure) ? Location::inside : Location::boundary;
}

Relation relate_ellipsoid(std::string_view function, const Ellipsoid3& a, const PosedView& b) {
  require_ellipsoid(function, "ellipsoid", a);
  require_posed(function, spoken(b.figure), b);
  if (with_figure(b.figure, [](const auto& s) { return is_nothing(s); })) return Relation::disjoint;
  return PosedRelation(function, a, b)();
}
Relation relate_ellipsoid(std::string_view function, const Ellipsoid3& a, const Ellipsoid3& b) {
  require_ellipsoid(function, "a", a);
  require_ellipsoid(function, "b", b);
  return PosedRelation(function, a, b)();
}

}  // namespace plumb::query
