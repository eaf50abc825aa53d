#include "query/convex/features.hpp"

#include <algorithm>

#include "query/body/boundary.hpp"
#include "query/convex/exact_gap.hpp"

namespace plumb::query {
namespace {

constexpr Feature edge_at(std::size_t i) { return {FeatureKind::edge, static_cast<std::uint32_t>(i)}; }
constexpr Feature face_at(std::size_t i) { return {FeatureKind::face, static_cast<std::uint32_t>(i)}; }
constexpr Feature vertex{FeatureKind::vertex, 0}, the_one_face{FeatureKind::face, 0},
    interior{FeatureKind::interior, 0};

/// Where is what the numbers say?  Under a map that has no inverse, or as it stands.
class Place {
 public:
  explicit Place(const ExactMap* map) : map_(map) {}

  [[nodiscard]] Exact3 of(const Exact3& p) const { return map_ == nullptr ? p : image(*map_, p); }
  [[nodiscard]] Exact3 of(const Point2& p) const { return of(Exact3{p.x, p.y, 0}); }
  [[nodiscard]] Exact3 of(const Point3& p) const { return of(Exact3{p.x, p.y, p.z}); }
  [[nodiscard]] Exact3 of(const arith::Vec<mpq_class>& p) const { return of(Exact3{p.x, p.y, p.z}); }
  template <class Vector>
  [[nodiscard]] Exact3 way(const Vector& v) const {
    return map_ == nullptr ? exact_way(v) : turned(*map_, exact_way(v));
  }

  /// Is p on side i of what the halfspaces have in common, or in the image of that side?
  [[nodiscard]] bool has_side(const std::vector<ExactHalfspace>& all, std::size_t i, const Exact3& p) const {
    const auto& [normal, offset] = all[i];
    if (map_ == nullptr) return dot(normal, p) == offset;
    std::vector<ExactHalfspace> side = all;
    side.push_back({mpq_class(-1) * normal, -offset});
    const auto square = squared_distance(FlatSet{{p}, {}, {}}, image(*map_, flat_set(side)));
    return square && sgn(*square) == 0;
  }

 private:
  const ExactMap* map_;
};

/// Hears of the boundary of a figure: the first feature that holds p, else what p is in.
class Search {
 public:
  Search(const Exact3& p, const Place& place, const Feature& otherwise) : p_(p), place_(place), otherwise_(otherwise) {}

  void corner(const arith::Vec<mpq_class>& c) {
    corners_.push_back(place_.of(c));
    if (!found_ && corners_.back() == p_)
      found_ = {FeatureKind::vertex, static_cast<std::uint32_t>(corners_.size() - 1)};
  }
  void edge(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
    if (!found_ && hull_holds(corners_, std::array{from, to}, p_)) found_ = edge_at(number);
  }
  /// Of a solid; all of a flat figure is one.
  void face(std::span<const std::uint32_t> of, std::uint32_t number) {
    if (!found_ && otherwise_ == interior && hull_holds(corners_, of, p_)) found_ = face_at(number);
  }
  [[nodiscard]] Feature feature() const { return found_.value_or(otherwise_); }

 private:
  const Exact3& p_;
  const Place& place_;
  Feature otherwise_;
  std::vector<Exact3> corners_;
  std::optional<Feature> found_;
};

/// On which side of the figure; 0 for the face of the plane's sides.
Feature side(bool in_plane, std::size_t i) { return in_plane ? edge_at(i) : face_at(i); }

/// And the plane that figures of the plane are in.
std::vector<ExactHalfspace> in_its_space(std::vector<ExactHalfspace> sides, bool in_plane) {
  if (in_plane) sides.insert(sides.end(), {{{0, 0, 1}, 0}, {{0, 0, -1}, 0}});
  return sides;
}

template <class Shape>
Feature feature_on(const Shape& s, const Exact3& p, const Place& place) {
  constexpr FigureKind kind = figure_kind<Shape>;
  constexpr bool in_plane = figure_dimension<Shape> == 2;
  constexpr Feature inside = in_plane ? the_one_face : interior;
  if constexpr (kind == FigureKind::line) {
    return is_zero(place.way(s.direction)) ? vertex : edge_at(0);
  } else if constexpr (kind == FigureKind::ray) {
    return place.of(s.origin) == p ? vertex : edge_at(0);
  } else if constexpr (kind == FigureKind::plane) {
    return s.normal == Vector3{} ? interior : the_one_face;
  } else if constexpr (kind == FigureKind::three_point_plane) {
    const Exact3 u = place.of(s.b) - place.of(s.a), v = place.of(s.c) - place.of(s.a);
    return is_zero(u) && is_zero(v) ? vertex : is_zero(cross(u, v)) ? edge_at(0) : the_one_face;
  } else if constexpr (is_one_of(kind,
                                 {FigureKind::halfspace, FigureKind::k_dop, FigureKind::halfspace_intersection})) {
    const std::vector<ExactHalfspace> own = numbered_sides(s), all = in_its_space(own, in_plane);
    for (std::size_t i = 0; i < own.size(); ++i) {
      // A halfspace of no normal is all of space.
      if (kind != FigureKind::k_dop && is_zero(own[i].normal)) continue;
      if (place.has_side(all, i, p)) return side(in_plane, i);
    }
    return inside;
  } else if constexpr (has_boundary<Shape>) {
    constexpr bool is_straight = kind == FigureKind::segment || kind == FigureKind::capsule;
    constexpr bool is_solid =
        is_one_of(kind, {FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb, FigureKind::convex_polyhedron});
    Search search(p, place, is_straight ? edge_at(0) : is_solid ? inside : the_one_face);
    tell_boundary<mpq_class>(s, search);
    return search.feature();
  } else {
    return the_one_face;  // what is round about an axis
  }
}

}  // namespace

bool hull_holds(std::span<const Exact3> all, std::span<const std::uint32_t> of, const Exact3& p) {
  for (std::size_t k = 0; k < 3; ++k) {  // not where it is beyond all of them along an axis
    const auto is_below = [&](std::uint32_t i) { return all[i][k] < p[k]; };
    const auto is_above = [&](std::uint32_t i) { return all[i][k] > p[k]; };
    if (std::ranges::all_of(of, is_below) || std::ranges::all_of(of, is_above)) return false;
  }
  if (of.size() == 2) return is_zero(cross(all[of[1]] - all[of[0]], p - all[of[0]]));
  FlatSet hull;
  for (const std::uint32_t i : of) hull.points.push_back(all[i]);
  return sgn(*squared_distance(FlatSet{{p}, {}, {}}, hull)) == 0;
}

Feature on_surface(const FigureView& figure, const Feature& core) {
  if (!is_one_of(figure.kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge})) return core;
  std::uint32_t part = 0;
  if (figure.kind == FigureKind::capsule && core.kind == FeatureKind::vertex) part = 1 + core.index;
  if (figure.kind == FigureKind::lozenge && core.kind == FeatureKind::edge) part = 1 + core.index;
  if (figure.kind == FigureKind::lozenge && core.kind == FeatureKind::vertex) part = 5 + core.index;
  return side(figure.dimension == 2, part);
}

Feature feature_at(const FigureView& figure, const Exact3& point, bool is_inside, const ExactMap* map) {
  if (is_inside) return figure.dimension == 2 ? the_one_face : interior;
  const bool goes_back = map != nullptr && !is_singular(*map);
  const Exact3 p = goes_back ? image(inverse(*map), point) : point;
  const Place place(goes_back ? nullptr : map);
  return on_surface(figure, with_figure(figure, [&](const auto& s) { return feature_on(s, p, place); }));
}

}  // namespace plumb::query
