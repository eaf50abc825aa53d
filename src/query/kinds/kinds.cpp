#include "plumb/query/kinds/kinds.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <typeinfo>

#include "arith/exact_number.hpp"
#include "certify/catalog.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/own_kind.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/parity.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/kinds/kind_generators.hpp"
#include "query/kinds/kind_hit.hpp"
#include "query/kinds/kind_hull.hpp"
#include "query/kinds/mesh_generators.hpp"

namespace plumb::degenerate {

namespace {

using Given = std::span<const double>;

/// From the count of vertices on.
TriangleMesh mesh_from(Given q) {
  TriangleMesh mesh;
  const std::size_t end = 1 + 3 * static_cast<std::size_t>(q[0]);
  for (std::size_t i = 1; i < end; i += 3) mesh.vertices.push_back({q[i], q[i + 1], q[i + 2]});
  for (std::size_t i = end + 1; i < q.size(); i += 3) {
    mesh.triangles.push_back(
        {static_cast<std::uint32_t>(q[i]), static_cast<std::uint32_t>(q[i + 1]), static_cast<std::uint32_t>(q[i + 2])});
  }
  return mesh;
}

Answer exact_mesh_hit(Given q, const Convention& convention) {
  const Ray3 ray{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}};
  const TriangleMesh mesh = mesh_from(q.subspan(6));
  // Rounding keeps the order: the least of the rounded parameters is the least one, rounded.
  Answer first = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Answer hit = first_hit_under(ray, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, convention);
    if (hit.numbers[0] != 0 && (first.numbers[0] == 0 || hit.numbers[1] < first.numbers[1])) first = hit;
  }
  return first;
}

Location locate_in_mesh(Given q) { return locate(mesh_from(q.subspan(3)), Point3{q[0], q[1], q[2]}); }

Point2 point2(Given q, std::size_t at) { return {q[at], q[at + 1]}; }
Point3 point3(Given q, std::size_t at) { return {q[at], q[at + 1], q[at + 2]}; }
Vector3 vector3(Given q, std::size_t at) { return {q[at], q[at + 1], q[at + 2]}; }
Triangle3 triangle(Given q, std::size_t at) { return {point3(q, at), point3(q, at + 3), point3(q, at + 6)}; }
Obb3 oriented_box(Given q, std::size_t at) {
  return {point3(q, at), {vector3(q, at + 3), vector3(q, at + 6), vector3(q, at + 9)}, vector3(q, at + 12)};
}
query::FlatSet point_set(Given q, std::size_t at) {
  query::FlatSet set;
  const auto end = at + 1 + 3 * static_cast<std::size_t>(q[at]);
  for (std::size_t i = at + 1; i < end; i += 3) set.points.push_back({q[i], q[i + 1], q[i + 2]});
  return set;
}

Answer answer(Sign sign) { return static_cast<double>(sign); }
Answer answer(bool yes) { return yes ? 1.0 : 0.0; }

// A function of so many pointers to doubles.
template <std::size_t>
using Pointer = const double*;
template <class R, class Places>
struct FixedOf;
template <class R, std::size_t... i>
struct FixedOf<R, std::index_sequence<i...>> {
  using Function = R(Pointer<i>...);
  static Answer call(ForeignFunction function, std::span<const Passed> passed) {
    const auto given = reinterpret_cast<Function*>(function)(passed[i].numbers...);
    if constexpr (std::is_same_v<R, double>)
      return given;
    else
      return answer(given != 0);
  }
};
template <class R, std::size_t arguments>
using Fixed = FixedOf<R, std::make_index_sequence<arguments>>;

using InPolygonFunction = int(const double*, const double*, std::size_t);
using InMeshFunction = int(const double*, const double*, std::size_t, const std::size_t*, std::size_t);
using HitFunction = int(const double*, const double*, double*);
using HitMeshFunction = int(const double*, const double*, std::size_t, const std::size_t*, std::size_t, double*);
using DistanceFunction = double(const double*, std::size_t, const double*, std::size_t);

Answer call_in_polygon(ForeignFunction function, std::span<const Passed> passed) {
  const auto f = reinterpret_cast<InPolygonFunction*>(function);
  return answer(f(passed[0].numbers, passed[1].numbers, passed[1].count) != 0);
}

Answer call_in_mesh(ForeignFunction function, std::span<const Passed> passed) {
  const auto f = reinterpret_cast<InMeshFunction*>(function);
  const Passed &p = passed[0], &vertices = passed[1], &triangles = passed[2];
  return answer(f(p.numbers, vertices.numbers, vertices.count, triangles.indices, triangles.count) != 0);
}

template <class Ask>
Answer hit_by(const Ask& f) {
  // A NaN that no arithmetic makes: still there, the function does not tell parameters.
  const auto untold = std::bit_cast<double>(0x7ff8'dead'beef'0001);
  double t = untold;
  if (f(&t) == 0) return 0.0;
  Answer hit = 1.0;
  if (std::bit_cast<std::uint64_t>(t) != std::bit_cast<std::uint64_t>(untold)) hit.numbers.push_back(t);
  return hit;
}

Answer call_hit(ForeignFunction function, std::span<const Passed> passed) {
  const auto f = reinterpret_cast<HitFunction*>(function);
  return hit_by([&](double* t) { return f(passed[0].numbers, passed[1].numbers, t); });
}

Answer call_hit_mesh(ForeignFunction function, std::span<const Passed> passed) {
  const auto f = reinterpret_cast<HitMeshFunction*>(function);
  const Passed &ray = passed[0], &vertices = passed[1], &triangles = passed[2];
  return hit_by([&](double* t) {
    return f(ray.numbers, vertices.numbers, vertices.count, triangles.indices, triangles.count, t);
  });
}

Answer call_distance(ForeignFunction function, std::span<const Passed> passed) {
  const auto f = reinterpret_cast<DistanceFunction*>(function);
  return f(passed[0].numbers, passed[0].count, passed[1].numbers, passed[1].count);
}

Answer exact_hit(Given q, const Convention& c) {
  return first_hit_under({point3(q, 0), vector3(q, 3)}, triangle(q, 6), c);
}

Polygon2 polygon_of(Given q) {
  Polygon2 polygon;
  for (std::size_t i = 3; i < q.size(); i += 2) polygon.vertices.push_back(point2(q, i));
  return polygon;
}

Answer located(Location where, const Convention& c) {
  return answer(where == Location::inside || (where == Location::boundary && c.boundary != Boundary::out));
}
Location locate_in_polygon(Given q) { return locate(polygon_of(q), point2(q, 0)); }

/// Edges that have a point in common beside the vertex between two neighbors, or none of length.
bool crosses_itself(Given q) {
  const std::vector<Point2> v = polygon_of(q).vertices;
  const auto edge = [&](std::size_t i) { return Segment2{v[i], v[(i + 1) % v.size()]}; };
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (edge(i).a == edge(i).b) return true;
    for (std::size_t j = 0; j < i; ++j) {
      const bool neighbors = (j + 1) % v.size() == i || (i + 1) % v.size() == j;
      // What is convex and in boundaries alone is one point: of neighbors, their vertex.
      const Relation allowed = neighbors ? Relation::touching : Relation::disjoint;
      if (relate(edge(i), edge(j)) != allowed) return true;
    }
  }
  return false;
}

Answer exact_distance_of_hulls(Given q) {
  const auto second = 1 + 3 * static_cast<std::size_t>(q[0]);
  const auto square = query::squared_distance(point_set(q, 0), point_set(q, second));
  return rounded_root(Rounding::nearest, exact_number(*square));
}

// Arguments.
Argument triangles(Role role) { return {"triangles", {{role, 3}}, 1}; }
Argument oriented(std::string_view name) {
  return {std::string(name), {{Role::points, 3}, {Role::frame, 3, 3}, {Role::extents, 3}}};
}

std::vector<Argument> single_points(std::string_view names, int dimension) {
  std::vector<Argument> all;
  for (std::size_t i = 0; i < names.size(); ++i) all.push_back(points(std::string(names.substr(i, 1)), dimension));
  return all;
}

std::vector<Generator> with(std::vector<Generator> first, std::vector<Generator> more) {
  std::ranges::move(more, std::back_inserter(first));
  return first;
}

/// The families, aimed at what is flat, and the positions of a pair.
template <ShapeKind a, ShapeKind b = a>
std::vector<Generator> with_positions(int dimension, Arrange arrange, Join join = join_plainly) {
  return with(family_generators(dimension == 2 ? Degeneracy::collinear : Degeneracy::coplanar, dimension, arrange),
              position_generators(a, b, dimension, join));
}

template <class Call>
Kind predicate(std::string name, std::string question, std::string signature, std::string convention,
               std::vector<Argument> arguments, Degeneracy aim, Arrange arrange, Answer (*exact)(Given)) {
  const int dimension = arguments[0].parts[0].dimension;
  Kind kind{std::move(name),
            std::move(question),
            std::move(signature),
            std::move(convention),
            AnswerForm::sign,
            std::move(arguments),
            family_generators(aim, dimension, arrange),
            typeid(typename Call::Function),
            {},
            Call::call,
            exact};
  kind.special = [exact](Given q) { return exact(q).numbers[0] == 0; };
  return kind;
}

std::vector<Kind> classic_kinds() {
  return {
      predicate<Fixed<double, 3>>("orient2d", "which way do three points turn?",
                                  "double f(const double a[2], const double b[2], const double c[2])",
                                  "positive: counterclockwise; only the sign counts", single_points("abc", 2),
                                  Degeneracy::collinear, arrange_points<6>,
                                  [](Given q) { return answer(orient2d(point2(q, 0), point2(q, 2), point2(q, 4))); }),
      predicate<Fixed<double, 4>>(
          "orient3d", "on which side of a plane is a point?",
          "double f(const double a[3], const double b[3], const double c[3], const double d[3])",
          "positive: d is below the plane that sees a, b, c counterclockwise from above; only the sign counts",
          single_points("abcd", 3), Degeneracy::coplanar, arrange_points<12>,
          [](Given q) { return answer(orient3d(point3(q, 0), point3(q, 3), point3(q, 6), point3(q, 9))); }),
      predicate<Fixed<double, 4>>(
          "incircle", "is a point inside of a circle?",
          "double f(const double a[2], const double b[2], const double c[2], const double d[2])",
          "positive: d is inside the circle of a, b, c in counterclockwise order; only the sign counts",
          single_points("abcd", 2), Degeneracy::cocircular, arrange_points<8>,
          [](Given q) { return answer(incircle(point2(q, 0), point2(q, 2), point2(q, 4), point2(q, 6))); }),
      predicate<Fixed<double, 5>>(
          "insphere", "is a point inside of a sphere?",
          "double f(const double a[3], const double b[3], const double c[3], const double d[3], const double e[3])",
          "positive: e is inside the sphere of a, b, c, d, where orient3d(a, b, c, d) > 0; only the sign counts",
          single_points("abcde", 3), Degeneracy::cospherical, arrange_points<15>,
          [](Given q) {
            return answer(insphere(point3(q, 0), point3(q, 3), point3(q, 6), point3(q, 9), point3(q, 12)));
          }),
  };
}

/// Whose boundaries may count or not; of segments these are their ends.
Kind meeting(std::string name, std::string question, std::string signature, std::vector<Argument> arguments,
             std::vector<Generator> generators, Relation (*relation)(Given)) {
  using Call = Fixed<int, 2>;
  const bool of_segments = name.starts_with("segment");
  Kind kind{std::move(name),
            std::move(question),
            std::move(signature),
            "not 0: they have a point in common, and be it one of their boundaries",
            AnswerForm::yes_no,
            std::move(arguments),
            std::move(generators),
            typeid(typename Call::Function),
            {},
            Call::call,
            [relation](Given q) { return answer(relation(q) != Relation::disjoint); }};
  (of_segments ? kind.has_ends : kind.has_boundary) = true;
  kind.exact_under = [relation](Given q, const Convention& c) {
    const bool inner = c.boundary == Boundary::out || c.ends == Ends::open;
    return answer(inner ? relation(q) == Relation::overlapping : relation(q) != Relation::disjoint);
  };
  return kind;
}

std::vector<Kind> meetings() {
  return {
      meeting("segment-segment", "do two segments of the plane meet?", "int f(const double a[4], const double b[4])",
              {points("a", 2, 2), points("b", 2, 2)}, with_positions<ShapeKind::segment>(2, arrange_points<8>),
              [](Given q) {
                return relate(Segment2{point2(q, 0), point2(q, 2)}, Segment2{point2(q, 4), point2(q, 6)});
              }),
      meeting("segment-segment-3d", "do two segments in space meet?", "int f(const double a[6], const double b[6])",
              {points("a", 3, 2), points("b", 3, 2)}, with_positions<ShapeKind::segment>(3, arrange_points<12>),
              [](Given q) {
                return relate(Segment3{point3(q, 0), point3(q, 3)}, Segment3{point3(q, 6), point3(q, 9)});
              }),
      meeting("triangle-triangle", "do two triangles in space meet?", "int f(const double a[9], const double b[9])",
              {points("a", 3, 3), points("b", 3, 3)}, with_positions<ShapeKind::triangle>(3, arrange_points<18>),
              [](Given q) { return relate(triangle(q, 0), triangle(q, 9)); }),
      meeting("box-box", "do two boxes along the axes meet?", "int f(const double a[6], const double b[6])",
              {box("a", 3), box("b", 3)}, with_positions<ShapeKind::aabb>(3, arrange_boxes),
              [](Given q) {
                return relate(Aabb3{point3(q, 0), point3(q, 3)}, Aabb3{point3(q, 6), point3(q, 9)});
              }),
      meeting("obb-obb", "do two oriented boxes meet?", "int f(const double a[15], const double b[15])",
              {oriented("a"), oriented("b")},
              with(with_positions<ShapeKind::obb>(3, arrange_oriented_boxes, join_oriented_boxes), {stacked_boxes()}),
              [](Given q) { return relate(oriented_box(q, 0), oriented_box(q, 15)); }),
  };
}

std::vector<Kind> others() {
  constexpr Tolerance fine{.ulps = 1 << 12, .relative = 0};
  constexpr Tolerance coarse{.ulps = 1 << 12, .relative = 0x1p-40};  // a guess of what good code reaches
  return {
      {"ray-triangle",
       "where does a ray hit a triangle?",
       "int f(const double ray[6], const double triangle[9], double* t)",
       "not 0: the ray from the first three numbers along the last three meets the closed triangle, first at t times "
       "its "
       "direction; *t may be left alone",
       AnswerForm::hit,
       {{"ray", {{Role::points, 3}, {Role::vector, 3}}}, points("triangle", 3, 3)},
       with_positions<ShapeKind::ray, ShapeKind::triangle>(3, arrange_ray),
       typeid(HitFunction),
       fine,
       call_hit,
       [](Given q) { return exact_hit(q, {}); },
       {},
       true,
       true,
       exact_hit},
      {"point-in-polygon",
       "is a point in a closed polygon?",
       "int f(const double p[2], const double* vertices, size_t n)",
       "not 0: p is on an edge, or the chain winds around it an odd number of times",
       AnswerForm::yes_no,
       {points("p", 2, 1), any_points("vertices", 2, 3)},
       with(with_positions<ShapeKind::point, ShapeKind::polygon>(2, arrange_polygon, join_point_and_polygon),
            {boundary_points()}),
       typeid(InPolygonFunction),
       {},
       call_in_polygon,
       [](Given q) { return located(locate_in_polygon(q), {}); },
       {},
       true,
       false,
       [](Given q, const Convention& c) { return located(locate_in_polygon(q), c); },
       {},
       {},
       crosses_itself},
      {"ray-mesh",
       "where does a ray first hit a soup of triangles?",
       "int f(const double ray[6], const double* vertices, size_t n, const size_t* triangles, size_t m, double* t)",
       "not 0: the ray from the first three numbers along the last three meets one of the closed triangles, first at t "
       "times its direction; *t may be left alone; three indices of vertices a triangle, in any order, any of them "
       "equal",
       AnswerForm::hit,
       {{"ray", {{Role::points, 3}, {Role::vector, 3}}}, any_points("vertices", 3, 1), triangles(Role::soup)},
       with(ray_mesh_generators(), family_generators(Degeneracy::coplanar, 3, arrange_ray_and_soup)),
       typeid(HitMeshFunction),
       fine,
       call_hit_mesh,
       [](Given q) { return exact_mesh_hit(q, {}); },
       {},
       false,
       true,
       exact_mesh_hit},
      {"point-in-polyhedron",
       "is a point in the solid that a closed mesh bounds?",
       "int f(const double p[3], const double* vertices, size_t n, const size_t* triangles, size_t m)",
       "not 0: p is on a triangle, or the mesh winds around it an odd number of times; each edge, by the places of its "
       "ends, is passed as often in either direction, which is all that a mesh promises",
       AnswerForm::yes_no,
       {points("p", 3, 1), any_points("vertices", 3, 1), triangles(Role::surface)},
       with(polyhedron_generators(), family_generators(Degeneracy::coplanar, 3, arrange_point_and_solid)),
       typeid(InMeshFunction),
       {},
       call_in_mesh,
       [](Given q) { return located(locate_in_mesh(q), {}); },
       {},
       true,
       false,
       [](Given q, const Convention& c) { return located(locate_in_mesh(q), c); }},
      {"convex-distance",
       "how far apart are the convex hulls of two sets of points?",
       "double f(const double* a, size_t n, const double* b, size_t m)",
       "the distance, 0 where the hulls meet",
       AnswerForm::number,
       {any_points("a", 3, 1), any_points("b", 3, 1)},
       with_positions<ShapeKind::points>(3, arrange_point_sets, join_point_sets),
       typeid(DistanceFunction),
       coarse,
       call_distance,
       exact_distance_of_hulls},
      {"hull",
       "what is the convex hull of points in space?",
       "size_t f(const double* points, size_t n, size_t* triangles, size_t capacity)",
       "the number of triangles, three indices each, counterclockwise seen from outside; 0 where all points are in one "
       "plane, (size_t)-1: no answer; there is room for capacity triangles, which is 2 n",
       AnswerForm::triangles,
       {any_points("points", 3, 1)},
       with(cloud_generators(), family_generators(Degeneracy::coplanar, 3, arrange_cloud)),
       typeid(std::remove_pointer_t<HullFunction>),
       {},
       call_hull,
       exact_hull,
       judge_hull,
       false,
       false,
       {},
       {},
       {},
       [](Given q) { return exact_hull(q).numbers.empty(); }},
  };
}

}  // namespace

std::span<const Kind> kinds() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> made = classic_kinds();
    for (std::vector<Kind>& more : std::array{meetings(), others()}) std::ranges::move(more, std::back_inserter(made));
    return made;
  }();
  return all;
}

std::span<const Kind> predicate_kinds() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> made;
    for (const CatalogEntry& e : catalog().subspan(classics().size())) {
      made.push_back(formula_kind(
          {e.name, e.arguments, {}, [&e](std::span<const double> coordinates) { return e.decide(coordinates).sign; }}));
    }
    return made;
  }();
  return all;
}

const Kind* find_kind(std::string_view name) {
  for (const std::span<const Kind> all : {kinds(), predicate_kinds()}) {
    const auto at = std::ranges::find(all, name, &Kind::name);
    if (at != all.end()) return &*at;
  }
  return nullptr;
}

const Kind& kind_named(std::string_view name) {
  if (const Kind* const found = find_kind(name)) return *found;
  std::string text = std::string("no kind is called ").append(name).append("; there are");
  for (const Kind& kind : kinds()) text.append(" ").append(kind.name);
  throw Error(text.append(" and the predicates of docs/predicates.md, such as ").append(predicate_kinds()[0].name));
}

}  // namespace plumb::degenerate
