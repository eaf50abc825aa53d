#include "query/ray/posed_faces.hpp"

#include "query/body/boundary.hpp"
#include "query/convex/chains.hpp"

namespace plumb::query {
namespace {

const Exact3 nowhere{0, 0, 0};

/// What it hears of the boundary of a figure.
struct ExactBoundary {
  std::vector<Exact3> corners;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::vector<std::uint32_t>> faces;

  void corner(const arith::Vec<mpq_class>& p) { corners.push_back({p.x, p.y, p.z}); }
  void edge(std::uint32_t from, std::uint32_t to, std::uint32_t) { edges.push_back({from, to}); }
  void face(std::span<const std::uint32_t> of, std::uint32_t) { faces.emplace_back(of.begin(), of.end()); }
};
template <class Shape>
ExactBoundary boundary_of(const Shape& s) {
  ExactBoundary told;
  if constexpr (figure_kind<Shape> == FigureKind::three_point_plane) {
    tell_boundary<mpq_class>(Triangle3{s.a, s.b, s.c}, told);
  } else if constexpr (has_boundary<Shape>) {
    tell_boundary<mpq_class>(s, told);
  }
  return told;
}

/// Of corners that are not all on one line.
Exact3 normal_of(const std::vector<Exact3>& corners) {
  const std::vector<std::size_t> span = spanning(corners);
  if (span.size() < 3) return nowhere;
  return cross(corners[span[1]] - corners[0], corners[span[2]] - corners[0]);
}

/// A solid's planes in the order of their numbers, before the pose; the plane of a flat figure, whose offset no one
/// asks for.
template <class Shape>
std::vector<ExactHalfspace> faces_of(const Shape& s, const ExactBoundary& b) {
  constexpr FigureKind kind = figure_kind<Shape>;
  std::vector<ExactHalfspace> faces;
  const auto add = [&](const Exact3& normal, const Exact3& p) { faces.push_back({normal, dot(normal, p)}); };
  if constexpr (kind == FigureKind::plane) {
    faces.push_back({exact_way(s.normal), s.offset});
  } else if constexpr (kind == FigureKind::halfspace || kind == FigureKind::k_dop) {
    faces = numbered_sides(s);
  } else if constexpr (kind == FigureKind::aabb || kind == FigureKind::obb) {  // as long as the axes, not as the edges
    std::array<Exact3, 3> axes{Exact3{1, 0, 0}, Exact3{0, 1, 0}, Exact3{0, 0, 1}};
    if constexpr (kind == FigureKind::obb) {
      for (std::size_t i = 0; i < 3; ++i) axes[i] = exact_way(s.axes[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Exact3 across = cross(axes[(i + 1) % 3], axes[(i + 2) % 3]), back = mpq_class(-1) * across;
      const bool is_up = sgn(dot(across, axes[i])) > 0;
      add(is_up ? back : across, b.corners.front());
      add(is_up ? across : back, b.corners.back());
    }
  } else if constexpr (kind == FigureKind::tetrahedron || kind == FigureKind::convex_polyhedron) {
    for (std::size_t f = 0; f < b.faces.size(); ++f) {
      std::vector<Exact3> corners;
      for (const std::uint32_t i : b.faces[f]) corners.push_back(b.corners[i]);
      Exact3 out = normal_of(corners);
      if (kind == FigureKind::tetrahedron && sgn(dot(out, b.corners[f] - corners[0])) > 0) out = mpq_class(-1) * out;
      add(out, corners[0]);
    }
  } else if (!b.corners.empty()) {
    faces.push_back({normal_of(b.corners), 0});
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

Exact3 normal_of_faces(const std::vector<ExactHalfspace>& faces, bool flat, const ExactMap& map, const Exact3& point,
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

/// Of the first posed face that holds the point.
Exact3 normal_of_facets(const ExactBoundary& posed, const Exact3& point) {
  for (const auto& of : posed.faces) {
    if (!hull_holds(posed.corners, of, point)) continue;
    const Exact3& from = posed.corners[of[0]];
    return cross(posed.corners[of[1]] - from, posed.corners[of.back()] - from);
  }
  return nowhere;
}

/// Of a tetrahedron or a box.
template <class Shape>
bool has_no_inside(const Shape& s, const ExactBoundary& b, const ExactMap& map) {
  constexpr FigureKind kind = figure_kind<Shape>;
  if constexpr (kind != FigureKind::aabb) {
    std::array<Exact3, 3> ways;
    for (std::size_t i = 0; i < 3; ++i) {
      if constexpr (kind == FigureKind::tetrahedron) {
        ways[i] = b.corners[i + 1] - b.corners[0];
      } else {
        ways[i] = exact_way(s.axes[i]);
      }
    }
    if (sgn(dot(ways[0], cross(ways[1], ways[2]))) == 0) return true;
  }
  return is_singular(map);
}

/// Of the first posed edge that holds the point and that the ray does not run along, against the ray.
Exact3 normal_of_edges(const ExactBoundary& posed, const Exact3& point, const Exact3& along) {
  for (const auto& edge : posed.edges) {
    const Exact3 way = posed.corners[edge[1]] - posed.corners[edge[0]], across{way[1], -way[0], 0};
    const int faces = sgn(dot(across, along));
    if (faces != 0 && hull_holds(posed.corners, edge, point)) return mpq_class(-faces) * across;
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
    constexpr FigureKind kind = figure_kind<Shape>;
    ExactBoundary b = boundary_of(s);
    const auto posed = [&]() -> const ExactBoundary& {
      for (Exact3& corner : b.corners) corner = image(map, corner);
      return b;
    };
    if constexpr (figure_dimension<Shape> == 2 && kind != FigureKind::k_dop) {
      return normal_of_edges(posed(), point, along);
    } else {
      if constexpr (is_one_of(kind, {FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb})) {
        if (has_no_inside(s, b, map)) return normal_of_facets(posed(), point);
      }
      const auto faces = faces_of(s, b);
      return faces.empty() ? nowhere : normal_of_faces(faces, is_flat(kind), map, point, along);
    }
  });
}

}  // namespace plumb::query
