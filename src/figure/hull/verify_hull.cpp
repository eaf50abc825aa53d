// The steps of the proof; why they suffice is said in docs/hulls.md.
#include "plumb/figure/hull/verify_hull.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "figure/hull/hull3_proof.hpp"
#include "plumb/figure/hull/hull2.hpp"

namespace plumb {
namespace {

using namespace figure::hull3;

auto place_in_order(const Point3& p) { return std::tuple(p.x, p.y, p.z); }

/// Which vertex stands for a point?
class Names {
 public:
  Names(const Hull3& hull, std::span<const Point3> points) : points_(points), order_(hull.vertices) {
    std::ranges::sort(order_, {}, [&](Index v) { return place_in_order(points[v]); });
    const auto same = std::ranges::adjacent_find(order_, {}, [&](Index v) { return points[v]; });
    require(same == order_.end(), "two vertices are the same point, and one is ", same == order_.end() ? 0 : *same);
  }
  /// The vertex at the place of point i; there must be one if it is needed, and none of a larger index than i.
  bool check(Index i, bool needed) const {
    const auto found = std::ranges::lower_bound(order_, place_in_order(points_[i]), {},
                                                [&](Index v) { return place_in_order(points_[v]); });
    const bool named = found != order_.end() && points_[*found] == points_[i];
    require(named || !needed, "point ", i, " is on the boundary and no vertex stands for it");
    require(!named || *found <= i, "vertex ", named ? *found : 0, " equals point ", i, ", whose index is smaller");
    return named;
  }

 private:
  std::span<const Point3> points_;
  std::vector<Index> order_;
};

void prove_on_line(const Hull3& hull, std::span<const Point3> points, const HullOptions& options) {
  require(hull.face_count() == 0, "it has faces, and the points lie on a line");
  const Names names(hull, points);
  const std::size_t ends = hull.dimension == 0 ? 1 : 2;
  require(options.all_boundary_points || hull.vertices.size() == ends, "it has ", hull.vertices.size(),
          " vertices, and the points lie on a line");
  for (Index i = 0; i < points.size(); ++i) {
    names.check(i, options.all_boundary_points);
    require(options.all_boundary_points ||
                are_ordered_along_line(points[hull.vertices.front()], points[i], points[hull.vertices.back()]),
            "point ", i, " lies outside");
  }
}

void prove_in_plane(const Checked& checked, const std::array<std::size_t, 3>& span) {
  const auto& [hull, points, options] = std::tie(checked.hull, checked.points, checked.options);
  const Look look = look_at_plane(points[span[0]], points[span[1]], points[span[2]]);
  require(options.triangulate || hull.face_count() == 1, "it has ", hull.face_count(),
          " faces, and the points lie in a plane");
  const Sheet sheet(checked, look, Sign::positive);
  for (Index f = 0; f < hull.face_count(); ++f) require(sheet.holds(f), "face ", f, " is clockwise");
  std::vector<Point2> seen;
  for (const Point3& p : points) seen.push_back(projected(look, p));
  Hull2 rim{2, {}};
  for (const Index c : sheet.rim()) rim.vertices.push_back(hull.corners[c]);
  const auto place = [&](Index v) { return std::tuple(seen[v].x, seen[v].y); };
  std::rotate(rim.vertices.begin(), std::ranges::min_element(rim.vertices, {}, place), rim.vertices.end());
  require(static_cast<bool>(verify_hull(rim, seen, {.all_boundary_points = options.all_boundary_points})),
          "its outline is not that of the points");
  const Names names(hull, points);
  for (Index i = 0; i < points.size(); ++i) names.check(i, options.all_boundary_points);
  require(options.all_boundary_points || hull.vertices.size() == rim.vertices.size(), "a vertex is not extreme");
}

/// Convex at every ridge, and Euler's formula; notes what is flat.
void check_ridges(Checked& checked) {
  const Hull3& hull = checked.hull;
  for (Index c = 0; c < checked.twin.size(); ++c) {
    const Index twin = checked.twin[c];
    if (twin < c) continue;
    const Index f = checked.face_of[c], g = checked.face_of[twin];
    bool flat = true;
    for (const Index v : checked.spanned[g]) {
      const Sign s = checked.side(f, checked.points[v]);
      require(s != Sign::negative, "not convex at the ridge of faces ", f, " and ", g);
      flat = flat && s == Sign::zero;
    }
    require(!flat || checked.options.triangulate, "faces ", f, " and ", g, " are coplanar");
    checked.flat[c] = checked.flat[twin] = flat ? 1 : 0;
  }
  std::vector<Index> ridges(checked.points.size(), 0);
  std::vector<unsigned char> is_corner(checked.points.size(), 0);
  std::size_t corners = 0;
  for (Index c = 0; c < checked.twin.size(); ++c) {
    const Index v = hull.corners[c];
    corners += is_corner[v] == 0 ? 1 : 0;
    is_corner[v] = 1;
    ridges[v] += checked.flat[c] == 0 ? 1 : 0;
  }
  require(corners + hull.face_count() == hull.corners.size() / 2 + 2, "Euler's formula does not hold: ", corners,
          " corners, ", hull.corners.size() / 2, " edges, ", hull.face_count(), " faces");
  for (const Index v : hull.vertices) {
    require(checked.options.all_boundary_points || ridges[v] >= 3, "vertex ", v, " is not extreme");
  }
}

/// The vertical faces stand on the rim, and face outward.
void check_walls(const Checked& checked, const Sheet& upper, const Sheet& lower) {
  std::vector<Point2> rim;
  for (const Index c : upper.rim()) rim.push_back(projected(Look::along_z, checked.at(c)));
  const auto place = [](const Point2& p) { return std::pair(p.x, p.y); };
  std::rotate(rim.begin(), std::ranges::min_element(rim, {}, place), rim.end());
  const auto last = std::ranges::max_element(rim, {}, place);
  std::array<std::vector<Point2>, 2> chains{std::vector<Point2>(rim.begin(), last + 1),
                                            std::vector<Point2>(last, rim.end())};
  chains[1].push_back(rim.front());
  std::ranges::reverse(chains[1]);
  Index above = 0;
  while (!upper.holds(above)) ++above;
  for (Index f = 0; f < checked.hull.face_count(); ++f) {
    if (upper.holds(f) || lower.holds(f)) continue;
    std::array<Point2, 3> foot;
    for (std::size_t k = 0; k < 3; ++k) {
      foot[k] = projected(Look::along_z, checked.points[checked.spanned[f][k]]);
      const Sign s = checked.side(f, checked.points[checked.spanned[above][k]]);
      require(s != Sign::negative, "face ", f, " is not outside");
    }
    std::ranges::sort(foot, {}, place);
    const bool stands = std::ranges::any_of(chains, [&](const std::vector<Point2>& chain) {
      const auto found = std::ranges::upper_bound(chain, place(foot[0]), {}, place);
      if (found == chain.begin() || found == chain.end()) return false;
      return std::ranges::all_of(foot, [&](const Point2& p) {
        return sign_of(predicates::Orient2d{}, *(found - 1), *found, p) == Sign::zero;
      });
    });
    require(stands, "face ", f, " is not outside");
  }
}

void prove_in_space(Checked& checked) {
  check_ridges(checked);
  Sheet upper(checked, Look::along_z, Sign::positive), lower(checked, Look::along_z, Sign::negative);
  check_walls(checked, upper, lower);
  const auto below_first = [&](Index v) { return checked.side(0, checked.points[v]) == Sign::positive; };
  require(std::ranges::any_of(checked.hull.vertices, below_first), "the points lie in a plane");
  const Names names(checked.hull, checked.points);
  std::vector<unsigned char> kind(checked.points.size(), 0);  // 1: vertex, 2: corner
  for (const Index v : checked.hull.vertices) kind[v] = 1;
  for (const Index c : checked.hull.corners) kind[c] = 2;
  for (Index i = 0; i < checked.points.size(); ++i) {
    const Point3& p = checked.points[i];
    const Sheet::Place up = upper.place(p, i), down = lower.place(p, i);
    const Sign below = checked.side(up.face, p), over = checked.side(down.face, p);
    require(below != Sign::negative, "point ", i, " is above face ", up.face);
    require(over != Sign::negative, "point ", i, " is above face ", down.face);
    const bool on_up = below == Sign::zero, on_down = over == Sign::zero;
    const bool on_boundary = on_up || on_down || up.on_rim;
    require(on_boundary || kind[i] == 0, "vertex ", i, " is not on the boundary");
    if (!on_boundary) continue;
    names.check(i, checked.options.all_boundary_points);
    const bool on_edge = (on_up && up.on_edge) || (on_down && down.on_edge) || (up.on_rim && up.at_turn);
    require(kind[i] != 1 || !on_edge, "vertex ", i, " is on an edge and no corner");
  }
}

void prove(const Hull3& hull, std::span<const Point3> points, const HullOptions& options) {
  require(hull.dimension >= -1 && hull.dimension <= 3, "there is no dimension ", hull.dimension);
  require(points.empty() == (hull.dimension == -1), "the dimension is ", hull.dimension, " for ", points.size(),
          " points");
  Checked checked(hull, points, options);
  if (points.empty()) return require(hull == Hull3{}, "there are no points");
  if (hull.dimension == 3) return prove_in_space(checked);
  const PlaneOfPoints plane = plane_of_points(points);
  require(plane.dimension == hull.dimension, "the dimension is ", plane.dimension, ", not ", hull.dimension);
  hull.dimension == 2 ? prove_in_plane(checked, plane.span) : prove_on_line(hull, points, options);
}

}  // namespace

HullVerdict verify_hull(const Hull3& hull, std::span<const Point3> points, const HullOptions& options) {
  figure::require_finite_points("verify_hull", "points", points);
  try {
    prove(hull, points, options);
    return {};
  } catch (const Flaw& flaw) {
    return {flaw.text};
  }
}

}  // namespace plumb
