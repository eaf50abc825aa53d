// Who answers for two figures with straight edges: a quick way where the pair has one, what is exact of all sets for
// the rest.
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/flat_set.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/plane_extent.hpp"
#include "query/convex/search.hpp"
#include "query/convex/separating_axes.hpp"
#include "query/convex/slack_relation.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb::query {
namespace {

bool is_empty_box(const FlatView& v) {
  return with_shape(v, [](const auto& s) { return is_nothing(s); });
}

bool is_many_planes(const FlatView& v) {
  return is_one_of(v.kind, {FigureKind::k_dop, FigureKind::halfspace_intersection});
}
bool is_one_plane(const FlatView& v) { return is_one_of(v.kind, {FigureKind::plane, FigureKind::halfspace}); }

/// A point inside is in the relative interior; one on the boundary may be, of a figure without inside.
std::optional<Relation> relate_by_place(const FlatView& point, const FlatView& other) {
  const auto where = [&]<class Point>(const Point& p) {
    return with_shape(other, [&](const auto& s) -> std::optional<Location> {
      if constexpr (requires { plumb::locate(s, p); }) {
        return plumb::locate(s, p);
      } else {
        return {};  // points
      }
    });
  };
  const auto found = point.dimension == 2 ? where(*static_cast<const Point2*>(point.shape))
                                          : where(*static_cast<const Point3*>(point.shape));
  if (!found || *found == Location::boundary) return {};
  return static_cast<Relation>(*found);
}

std::optional<Relation> relate_figures(const FlatView& a, const FlatView& b) {
  if (is_empty_box(a) || is_empty_box(b)) return Relation::disjoint;
  if (is_many_planes(a)) return relate_by_slack(a, b);
  if (is_many_planes(b)) return relate_by_slack(b, a);
  if (is_one_plane(a)) return relate_by_extent(a, b);
  if (is_one_plane(b)) return relate_by_extent(b, a);
  if (has_axes(a) && has_axes(b)) return relate_by_axes({a}, {b});
  if (a.kind == FigureKind::convex_polyhedron || b.kind == FigureKind::convex_polyhedron) {
    return a.kind == FigureKind::convex_polyhedron ? relate_by_slack(a, b) : relate_by_slack(b, a);
  }
  return {};
}

std::optional<Relation> relate_quickly(const FlatView& a, const FlatView& b) {
  for (const auto& [p, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    if (p->kind != FigureKind::point) continue;
    if (const auto place = relate_by_place(*p, *other)) return place;
  }
  return relate_figures(a, b);
}

/// The search of convex pairs answers before the figures are looked through.  A point is located sooner.
bool is_searched(const FlatView& a, const FlatView& b) {
  const bool is_solid = a.kind == FigureKind::convex_polyhedron || b.kind == FigureKind::convex_polyhedron;
  return is_solid || (a.dimension == 3 && a.kind != FigureKind::point && b.kind != FigureKind::point);
}

}  // namespace

Relation relate_flat(const FlatView& a, const FlatView& b) {
  if (is_searched(a, b)) {
    if (const auto found = relate_by_search({a}, {b})) return *found;
  }
  require_figures("relate", a, b);
  if (is_polygon(a) || is_polygon(b)) return relate_polygon("relate", a, b);
  if (const auto quick = relate_quickly(a, b)) return *quick;
  return relate(flat_set(a), flat_set(b));
}

bool flat_intersects(const FlatView& a, const FlatView& b) {
  if (is_searched(a, b)) {
    if (const auto found = meet_by_search({a}, {b})) return *found;
  }
  require_figures("intersects", a, b);
  if (is_polygon(a) || is_polygon(b)) return relate_polygon("intersects", a, b) != Relation::disjoint;
  if (const auto quick = relate_quickly(a, b)) return *quick != Relation::disjoint;
  return intersects(flat_set(a), flat_set(b));
}

}  // namespace plumb::query
