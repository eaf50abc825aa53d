#include "query/ray/posed_faces.hpp"

#include "query/convex/chains.hpp"
#include "query/convex/exact_gap.hpp"

namespace plumb::query {
namespace {

Exact3 exact_place(const Point2& p) { return {p.x, p.y, 0}; }
Exact3 exact_place(const Point3& p) { return {p.x, p.y, p.z}; }
Exact3 exact_way(const Vector2& v) { return {v.x, v.y, 0}; }
Exact3 exact_way(const Vector3& v) { return {v.x, v.y, v.z}; }
const Exact3 nowhere{0, 0, 0};

/// A plane that bounds a solid, out of which its normal points; or the plane of a flat figure.
struct ExactFace {
  Exact3 normal;
  mpq_class offset;
};
ExactFace face_through(const Exact3& p, const Exact3& normal) { return {normal, dot(normal, p)}; }
ExactFace face_of(const Exact3& a, const Exact3& b, const Exact3& c) { return face_through(a, cross(b - a, c - a)); }

/// In the order of their numbers, before the pose.
template <class Shape>
std::vector<ExactFace> faces_of_figure(const Shape& s) {
  constexpr FigureKind kind = figure_kind<Shape>;
  std::vector<ExactFace> faces;
  if constexpr (kind == FigureKind::plane || kind == FigureKind::halfspace) {
    faces.push_back({exact_way(s.normal), s.offset});
  } else if constexpr (kind == FigureKind::three_point_plane || kind == FigureKind::triangle) {
    faces.push_back(face_of(exact_place(s.a), exact_place(s.b), exact_place(s.c)));
  } else if constexpr (is_one_of(kind, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon})) {
    const SpannedChains chains = chains_of(view_of(s));
    if (chains.span.size() < 3) return {{nowhere, 0}};
    const auto at = [&](std::size_t i) -> const Exact3& { return chains.vertices[chains.span[i]]; };
    faces.push_back(face_of(at(0), at(1), at(2)));
  } else if constexpr (kind == FigureKind::rectangle) {
    const auto edge = [](double half, const Vector3& axis) {
      return mpq_class(2 * abs(mpq_class(half))) * exact_way(axis);
    };
    faces.push_back(face_through(exact_place(s.center), cross(edge(s.half.x, s.axes[0]), edge(s.half.y, s.axes[1]))));
  } else if constexpr (kind == FigureKind::tetrahedron) {
    const std::array<Exact3, 4> at{exact_place(s.a), exact_place(s.b), exact_place(s.c), exact_place(s.d)};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t p = i == 0 ? 1 : 0, q = i <= 1 ? 2 : 1, r = i == 3 ? 2 : 3;
      ExactFace face = face_of(at[p], at[q], at[r]);
      if (dot(face.normal, at[i]) > face.offset) face = {mpq_class(-1) * face.normal, -face.offset};
      faces.push_back(std::move(face));
    }
  } else if constexpr (kind == FigureKind::aabb) {
    const Exact3 min = exact_place(s.min), max = exact_place(s.max);
    for (std::size_t i = 0; i < 3; ++i) {
      Exact3 up = nowhere;
      up[i] = 1;
      faces.push_back({mpq_class(-1) * up, -min[i]});
      faces.push_back({up, max[i]});
    }
  } else if constexpr (kind == FigureKind::obb) {
    const std::array<Exact3, 3> a{exact_way(s.axes[0]), exact_way(s.axes[1]), exact_way(s.axes[2])};
    const std::array<double, 3> half{s.half.x, s.half.y, s.half.z};
    for (std::size_t i = 0; i < 3; ++i) {
      Exact3 up = cross(a[(i + 1) % 3], a[(i + 2) % 3]);
      if (dot(up, a[i]) < 0) up = mpq_class(-1) * up;
      const mpq_class middle = dot(up, exact_place(s.center)), reach = abs(mpq_class(half[i])) * dot(up, a[i]);
      faces.push_back({mpq_class(-1) * up, reach - middle});
      faces.push_back({up, middle + reach});
    }
  } else if constexpr (kind == FigureKind::k_dop) {
    for (std::size_t i = 0; i < s.min.size(); ++i) {
      const Exact3 up = exact_way(s.directions.all()[i]);
      faces.push_back({mpq_class(-1) * up, -mpq_class(s.min[i])});
      faces.push_back({up, s.max[i]});
    }
  } else if constexpr (kind == FigureKind::convex_polyhedron) {
    const PolygonMesh& m = s.mesh;
    for (std::uint32_t f = 0; f + 1 < m.first.size(); ++f) {
      const auto at = [&](std::uint32_t k) { return exact_place(m.vertices[m.corners[k]]); };
      const std::uint32_t from = m.first[f];
      std::uint32_t third = from + 2;
      while (third + 1 < m.first[f + 1] && is_zero(cross(at(from + 1) - at(from), at(third) - at(from)))) ++third;
      faces.push_back(face_of(at(from), at(from + 1), at(third)));
    }
  }
  return faces;
}

Exact3 by_cofactors(const ExactMap& map, const Exact3& normal) {
  const auto& [a, b, c] = map.columns;
  return normal[0] * cross(b, c) + normal[1] * cross(c, a) + normal[2] * cross(a, b);
}

bool is_mirroring(const ExactMap& map) { return sgn(dot(map.columns[0], cross(map.columns[1], map.columns[2]))) < 0; }

constexpr bool is_flat(FigureKind kind) {
  return is_one_of(kind,
                   {FigureKind::plane, FigureKind::three_point_plane, FigureKind::triangle, FigureKind::quadrilateral,
                    FigureKind::polygon, FigureKind::holed_polygon, FigureKind::rectangle});
}

Exact3 normal_of_faces(const std::vector<ExactFace>& faces, bool flat, const ExactMap& map, const Exact3& point,
                       const Exact3& along) {
  if (flat) return by_cofactors(map, faces[0].normal);
  const bool singular = is_singular(map);
  const Exact3 before = singular ? point : image(inverse(map), point);
  std::optional<Exact3> first;
  for (const auto& [normal, offset] : faces) {
    if (!singular && dot(normal, before) != offset) continue;
    Exact3 out = outward(map, normal);
    if (singular && is_zero(out)) continue;
    if (sgn(dot(out, along)) < 0) return out;
    if (!first) first = std::move(out);
  }
  return first.value_or(nowhere);
}

using ExactFacet = std::vector<Exact3>;

/// Of a tetrahedron or a box that has no inside as it is posed, in the order of their numbers.
template <class Shape>
std::vector<ExactFacet> facets_of_figure(const Shape& s) {
  constexpr FigureKind kind = figure_kind<Shape>;
  std::vector<ExactFacet> facets;
  if constexpr (kind == FigureKind::tetrahedron) {
    const std::array<Exact3, 4> at{exact_place(s.a), exact_place(s.b), exact_place(s.c), exact_place(s.d)};
    for (std::size_t i = 0; i < 4; ++i) facets.push_back({at[i == 0 ? 1 : 0], at[i <= 1 ? 2 : 1], at[i == 3 ? 2 : 3]});
  } else {
    Exact3 corner;
    std::array<Exact3, 3> width{nowhere, nowhere, nowhere};
    if constexpr (kind == FigureKind::aabb) {
      corner = exact_place(s.min);
      for (std::size_t i = 0; i < 3; ++i) width[i][i] = exact_place(s.max)[i] - corner[i];
    } else {
      const std::array<double, 3> half{s.half.x, s.half.y, s.half.z};
      corner = exact_place(s.center);
      for (std::size_t i = 0; i < 3; ++i) {
        width[i] = mpq_class(2 * abs(mpq_class(half[i]))) * exact_way(s.axes[i]);
        corner = corner - mpq_class(1, 2) * width[i];
      }
    }
    for (std::size_t f = 0; f < 6; ++f) {
      const std::size_t w = f / 2, u = w == 0 ? 1 : 0, v = 3 - u - w;
      const Exact3 from = f % 2 == 1 ? corner + width[w] : corner;
      facets.push_back({from, from + width[u], from + width[u] + width[v], from + width[v]});
    }
  }
  return facets;
}

/// Of the first that holds the point.
Exact3 normal_of_facets(const std::vector<ExactFacet>& facets, const ExactMap& map, const Exact3& point) {
  for (const ExactFacet& before : facets) {
    const FlatSet facet = image(map, FlatSet{before, {}, {}});
    if (sgn(*squared_distance(FlatSet{{point}, {}, {}}, facet)) != 0) continue;
    return cross(facet.points[1] - facet.points[0], facet.points.back() - facet.points[0]);
  }
  return nowhere;
}

template <class Shape>
bool has_no_inside(const Shape& s, const ExactMap& map) {
  constexpr FigureKind kind = figure_kind<Shape>;
  if constexpr (kind == FigureKind::tetrahedron) {
    const Exact3 a = exact_place(s.a), u = exact_place(s.b) - a, v = exact_place(s.c) - a;
    if (sgn(dot(exact_place(s.d) - a, cross(u, v))) == 0) return true;
  } else if constexpr (kind == FigureKind::obb) {
    if (sgn(dot(exact_way(s.axes[0]), cross(exact_way(s.axes[1]), exact_way(s.axes[2])))) == 0) return true;
  }
  return is_singular(map);
}

using ExactEdge = std::array<Exact3, 2>;
void add_around(std::vector<ExactEdge>& edges, const std::vector<Exact3>& vertices,
                const std::vector<std::size_t>& next) {
  for (std::size_t i = 0; i < vertices.size(); ++i) edges.push_back({vertices[i], vertices[next[i]]});
}

/// Of figures of the plane, in the order of their numbers, before the pose.
template <class Shape>
std::vector<ExactEdge> edges_of_figure(const Shape& s) {
  constexpr FigureKind kind = figure_kind<Shape>;
  std::vector<ExactEdge> edges;
  if constexpr (kind == FigureKind::segment) {
    edges.push_back({exact_place(s.a), exact_place(s.b)});
  } else if constexpr (kind == FigureKind::triangle) {
    add_around(edges, {exact_place(s.a), exact_place(s.b), exact_place(s.c)}, {1, 2, 0});
  } else if constexpr (is_one_of(kind, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon})) {
    const SpannedChains chains = chains_of(view_of(s));
    add_around(edges, chains.vertices, chains.next);
  } else if constexpr (kind == FigureKind::aabb || kind == FigureKind::obb) {
    Exact3 corner, u, v;
    if constexpr (kind == FigureKind::aabb) {
      corner = exact_place(s.min);
      const Exact3 width = exact_place(s.max) - corner;
      u = {width[0], 0, 0}, v = {0, width[1], 0};
    } else {
      u = mpq_class(2 * abs(mpq_class(s.half.x))) * exact_way(s.axes[0]);
      v = mpq_class(2 * abs(mpq_class(s.half.y))) * exact_way(s.axes[1]);
      corner = exact_place(s.center) - mpq_class(1, 2) * (u + v);
    }
    edges = {{corner, corner + u}, {corner + v, corner + u + v}, {corner, corner + v}, {corner + u, corner + u + v}};
  }
  return edges;
}

bool lies_on(const Exact3& p, const ExactEdge& e) {
  const Exact3 along = e[1] - e[0], off = p - e[0];
  const mpq_class share = dot(off, along);
  return is_zero(cross(off, along)) && sgn(share) >= 0 && share <= dot(along, along) &&
         (!is_zero(along) || is_zero(off));
}

/// Of the first that holds the point and that the ray does not run along, against the ray.
Exact3 normal_of_edges(const std::vector<ExactEdge>& edges, const ExactMap& map, const Exact3& point,
                       const Exact3& along) {
  for (const ExactEdge& before : edges) {
    const ExactEdge e{image(map, before[0]), image(map, before[1])};
    const Exact3 way = e[1] - e[0], across{way[1], -way[0], 0};
    const int faces = sgn(dot(across, along));
    if (faces != 0 && lies_on(point, e)) return mpq_class(-faces) * across;
  }
  return nowhere;
}

}  // namespace

Exact3 outward(const ExactMap& map, const Exact3& normal) {
  const Exact3 out = by_cofactors(map, normal);
  return is_mirroring(map) ? mpq_class(-1) * out : out;
}

Feature hit_feature(const FigureView& figure, const ExactMap& map, const Exact3& point) {
  const bool is_face = with_shape(figure, []<class Shape>(const Shape& s) {
    constexpr FigureKind kind = figure_kind<Shape>;
    if constexpr (kind == FigureKind::plane) return true;
    if constexpr (kind == FigureKind::halfspace) return s.normal == decltype(s.normal){} && s.offset == 0;
    return false;
  });
  return is_face ? Feature{FeatureKind::face, 0} : feature_at(figure, point, false, &map);
}

Exact3 normal_at(const FigureView& figure, const ExactMap& map, const Exact3& point, const Exact3& along) {
  return with_shape(figure, [&]<class Shape>(const Shape& s) -> Exact3 {
    if constexpr (figure_dimension<Shape> == 2 && figure_kind<Shape> != FigureKind::k_dop) {
      return normal_of_edges(edges_of_figure(s), map, point, along);
    } else {
      if constexpr (is_one_of(figure_kind<Shape>, {FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb})) {
        if (has_no_inside(s, map)) return normal_of_facets(facets_of_figure(s), map, point);
      }
      const auto faces = faces_of_figure(s);
      return faces.empty() ? nowhere : normal_of_faces(faces, is_flat(figure_kind<Shape>), map, point, along);
    }
  });
}

}  // namespace plumb::query
