#include "query/overlap/polygon_relation.hpp"

#include <algorithm>
#include <optional>

#include "figure/basic/in_space.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "query/body/boundary.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/flat_set.hpp"
#include "query/overlap/polygon_apart.hpp"
#include "query/overlap/polygon_region.hpp"

namespace plumb::query {
namespace {

/// Nothing of other figures.
ExactChains chains_of_polygon(const FlatView& v) {
  ExactChains chains;
  with_shape(v, [&]<class Shape>(const Shape& s) {
    if constexpr (is_one_of(figure_kind<Shape>, polygon_kinds)) {
      boundary::for_each_chain(s, [&](const auto& chain) {
        chains.emplace_back();
        boundary::for_each_place(chain, [&](const auto& p) {
          const Point3 at = in_space(p);
          chains.back().push_back({at.x, at.y, at.z});
        });
      });
    }
  });
  return chains;
}

/// A region in the plane normal . x = offset, seen along the axis `dropped`.
struct PlaneRegion {
  Exact3 normal;
  mpq_class offset;
  std::size_t dropped = 2;
  Region region;

  [[nodiscard]] Exact2 seen(const Exact3& p) const { return {p[(dropped + 1) % 3], p[(dropped + 2) % 3]}; }
};

/// A figure as a region of a plane, or as convex pieces.
struct Parts {
  std::optional<PlaneRegion> region;
  std::vector<LinePiece> pieces;
};

PlaneRegion region_of(const ExactChains& chains, const Exact3& normal) {
  PlaneRegion r;
  r.normal = normal;
  r.offset = dot(r.normal, chains[0][0]);
  r.dropped = sgn(r.normal[2]) != 0 ? 2 : sgn(r.normal[0]) != 0 ? 0 : 1;
  for (const auto& chain : chains) {
    r.region.chains.emplace_back();
    for (const Exact3& p : chain) r.region.chains.back().push_back(r.seen(p));
  }
  return r;
}

Parts parts_of(const ExactChains& chains) {
  if (const auto normal = normal_of(chains)) return {region_of(chains, *normal), {}};
  return {{}, pieces_on_line(chains)};
}

/// The vertices, and the plane that they lie in; nothing of other figures.
struct PolygonInput {
  std::vector<Point3> all;
  PlaneOfPoints plane;

  [[nodiscard]] SpanOfPolygon span() const {
    if (plane.dimension < 2) return {};
    return std::array{all[plane.span[0]], all[plane.span[1]], all[plane.span[2]]};
  }
};
PolygonInput input_of(std::string_view function, const FlatView& v) {
  PolygonInput input;
  if (!is_polygon(v)) return input;
  with_shape(v, [&]<class Shape>(const Shape& s) {
    if constexpr (is_one_of(figure_kind<Shape>, polygon_kinds))
      for_each_corner<double>(s, [&](const arith::Vec<double>& p) { input.all.push_back({p.x, p.y, p.z}); });
  });
  input.plane = plane_of_points(input.all);
  require_planar(function, spoken(v), input.plane);
  return input;
}

/// For a polygon with area.
template <class Point>
Relation place_of(const FlatView& polygon, const Point& p) {
  return with_shape(polygon, [&](const auto& s) {
    if constexpr (requires { locate_in_plane(s, p); }) {
      return static_cast<Relation>(locate_in_plane(s, p));
    } else if constexpr (requires { plumb::locate(s, p); }) {
      return static_cast<Relation>(plumb::locate(s, p));
    } else {
      return Relation::disjoint;  // of another space
    }
  });
}
Relation relate_point(const FlatView& point, const FlatView& polygon) {
  return point.dimension == 2 ? place_of(polygon, *static_cast<const Point2*>(point.shape))
                              : place_of(polygon, *static_cast<const Point3*>(point.shape));
}

Parts parts_of(const FlatView& v) {
  if (!is_polygon(v)) return {{}, {{flat_set(v), true}}};
  return parts_of(chains_of_polygon(v));
}

/// A convex set of the plane by its generators.
struct FlatSet2 {
  std::vector<Exact2> points, directions, lines;
};

mpq_class dot2(const Exact2& u, const Exact2& v) { return u[0] * v[0] + u[1] * v[1]; }
Exact2 sum(const Exact2& u, const mpq_class& t, const Exact2& v) {
  return {mpq_class(u[0] + t * v[0]), mpq_class(u[1] + t * v[1])};
}

/// Leaves of the set what has normal . x <= most, which must not touch its boundary alone.
void cut(FlatSet2& s, const Exact2& normal, const mpq_class& most) {
  const auto crossing = std::ranges::find_if(s.lines, [&](const Exact2& l) { return sgn(dot2(normal, l)) != 0; });
  if (crossing != s.lines.end()) {
    const Exact2 line = *crossing;
    const mpq_class rise = dot2(normal, line);
    s.lines.erase(crossing);
    for (Exact2& p : s.points) p = sum(p, mpq_class((most - dot2(normal, p)) / rise), line);
    for (auto* vectors : {&s.directions, &s.lines}) {
      for (Exact2& d : *vectors) d = sum(d, mpq_class(-dot2(normal, d) / rise), line);
    }
    s.directions.push_back(sum({0, 0}, mpq_class(-sgn(rise)), line));
    return;
  }
  FlatSet2 kept;
  kept.lines = s.lines;
  std::vector<mpq_class> at, along;
  for (const Exact2& p : s.points) at.emplace_back(dot2(normal, p) - most);
  for (const Exact2& d : s.directions) along.emplace_back(dot2(normal, d));
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (sgn(at[i]) <= 0) kept.points.push_back(s.points[i]);
    for (std::size_t j = i + 1; j < at.size(); ++j) {
      if (sgn(at[i]) * sgn(at[j]) >= 0) continue;
      const mpq_class t = at[i] / (at[i] - at[j]);
      kept.points.push_back(sum(sum({0, 0}, mpq_class(1 - t), s.points[i]), t, s.points[j]));
    }
    for (std::size_t j = 0; j < along.size(); ++j) {
      if (sgn(at[i]) * sgn(along[j]) < 0)
        kept.points.push_back(sum(s.points[i], mpq_class(-at[i] / along[j]), s.directions[j]));
    }
  }
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (sgn(along[i]) <= 0) kept.directions.push_back(s.directions[i]);
    for (std::size_t j = i + 1; j < along.size(); ++j) {
      if (sgn(along[i]) * sgn(along[j]) < 0)
        kept.directions.push_back(sum(sum({0, 0}, abs(along[j]), s.directions[i]), abs(along[i]), s.directions[j]));
    }
  }
  s = std::move(kept);
  if (s.points.empty()) s = {};
}

/// What of it lies in a box that holds the region inside of it: bounded, and the same to the region.
std::vector<Exact2> near(const Region& region, FlatSet2 s) {
  s.points = convex_hull(std::move(s.points));
  for (std::size_t k = 0; k < 2 && !(s.directions.empty() && s.lines.empty()); ++k) {
    mpq_class least = region.chains[0][0][k], most = least;
    for (const auto& chain : region.chains) {
      for (const Exact2& p : chain) {
        if (p[k] < least) least = p[k];
        if (p[k] > most) most = p[k];
      }
    }
    const mpq_class margin = most - least + 1;
    Exact2 normal{0, 0};
    normal[k] = 1;
    cut(s, normal, most + margin);
    normal[k] = -1;
    cut(s, normal, margin - least);
  }
  return convex_hull(std::move(s.points));
}

Relation of_boundary(Relation r, bool has_inside) {
  return r == Relation::overlapping && !has_inside ? Relation::touching : r;
}

Relation relate(const PlaneRegion& r, const LinePiece& piece) {
  const PlaneSection part = section(piece.set, r.normal, r.offset);
  FlatSet2 flat;
  for (const Exact3& p : part.set.points) flat.points.push_back(r.seen(p));
  for (const Exact3& d : part.set.directions) flat.directions.push_back(r.seen(d));
  for (const Exact3& l : part.set.lines) flat.lines.push_back(r.seen(l));
  if (flat.points.empty()) return Relation::disjoint;
  const std::vector<Exact2> set = near(r.region, std::move(flat));
  if (set.empty()) return Relation::disjoint;
  const Relation relation =
      set.size() < 3 ? relate_segment(r.region, set.front(), set.back()) : query::relate(r.region, Region{{set}});
  return of_boundary(relation, part.of_inside && piece.has_inside);
}

/// In planes that meet in a line: where the chains cross it, and between.
Relation relate_on_line(const PlaneRegion& a, const PlaneRegion& b, const Exact3& d) {
  const Exact3 from = mpq_class(1 / dot(d, d)) * (a.offset * cross(b.normal, d) + b.offset * cross(d, a.normal));
  std::vector<mpq_class> places = crossings(a.region, a.seen(from), a.seen(d));
  const std::vector<mpq_class> others = crossings(b.region, b.seen(from), b.seen(d));
  if (places.empty() || others.empty()) return Relation::disjoint;
  places.insert(places.end(), others.begin(), others.end());
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  bool meet = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto where = [&](const mpq_class& t) {
      const Exact3 p = from + t * d;
      return std::min(locate(a.region, a.seen(p)), locate(b.region, b.seen(p)));
    };
    const Location here = where(places[i]);
    const Location next = i + 1 < places.size() ? where(mpq_class((places[i] + places[i + 1]) / 2)) : here;
    if (here == Location::inside || next == Location::inside) return Relation::overlapping;
    meet = meet || here != Location::outside || next != Location::outside;
  }
  return meet ? Relation::touching : Relation::disjoint;
}

Relation relate(const PlaneRegion& a, const PlaneRegion& b) {
  const Exact3 d = cross(a.normal, b.normal);
  if (!is_zero(d)) return relate_on_line(a, b, d);
  const std::size_t k = a.dropped;
  if (a.offset * b.normal[k] != b.offset * a.normal[k]) return Relation::disjoint;
  return query::relate(a.region, b.region);  // dropped is the same axis: that of the first part that is not zero
}

Relation relate(const LinePiece& a, const LinePiece& b) {
  return of_boundary(query::relate(a.set, b.set), a.has_inside && b.has_inside);
}

template <class Part>
Relation relate_to_pieces(const Part& part, const std::vector<LinePiece>& pieces) {
  Relation most = Relation::disjoint;
  for (const LinePiece& piece : pieces) most = std::max(most, relate(part, piece));
  return most;
}

Relation relate(const Parts& p, const Parts& q) {
  if (p.region && q.region) return relate(*p.region, *q.region);
  if (p.region) return relate_to_pieces(*p.region, q.pieces);
  if (q.region) return relate_to_pieces(*q.region, p.pieces);
  Relation most = Relation::disjoint;
  for (const LinePiece& piece : p.pieces) most = std::max(most, relate_to_pieces(piece, q.pieces));
  return most;
}

}  // namespace

Relation relate_polygon(std::string_view function, const FlatView& a, const FlatView& b) {
  const PolygonInput of_a = input_of(function, a), of_b = input_of(function, b);
  if (a.kind == FigureKind::point && of_b.span()) return relate_point(a, b);
  if (b.kind == FigureKind::point && of_a.span()) return relate_point(b, a);
  if (is_polygon(a) && are_surely_apart(a, of_a.span(), b)) return Relation::disjoint;
  if (is_polygon(b) && are_surely_apart(b, of_b.span(), a)) return Relation::disjoint;
  return relate(parts_of(a), parts_of(b));
}

Relation relate_chains(const ExactChains& a, const ExactChains& b) { return relate(parts_of(a), parts_of(b)); }
Relation relate_chains(const ExactChains& a, const FlatSet& b, bool of_inside) {
  return relate(parts_of(a), Parts{{}, {{b, of_inside}}});
}

ExactChains exact_chains(std::string_view function, const FlatView& polygon) {
  static_cast<void>(input_of(function, polygon));  // throws where they do not
  return chains_of_polygon(polygon);
}

Relation relate_convex(std::string_view function, const FlatView& polygon, const FlatSet& other) {
  const Parts p = parts_of(exact_chains(function, polygon));
  const LinePiece piece{other, true};
  return p.region ? relate(*p.region, piece) : relate_to_pieces(piece, p.pieces);
}

}  // namespace plumb::query
