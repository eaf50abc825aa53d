#include "query/convex/flat_set.hpp"

#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/axis_body.hpp"
#include "query/body/figure_input.hpp"

namespace plumb::query {
namespace {

const Exact3 along_z{0, 0, 1};

/// The points, and the edges that go on, of what has a body of them.
template <class Shape>
FlatSet set_of_body(const Shape& s) {
  // Points and directions as given are exact in doubles, and what they are not asked for costs little there.
  constexpr bool is_given =
      is_one_of(figure_kind<Shape>, {FigureKind::point, FigureKind::line, FigureKind::ray, FigureKind::segment,
                                     FigureKind::triangle, FigureKind::tetrahedron, FigureKind::aabb});
  using Number = std::conditional_t<is_given, double, mpq_class>;
  const auto as_exact = [](const arith::Vec<Number>& v) {
    return Exact3{mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
  };
  const auto body = axes::axis_body_of<Number>(s, {0, 0, 0});
  FlatSet set;
  set.points.reserve(body.point_count);
  for (std::size_t i = 0; i < body.point_count; ++i) set.points.push_back(as_exact(body.points[i]));
  for (std::size_t i = 0; i < body.edge_count; ++i) {
    if (body.ends[i] == axes::EdgeEnd::one) set.directions.push_back(as_exact(body.edges[i]));
    if (body.ends[i] == axes::EdgeEnd::both) set.lines.push_back(as_exact(body.edges[i]));
  }
  return set;
}

/// Two vectors that span the plane at right angles to v, which is not zero.
std::array<Exact3, 2> across(const Exact3& v) {
  const std::size_t k = sgn(v[0]) != 0 ? 0 : sgn(v[1]) != 0 ? 1 : 2;
  Exact3 unit{0, 0, 0};
  unit[(k + 1) % 3] = 1;
  const Exact3 u = cross(v, unit);
  return {u, cross(v, u)};
}

const Exact3 along_x{1, 0, 0}, along_y{0, 1, 0};

/// All on one side of a plane, or on it.
FlatSet side_of_plane(const Exact3& normal, const mpq_class& offset, bool on_it, bool in_plane) {
  FlatSet s{{{0, 0, 0}}, {}, {}};
  if (is_zero(normal)) {
    if (on_it ? sgn(offset) != 0 : sgn(offset) < 0) return {};
    s.lines = {along_x, along_y};
    if (!in_plane) s.lines.push_back(along_z);
    return s;
  }
  s.points[0] = mpq_class(offset / dot(normal, normal)) * normal;
  if (!on_it) s.directions.push_back(mpq_class(-1) * normal);
  if (in_plane) {
    s.lines.push_back(cross(normal, along_z));
  } else {
    for (Exact3& v : across(normal)) s.lines.push_back(std::move(v));
  }
  return s;
}

/// The corners that a face has, and the edges.
FlatSet set_of_polyhedron(const ConvexPolyhedron3& polyhedron) {
  const auto& [vertices, corners, first] = polyhedron.mesh;
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> index(vertices.size(), unused);
  FlatSet s;
  for (const std::uint32_t v : corners) {
    if (index[v] != unused) continue;
    index[v] = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back({vertices[v].x, vertices[v].y, vertices[v].z});
  }
  for (std::size_t f = 0; f + 1 < first.size(); ++f) {
    for (std::uint32_t k = first[f]; k < first[f + 1]; ++k) {
      const std::uint32_t from = corners[k], to = corners[k + 1 < first[f + 1] ? k + 1 : first[f]];
      if (from < to) s.edges.push_back({index[from], index[to]});  // the face beyond has it the other way round
    }
  }
  return s;
}

}  // namespace

mpq_class dot(const Exact3& u, const Exact3& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Exact3 cross(const Exact3& u, const Exact3& v) {
  return {mpq_class(u[1] * v[2] - u[2] * v[1]), mpq_class(u[2] * v[0] - u[0] * v[2]),
          mpq_class(u[0] * v[1] - u[1] * v[0])};
}
Exact3 operator+(const Exact3& u, const Exact3& v) {
  return {mpq_class(u[0] + v[0]), mpq_class(u[1] + v[1]), mpq_class(u[2] + v[2])};
}
Exact3 operator-(const Exact3& u, const Exact3& v) {
  return {mpq_class(u[0] - v[0]), mpq_class(u[1] - v[1]), mpq_class(u[2] - v[2])};
}
Exact3 operator*(const mpq_class& t, const Exact3& v) {
  return {mpq_class(t * v[0]), mpq_class(t * v[1]), mpq_class(t * v[2])};
}
bool is_zero(const Exact3& v) { return sgn(v[0]) == 0 && sgn(v[1]) == 0 && sgn(v[2]) == 0; }
std::size_t rank_of(const std::vector<Exact3>& vectors) {
  std::vector<Exact3> rows;
  for (const Exact3& v : vectors) {
    if (is_zero(v)) continue;
    if (rows.empty()) rows.push_back(v);
    if (rows.size() == 1 && !is_zero(cross(rows[0], v))) rows.push_back(v);
    if (rows.size() == 2 && sgn(dot(cross(rows[0], rows[1]), v)) != 0) return 3;
  }
  return rows.size();
}
Exact3 primitive(const Exact3& v) {
  if (is_zero(v)) return v;
  mpz_class multiple = 1, divisor = 0;
  for (const mpq_class& x : v) multiple = lcm(multiple, x.get_den());
  for (const mpq_class& x : v) divisor = gcd(divisor, mpz_class(x * multiple));
  return mpq_class(multiple, divisor) * v;
}

FlatSet flat_set(const FigureView& figure) {
  return with_figure(figure, []<class Shape>(const Shape& s) -> FlatSet {
    constexpr FigureKind kind = figure_kind<Shape>;
    constexpr bool in_plane = figure_dimension<Shape> == 2;
    if constexpr (kind == FigureKind::convex_polyhedron) {
      return set_of_polyhedron(s);
    } else if constexpr (kind == FigureKind::plane || kind == FigureKind::halfspace) {
      return side_of_plane(exact_way(s.normal), s.offset, kind == FigureKind::plane, in_plane);
    } else if constexpr (kind == FigureKind::k_dop || kind == FigureKind::halfspace_intersection) {
      std::vector<ExactHalfspace> sides = numbered_sides(s);
      if (in_plane) sides.insert(sides.end(), {{along_z, 0}, {mpq_class(-1) * along_z, 0}});
      return flat_set(sides);
    } else if constexpr (axes::has_body<Shape>) {
      return is_nothing(s) ? FlatSet{} : set_of_body(s);
    } else {
      return {};
    }
  });
}

}  // namespace plumb::query
