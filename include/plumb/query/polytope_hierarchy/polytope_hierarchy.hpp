// Dobkin-Kirkpatrick hierarchy: which vertex of a convex polytope lies farthest along a direction, how near does it
// come to a point or to another polytope, and when does a ray hit it, in logarithmic time?
//
//   const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
//   const Support3 s = support_point(h, direction);      // that of the polyhedron, number for number
//   const Closest c = closest_points(p, h);              // and so are these
//   const double d = distance(p, h);
//   const auto t = first_hit_parameter(ray, h);
//   const double apart = distance(h, other);             // separation of two hierarchies
//
// Polytopes, each the hull of the vertices that the one before it has left after an independent set of vertices of
// bounded degree was removed.  What lies beyond a plane that bounds one of them is, in the next finer one, a removed
// vertex at most, and that is a neighbor of every vertex in the plane.
// Laws: (1) every polytope is the hull of its vertices in real arithmetic (figure/hull/hull3.hpp), flat faces and
// corners within them included: what is no extreme point is in none.  (2) No two vertices that are removed together are
// neighbors, and none has more than `most_neighbors` there.  (3) Each polytope has at most 17/18 of the vertices of the
// next finer one, as a rule 2/3, until `fewest_vertices` are left or the rest would be flat.  (4) Answers are those of
// support_point, closest_points, distance, squared_distance_exact, contains, intersects and first_hit_parameter of the
// polyhedron, of two hierarchies those of their polyhedra.
// A polyhedron without faces throws InvalidShape, a direction or point that is NaN or infinite NonFinite, by name.
// Source: RTCD 9.3.1; Dobkin and Kirkpatrick, Fast detection of polyhedral intersection, 1983, and Determining the
// separation of preprocessed polyhedra, 1990.
// Cost: one hull for each of some 4 log n polytopes, n log n in all; some 20 n entries beside the polyhedron.  A
// question takes a step a polytope: a sign for each removed neighbor, of a vertex that has many the logarithm of their
// number; for the distance also a search among nine points at most.  Where several vertices are farthest these and
// their neighbors are looked at; where a point is within, closest_points asks the polyhedron, in linear time.  Two
// hierarchies take a step for each of their polytopes, and where one comes nearer a descent of the other, log n log n.
// Bounded by n^2 signs for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/support/support.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb {

/// One polytope of a hierarchy: the hull of the first `size` of its vertices.
struct HierarchyLevel {
  /// Of a vertex that has many neighbors to be asked: they are in the order in which they stand around it, and lie on
  /// one side of the plane through it with this normal.
  struct Fan {
    std::uint32_t vertex;
    Vector3 normal;
  };

  std::uint32_t size = 0;
  // Of vertex v that the next coarser polytope has too, those of its neighbors here which that has not:
  // removed[first_removed[v]] up to [first_removed[v + 1]], in the order in which they stand around it.
  std::vector<std::uint32_t> first_removed{0}, removed;
  // Of vertex v that the next coarser one has not, all its neighbors here: around[first_around[v - coarser size]] up to
  // the next.
  std::vector<std::uint32_t> first_around{0}, around;
  std::vector<Fan> fans;  // ascending

  [[nodiscard]] std::span<const std::uint32_t> removed_at(std::uint32_t v) const {
    return std::span(removed).subspan(first_removed[v], first_removed[v + 1] - first_removed[v]);
  }
  /// Of removed vertex number i.
  [[nodiscard]] std::span<const std::uint32_t> neighbors_of_removed(std::uint32_t i) const {
    return std::span(around).subspan(first_around[i], first_around[i + 1] - first_around[i]);
  }
};

struct PolytopeHierarchy {
  static constexpr std::uint32_t most_neighbors = 8, fewest_vertices = 8;

  /// All the neighbors of a vertex of the finest polytope that has many.
  struct Rim {
    HierarchyLevel::Fan fan;
    std::vector<std::uint32_t> neighbors;
  };

  ConvexPolyhedron3 polyhedron;
  std::vector<std::uint32_t>
      vertices;                        // the extreme ones among those of the mesh, what the coarsest polytope has first
  std::vector<Point3> points;          // they themselves
  std::vector<std::uint32_t> corners;  // of each, a corner of the mesh that it is at
  std::vector<HierarchyLevel> levels{1};  // the finest first
  // Of the finest polytope: neighbors[first_neighbor[v]] up to [first_neighbor[v + 1]].
  std::vector<std::uint32_t> first_neighbor{0}, neighbors;
  std::vector<Rim> rims;                                     // ascending
  std::vector<std::array<std::uint32_t, 3>> coarsest_faces;  // counterclockwise seen from outside

  [[nodiscard]] std::span<const std::uint32_t> neighbors_of(std::uint32_t v) const {
    return std::span(neighbors).subspan(first_neighbor[v], first_neighbor[v + 1] - first_neighbor[v]);
  }
};

/// Of a polyhedron that was made by convex_polyhedron or by a hull.
PolytopeHierarchy build_polytope_hierarchy(ConvexPolyhedron3 polyhedron);

/// What it takes in memory, the polyhedron included.
std::size_t bytes(const PolytopeHierarchy& hierarchy);

/// Of vertices that tie the one of the lowest index in the mesh.
Support3 support_point(const PolytopeHierarchy& hierarchy, const Vector3& direction);

Closest closest_points(const Point3& p, const PolytopeHierarchy& hierarchy);
double distance(const Point3& p, const PolytopeHierarchy& hierarchy);
Rational squared_distance_exact(const Point3& p, const PolytopeHierarchy& hierarchy);
bool contains(const PolytopeHierarchy& hierarchy, const Point3& p);

double distance(const PolytopeHierarchy& a, const PolytopeHierarchy& b);
Rational squared_distance_exact(const PolytopeHierarchy& a, const PolytopeHierarchy& b);
bool intersects(const PolytopeHierarchy& a, const PolytopeHierarchy& b);

/// When does a ray, a segment or a line come in?  The t of first_hit, exactly; nothing where it misses.
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const PolytopeHierarchy& hierarchy);

}  // namespace plumb
