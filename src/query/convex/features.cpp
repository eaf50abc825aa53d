#include "query/convex/features.hpp"

#include <algorithm>

#include "plumb/certify/accepted.hpp"
#include "query/convex/chains.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"

namespace plumb::query {
namespace {

using Corners = std::vector<Exact3>;

constexpr Feature vertex_at(std::size_t i) { return {FeatureKind::vertex, static_cast<std::uint32_t>(i)}; }
constexpr Feature edge_at(std::size_t i) { return {FeatureKind::edge, static_cast<std::uint32_t>(i)}; }
constexpr Feature face_at(std::size_t i) { return {FeatureKind::face, static_cast<std::uint32_t>(i)}; }
constexpr Feature interior{FeatureKind::interior, 0}, the_one_face{FeatureKind::face, 0};

/// Is p in the hull?  Not where it is beyond all of its corners along an axis.
bool hull_holds(Corners corners, const Exact3& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto is_below = [&](const Exact3& c) { return c[k] < p[k]; };
    const auto is_above = [&](const Exact3& c) { return c[k] > p[k]; };
    if (std::ranges::all_of(corners, is_below) || std::ranges::all_of(corners, is_above)) return false;
  }
  return sgn(*squared_distance(FlatSet{{p}, {}, {}}, FlatSet{std::move(corners), {}, {}})) == 0;
}

/// The features of a solid in their order, as hulls of its corners; what p is in, where none of them holds it.
class Search {
 public:
  Search(const Corners& corners, const Exact3& p) : corners_(corners), p_(p) {
    for (std::size_t i = 0; i < corners.size() && !is_found_; ++i) {
      if (corners[i] == p) take(vertex_at(i));
    }
  }
  Search& see(Feature f, std::initializer_list<std::size_t> of) { return see(f, std::span(of.begin(), of.size())); }
  template <class Index>
  Search& see(Feature f, std::span<const Index> of) {
    if (is_found_) return *this;
    Corners hull;
    for (const Index i : of) hull.push_back(corners_[i]);
    if (hull_holds(std::move(hull), p_)) take(f);
    return *this;
  }
  [[nodiscard]] Feature otherwise(Feature inside) const { return is_found_ ? found_ : inside; }

 private:
  void take(const Feature& f) { found_ = f, is_found_ = true; }

  const Corners& corners_;
  const Exact3& p_;
  Feature found_{};
  bool is_found_ = false;
};

/// Bit i of a corner's number: at the upper end of axis i.
Corners box_corners(const Exact3& center, const std::array<Exact3, 3>& reach) {
  Corners corners;
  for (unsigned v = 0; v < 8; ++v) {
    Exact3 at = center;
    for (std::size_t i = 0; i < 3; ++i) at = (v >> i & 1) != 0 ? at + reach[i] : at - reach[i];
    corners.push_back(std::move(at));
  }
  return corners;
}

Feature feature_of_box(const Corners& corners, const Exact3& p) {
  Search search(corners, p);
  for (std::size_t e = 0; e < 12; ++e) {
    const std::size_t u = e / 4, v = u == 0 ? 1 : 0, w = 3 - u - v;
    const std::size_t from = (e & 1) << v | (e >> 1 & 1) << w;
    search.see(edge_at(e), {from, from | std::size_t{1} << u});
  }
  for (std::size_t f = 0; f < 6; ++f) {
    const std::size_t w = f / 2, u = w == 0 ? 1 : 0, v = 3 - u - w, from = (f & 1) << w;
    const std::size_t one = std::size_t{1} << u, other = std::size_t{1} << v;
    search.see(face_at(f), {from, from | one, from | other, from | one | other});
  }
  return search.otherwise(interior);
}

/// Corner + any of two ways: the vertices, edges and the face of a rectangle.
Feature feature_of_plate(const Exact3& corner, const Exact3& u, const Exact3& v, const Exact3& p) {
  const Corners corners{corner, corner + u, corner + v, corner + u + v};
  return Search(corners, p)
      .see(edge_at(0), {0, 1})
      .see(edge_at(1), {2, 3})
      .see(edge_at(2), {0, 2})
      .see(edge_at(3), {1, 3})
      .otherwise(the_one_face);
}

/// Where is what the numbers say?  Under a map that has no inverse, or as it stands.
class Place {
 public:
  explicit Place(const ExactMap* map) : map_(map) {}

  [[nodiscard]] Exact3 of(const Exact3& p) const { return map_ == nullptr ? p : image(*map_, p); }
  [[nodiscard]] Exact3 of(const Point2& p) const { return of(Exact3{p.x, p.y, 0}); }
  [[nodiscard]] Exact3 of(const Point3& p) const { return of(Exact3{p.x, p.y, p.z}); }
  [[nodiscard]] Exact3 way(const Exact3& v) const { return map_ == nullptr ? v : turned(*map_, v); }
  [[nodiscard]] Exact3 way(const Vector2& v) const { return way(Exact3{v.x, v.y, 0}); }
  [[nodiscard]] Exact3 way(const Vector3& v) const { return way(Exact3{v.x, v.y, v.z}); }

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

template <class Halfspace>
ExactHalfspace exact_side(const Halfspace& h) {
  return {Place(nullptr).way(h.normal), h.offset};
}
/// And the plane that figures of the plane are in.
template <int dimension>
std::vector<ExactHalfspace> in_its_space(std::vector<ExactHalfspace> sides) {
  if constexpr (dimension == 2) sides.insert(sides.end(), {{{0, 0, 1}, 0}, {{0, 0, -1}, 0}});
  return sides;
}

/// On which side of the figure, by whether p is on it; 0 for the face of the plane's sides.
Feature side(bool in_plane, std::size_t i) { return in_plane ? edge_at(i) : face_at(i); }

template <class Shape>
Feature feature_on(const Shape& s, const Exact3& p, const Place& place) {
  constexpr FigureKind kind = figure_kind<Shape>;
  constexpr bool in_plane = figure_dimension<Shape> == 2;
  constexpr Feature inside = in_plane ? the_one_face : interior;
  if constexpr (kind == FigureKind::point) {
    return vertex_at(0);
  } else if constexpr (kind == FigureKind::line) {
    return is_zero(place.way(s.direction)) ? vertex_at(0) : edge_at(0);
  } else if constexpr (kind == FigureKind::ray) {
    return place.of(s.origin) == p ? vertex_at(0) : edge_at(0);
  } else if constexpr (kind == FigureKind::plane) {
    return s.normal == Vector3{} ? interior : the_one_face;
  } else if constexpr (kind == FigureKind::three_point_plane) {
    const Exact3 u = place.of(s.b) - place.of(s.a), v = place.of(s.c) - place.of(s.a);
    return is_zero(u) && is_zero(v) ? vertex_at(0) : is_zero(cross(u, v)) ? edge_at(0) : the_one_face;
  } else if constexpr (kind == FigureKind::halfspace) {
    const bool is_all = s.normal == decltype(s.normal){};
    const auto all = in_its_space<figure_dimension<Shape>>({exact_side(s)});
    return !is_all && place.has_side(all, 0, p) ? side(in_plane, 0) : inside;
  } else if constexpr (kind == FigureKind::segment || kind == FigureKind::capsule) {
    return Search({place.of(s.a), place.of(s.b)}, p).otherwise(edge_at(0));
  } else if constexpr (kind == FigureKind::triangle) {
    const Corners corners{place.of(s.a), place.of(s.b), place.of(s.c)};
    return Search(corners, p)
        .see(edge_at(0), {0, 1})
        .see(edge_at(1), {1, 2})
        .see(edge_at(2), {2, 0})
        .otherwise(the_one_face);
  } else if constexpr (kind == FigureKind::tetrahedron) {
    const Corners corners{place.of(s.a), place.of(s.b), place.of(s.c), place.of(s.d)};
    Search search(corners, p);
    for (std::size_t i = 0, e = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) search.see(edge_at(e++), {i, j});
    }
    for (std::size_t i = 0; i < 4; ++i) search.see(face_at(i), {(i + 1) % 4, (i + 2) % 4, (i + 3) % 4});
    return search.otherwise(interior);
  } else if constexpr (kind == FigureKind::aabb || kind == FigureKind::obb || kind == FigureKind::rectangle) {
    std::array<Exact3, 3> reach{Exact3{0, 0, 0}, Exact3{0, 0, 0}, Exact3{0, 0, 0}};
    Exact3 center;
    if constexpr (kind == FigureKind::aabb) {
      const Place still(nullptr);
      const Exact3 min = still.of(s.min), max = still.of(s.max);
      center = place.of(mpq_class(1, 2) * (min + max));
      for (std::size_t i = 0; i < 3; ++i) {
        reach[i][i] = mpq_class(1, 2) * (max[i] - min[i]);
        reach[i] = place.way(reach[i]);
      }
    } else {
      center = place.of(s.center);
      const auto half = coordinates(s.half);
      for (std::size_t i = 0; i < half.size(); ++i) reach[i] = abs(mpq_class(half[i])) * place.way(s.axes[i]);
    }
    if constexpr (in_plane || kind == FigureKind::rectangle) {
      return feature_of_plate(center - reach[0] - reach[1], mpq_class(2) * reach[0], mpq_class(2) * reach[1], p);
    } else {
      return feature_of_box(box_corners(center, reach), p);
    }
  } else if constexpr (kind == FigureKind::lozenge) {
    return feature_of_plate(place.of(s.corner), place.way(s.edges[0]), place.way(s.edges[1]), p);
  } else if constexpr (kind == FigureKind::k_dop) {
    std::vector<ExactHalfspace> sides;
    for (std::size_t i = 0; i < s.min.size(); ++i) {
      const Exact3 normal = Place(nullptr).way(s.directions.all()[i]);
      sides.push_back({mpq_class(-1) * normal, -mpq_class(s.min[i])});
      sides.push_back({normal, s.max[i]});
    }
    const std::size_t count = sides.size();
    sides = in_its_space<figure_dimension<Shape>>(std::move(sides));
    for (std::size_t i = 0; i < count; ++i) {
      if (place.has_side(sides, i, p)) return side(in_plane, i);
    }
    return inside;
  } else if constexpr (kind == FigureKind::halfspace_intersection) {
    std::vector<ExactHalfspace> sides;
    for (const auto& h : s.halfspaces) sides.push_back(exact_side(h));
    sides = in_its_space<figure_dimension<Shape>>(std::move(sides));
    for (std::size_t i = 0; i < s.halfspaces.size(); ++i) {
      if (!is_zero(sides[i].normal) && place.has_side(sides, i, p)) return side(in_plane, i);
    }
    return inside;
  } else if constexpr (kind == FigureKind::convex_polyhedron) {
    const PolygonMesh& m = s.mesh;
    Corners corners;
    for (const Point3& v : m.vertices) corners.push_back(place.of(v));
    Search search(corners, p);
    for (std::uint32_t f = 0; f + 1 < m.first.size(); ++f) {
      for (std::uint32_t c = m.first[f]; c < m.first[f + 1]; ++c) {
        const std::uint32_t to = c + 1 == m.first[f + 1] ? m.first[f] : c + 1;
        // The lower number of the two that leave it is looked at first: faces come by number.
        search.see(edge_at(c), {m.corners[c], m.corners[to]});
      }
    }
    for (std::uint32_t f = 0; f + 1 < m.first.size(); ++f) {
      search.see(face_at(f),
                 std::span<const std::uint32_t>(m.corners).subspan(m.first[f], m.first[f + 1] - m.first[f]));
    }
    return search.otherwise(interior);
  } else if constexpr (is_one_of(kind, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon})) {
    SpannedChains chains = chains_of(view_of(s));
    for (Exact3& v : chains.vertices) v = place.of(v);
    Search search(chains.vertices, p);
    for (std::size_t i = 0; i < chains.vertices.size(); ++i) search.see(edge_at(i), {i, chains.next[i]});
    return search.otherwise(the_one_face);
  } else {
    return the_one_face;  // balls
  }
}

}  // namespace

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
