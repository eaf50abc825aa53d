#include "plumb/query/convex/containment.hpp"

#include <algorithm>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/round_parts.hpp"
#include "query/convex/set.hpp"

namespace plumb::query {
namespace {

/// Is the root of c at most x?
bool root_is_at_most(const mpq_class& c, const mpq_class& x) { return sgn(x) >= 0 && c <= x * x; }

/// Does what is near to a place hold a point or a ball, of which the distance from there has this square?
// root(square) + reach <= radius: 2 root(square reach^2) <= radius^2 - square - reach^2.
bool core_holds(const mpq_class& square, const mpq_class& radius, const RoundPart& part,
                const mpq_class& squared_scale) {
  const mpq_class reach = part.radius * part.radius * squared_scale;
  return root_is_at_most(4 * square * reach, radius * radius - square - reach);
}

bool ball_holds(const Exact3& center, const mpq_class& radius, const RoundPart& part, const mpq_class& squared_scale) {
  const Exact3 w = part.at - center;
  const mpq_class square = dot(w, w);
  if (!part.is_disk) return core_holds(square, radius, part, squared_scale);
  // Its farthest point is off the axis by the center's distance from there, and the disk's radius.
  const Exact3 across = cross(w, part.axis);
  const mpq_class off = dot(across, across) / dot(part.axis, part.axis);
  const mpq_class reach = part.radius * part.radius * squared_scale;
  return root_is_at_most(4 * reach * off, radius * radius - square - reach);
}

}  // namespace

bool halfspace_holds(const ExactHalfspace& h, const RoundParts& inner) {
  const auto along = [&](const Exact3& d) { return sgn(dot(h.normal, d)); };
  if (std::ranges::any_of(inner.lines, [&](const Exact3& d) { return along(d) != 0; })) return false;
  if (std::ranges::any_of(inner.directions, [&](const Exact3& d) { return along(d) > 0; })) return false;
  return std::ranges::all_of(inner.parts, [&](const RoundPart& part) {
    const mpq_class slack = h.offset - dot(h.normal, part.at);
    if (sgn(part.radius) == 0) return sgn(slack) >= 0;
    mpq_class reach = part.radius * part.radius;  // the square of how far it goes along the normal
    if (part.is_disk) {
      const Exact3 across = cross(h.normal, part.axis);
      reach *= dot(across, across) / dot(part.axis, part.axis);
    } else {
      reach *= dot(h.normal, h.normal);
    }
    return root_is_at_most(reach, slack);
  });
}

std::optional<RoundBody> round_body(const FigureView& v) {
  return with_figure(v, [](const auto& s) -> std::optional<RoundBody> {
    if constexpr (requires { s.corner, s.radius; }) {
      return RoundBody{exact3(s.corner), exact3(s.edges[0]), exact3(s.edges[1]), s.radius, false};
    } else if constexpr (requires { s.center, s.radius; }) {
      return RoundBody{exact3(s.center), {}, {}, s.radius, false};
    } else if constexpr (requires { s.a, s.radius; }) {
      const Exact3 a = exact3(s.a), along = exact3(s.b) - a;
      const bool is_cylinder = std::is_same_v<std::remove_cvref_t<decltype(s)>, Cylinder3>;
      return RoundBody{a, along, {}, s.radius, is_cylinder && !is_zero(along)};
    } else {
      return std::nullopt;
    }
  });
}

bool holds_near_core(const RoundBody& round, const RoundPart& part, const mpq_class& squared_scale) {
  if (is_zero(round.along) && is_zero(round.second)) return ball_holds(round.at, round.radius, part, squared_scale);
  if (!round.has_ends) {
    const mpq_class square = squared_distance(part.at, round.at, round.along, round.second);
    return core_holds(square, round.radius, part, squared_scale);
  }
  const Exact3 across = cross(part.at - round.at, round.along);
  return core_holds(dot(across, across) / dot(round.along, round.along), round.radius, part, squared_scale);
}

namespace {

bool round_holds(const FigureView& outer, const RoundParts& inner) {
  if (!inner.directions.empty() || !inner.lines.empty()) return false;
  const std::optional<RoundBody> round = round_body(outer);
  return round && all_ends(*round, [&](const ExactHalfspace& end) { return halfspace_holds(end, inner); }) &&
         std::ranges::all_of(inner.parts, [&](const RoundPart& part) { return holds_near_core(*round, part); });
}

constexpr bool has_corners_as_given(FigureKind kind) {
  return is_one_of(
      kind, {FigureKind::segment, FigureKind::triangle, FigureKind::quadrilateral, FigureKind::polygon,
             FigureKind::holed_polygon, FigureKind::tetrahedron, FigureKind::aabb, FigureKind::convex_polyhedron});
}

template <class Shape>
bool holds_place(const Shape& s, const arith::Vec<double>& p) {
  if constexpr (figure_dimension<Shape> == 2) {
    return contains(s, Point2{p.x, p.y});
  } else {
    return contains(s, Point3{p.x, p.y, p.z});
  }
}
/// Of an inner figure whose corners are points as given, and the hull of them its own.
template <class Shape>
bool holds_corners(const Shape& s, const FigureView& inner) {
  return with_figure(inner, [&]<class Inner>(const Inner& of) {
    if constexpr (has_corners_as_given(figure_kind<Inner>) && figure_dimension<Inner> == figure_dimension<Shape>) {
      bool all = true;
      if (is_nothing(of)) return all;
      for_each_corner<double>(of, [&](const arith::Vec<double>& p) { all = all && holds_place(s, p); });
      return all;
    } else {
      return false;
    }
  });
}

}  // namespace

void require_convex_outer(const FigureView& outer) {
  if (outer.kind != FigureKind::polygon) return;
  const PolygonKind kind = with_figure(outer, [](const auto& s) {
    if constexpr (requires { convexity(s).kind; }) {
      return convexity(s).kind;
    } else {
      return PolygonKind::convex;
    }
  });
  if (kind == PolygonKind::not_planar) throw InvalidShape("contains: the outer polygon is not planar");
  if (kind == PolygonKind::concave || kind == PolygonKind::self_winding)
    throw InvalidShape("contains: the outer polygon is not convex; ask its convex pieces, or locate points in it");
}

bool holds(const FigureView& outer, const FigureView& inner) {
  require_figures("contains", outer, inner);
  require_convex_outer(outer);
  if (has_corners_as_given(inner.kind) && outer.kind != FigureKind::rectangle) {
    return with_figure(outer, [&]<class Shape>(const Shape& s) {
      if constexpr (may_be_outer(figure_kind<Shape>)) {
        return holds_corners(s, inner);
      } else {
        return false;
      }
    });
  }
  const RoundParts parts = round_parts(inner);
  if (parts.parts.empty()) return true;
  if (!is_flat_kind(outer.kind)) return round_holds(outer, parts);
  return std::ranges::all_of(meeting::halfspaces_of(outer),
                             [&](const ExactHalfspace& h) { return halfspace_holds(h, parts); });
}

}  // namespace plumb::query
