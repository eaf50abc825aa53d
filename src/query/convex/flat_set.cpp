#include "query/convex/flat_set.hpp"

#include <algorithm>

#include "query/body/axis_body.hpp"

namespace plumb::query {
namespace {

Exact3 exact(double x, double y, double z) { return {mpq_class(x), mpq_class(y), mpq_class(z)}; }
Exact3 exact(const Point3& p) { return exact(p.x, p.y, p.z); }
Exact3 exact(const Vector2& v) { return exact(v.x, v.y, 0); }
Exact3 exact(const Vector3& v) { return exact(v.x, v.y, v.z); }

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

/// Between normal . x = least and most; without `least` a halfspace, where both are equal a plane.
FlatSet between(const Exact3& normal, const mpq_class* least, const mpq_class& most, bool in_plane) {
  if (least != nullptr && *least > most) return {};
  const FlatSet everywhere = in_plane ? FlatSet{{exact(0, 0, 0)}, {}, {exact(1, 0, 0), exact(0, 1, 0)}}
                                      : FlatSet{{exact(0, 0, 0)}, {}, {exact(1, 0, 0), exact(0, 1, 0), exact(0, 0, 1)}};
  if (is_zero(normal)) return sgn(most) >= 0 && (least == nullptr || sgn(*least) <= 0) ? everywhere : FlatSet{};
  FlatSet s;
  const mpq_class square = dot(normal, normal);
  s.points.push_back(mpq_class(most / square) * normal);
  if (least == nullptr) {
    s.directions.push_back(mpq_class(-1) * normal);
  } else if (*least != most) {
    s.points.push_back(mpq_class(*least / square) * normal);
  }
  if (in_plane) {
    s.lines.push_back(cross(normal, along_z));
  } else {
    for (Exact3& v : across(normal)) s.lines.push_back(std::move(v));
  }
  return s;
}

FlatSet corners_of(const Exact3& min, const Exact3& max) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (min[k] > max[k]) return {};
  }
  FlatSet s;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Exact3 p = min;
    bool again = false;  // a corner that has been named, of a flat box
    for (std::size_t k = 0; k < 3; ++k) {
      if ((corner >> k & 1) == 0) continue;
      again = again || min[k] == max[k];
      p[k] = max[k];
    }
    if (!again) s.points.push_back(p);
  }
  return s;
}

template <class Vector>
void add(std::vector<ExactHalfspace>& all, const Vector& normal, double offset) {
  all.push_back({exact(normal), mpq_class(offset)});
}
void add_plane_of_2d(std::vector<ExactHalfspace>& all) {
  all.push_back({along_z, 0});
  all.push_back({exact(0, 0, -1), 0});
}

template <class Vector>
std::vector<ExactHalfspace> halfspaces(const KDop<Vector>& k_dop) {
  std::vector<ExactHalfspace> all;
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    const Exact3 d = exact(k_dop.directions.all()[i]);
    all.push_back({d, mpq_class(k_dop.max[i])});
    all.push_back({mpq_class(-1) * d, mpq_class(-k_dop.min[i])});
  }
  return all;
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
Exact3 primitive(const Exact3& v) {
  if (is_zero(v)) return v;
  mpz_class multiple = 1, divisor = 0;
  for (const mpq_class& x : v) multiple = lcm(multiple, x.get_den());
  for (const mpq_class& x : v) divisor = gcd(divisor, mpz_class(x * multiple));
  return mpq_class(multiple, divisor) * v;
}

FlatSet flat_set(const Point2& s) { return set_of_body(s); }
FlatSet flat_set(const Point3& s) { return set_of_body(s); }
FlatSet flat_set(const Line2& s) { return set_of_body(s); }
FlatSet flat_set(const Line3& s) { return set_of_body(s); }
FlatSet flat_set(const Ray2& s) { return set_of_body(s); }
FlatSet flat_set(const Ray3& s) { return set_of_body(s); }
FlatSet flat_set(const Segment2& s) { return set_of_body(s); }
FlatSet flat_set(const Segment3& s) { return set_of_body(s); }
FlatSet flat_set(const Triangle2& s) { return set_of_body(s); }
FlatSet flat_set(const Triangle3& s) { return set_of_body(s); }
FlatSet flat_set(const Tetrahedron3& s) { return set_of_body(s); }
FlatSet flat_set(const ThreePointPlane3& s) { return set_of_body(s); }
FlatSet flat_set(const Obb2& s) { return set_of_body(s); }
FlatSet flat_set(const Obb3& s) { return set_of_body(s); }
FlatSet flat_set(const Rectangle3& s) { return set_of_body(s); }
FlatSet flat_set(const Aabb2& box) { return is_empty(box) ? FlatSet{} : set_of_body(box); }
FlatSet flat_set(const Aabb3& box) { return is_empty(box) ? FlatSet{} : set_of_body(box); }

FlatSet flat_set(const Plane3& plane) {
  const mpq_class offset(plane.offset);
  return between(exact(plane.normal), &offset, offset, false);
}
FlatSet flat_set(const Halfspace2& h) { return between(exact(h.normal), nullptr, mpq_class(h.offset), true); }
FlatSet flat_set(const Halfspace3& h) { return between(exact(h.normal), nullptr, mpq_class(h.offset), false); }
FlatSet flat_set(const Slab2& s) {
  const mpq_class min(s.min);
  return between(exact(s.normal), &min, mpq_class(s.max), true);
}
FlatSet flat_set(const Slab3& s) {
  const mpq_class min(s.min);
  return between(exact(s.normal), &min, mpq_class(s.max), false);
}
FlatSet flat_set(const HalfspaceIntersection2& intersection) {
  std::vector<ExactHalfspace> all;
  add_plane_of_2d(all);
  for (const Halfspace2& h : intersection.halfspaces) add(all, h.normal, h.offset);
  return flat_set(all);
}
FlatSet flat_set(const HalfspaceIntersection3& intersection) {
  std::vector<ExactHalfspace> all;
  for (const Halfspace3& h : intersection.halfspaces) add(all, h.normal, h.offset);
  return flat_set(all);
}

FlatSet flat_set(const AabbWidths3& box) {
  const Exact3 min = exact(box.min);
  const Exact3 widths{abs(mpq_class(box.widths.x)), abs(mpq_class(box.widths.y)), abs(mpq_class(box.widths.z))};
  return corners_of(min, min + widths);
}
FlatSet flat_set(const AabbCenter3& box) {
  const Exact3 half{abs(mpq_class(box.half.x)), abs(mpq_class(box.half.y)), abs(mpq_class(box.half.z))};
  return corners_of(exact(box.center) - half, exact(box.center) + half);
}
FlatSet flat_set(const KDop2& k_dop) {
  auto all = halfspaces(k_dop);
  add_plane_of_2d(all);
  return flat_set(all);
}
FlatSet flat_set(const KDop3& k_dop) { return flat_set(halfspaces(k_dop)); }

FlatSet flat_set(const ConvexPolyhedron3& polyhedron) {
  const auto& [vertices, corners, first] = polyhedron.mesh;
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> index(vertices.size(), unused);
  FlatSet s;
  for (const std::uint32_t v : corners) {
    if (index[v] != unused) continue;
    index[v] = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back(exact(vertices[v]));
  }
  for (std::size_t f = 0; f + 1 < first.size(); ++f) {
    for (std::uint32_t k = first[f]; k < first[f + 1]; ++k) {
      const std::uint32_t from = corners[k], to = corners[k + 1 < first[f + 1] ? k + 1 : first[f]];
      if (from < to) s.edges.push_back({index[from], index[to]});  // the face beyond has it the other way round
    }
  }
  return s;
}

}  // namespace plumb::query
