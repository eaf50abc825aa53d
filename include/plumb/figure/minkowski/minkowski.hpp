// Minkowski sum, Minkowski difference: which shape do the sums, or the differences, of the points of two convex shapes
// make?  With exact vertices.
//
//   contains_origin(minkowski_difference(a, b))    // do a and b have a point in common?
//
// Laws: (1) vertices are sums of two points of the input that no double need hold: they are given as the two points,
//       and every decision about them is exact.  Of a difference the second is negated, which rounds nothing.
//       (2) The vertices are the strictly extreme points, each once; edges and faces that are parallel are merged.
//       (3) Any dimension will do: points, segments, flat polygons and polyhedra; the sum with nothing is nothing.
//       (4) minkowski_sum(a, b) and minkowski_sum(b, a) have the same points.
// Polygons are convex chains, of either orientation, with repeated vertices and straight angles, or lie on one line;
// another polygon throws InvalidShape.  For spans, and for polyhedra, the shape is the convex hull of the points.
// Source: RTCD 3.11 (figures 3.26, 3.27).
// Cost: for polygons linear: their edges are merged in angular order.  In space that of both hulls, and for each vertex
// of the sum, met along the edges, k log k signs of degree 3 or 2 for the k edges that leave its two points: linear in
// the size of the sum, but for such factors.  Bounded by n^2 log n signs in space, where a sum has n^2 vertices at
// most, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// The point a + b, in real arithmetic, and where a and b (before it was negated) are in the input.
struct SumVertex2 {
  Point2 a, b;
  std::uint32_t index_a, index_b;
  friend bool operator==(const SumVertex2&, const SumVertex2&) = default;
};
struct SumVertex3 {
  Point3 a, b;
  std::uint32_t index_a, index_b;
  friend bool operator==(const SumVertex3&, const SumVertex3&) = default;
};

/// Counterclockwise from the lexicographically smallest vertex; dimension -1: nothing, 0: a point, 1: a segment.
struct MinkowskiSum2 {
  int dimension = -1;
  std::vector<SumVertex2> vertices;
};

/// Corners of face f, which are numbers of vertices: corners[first[f]] up to corners[first[f + 1]], counterclockwise
/// seen from outside; for dimension 2 one polygon, counterclockwise in the first of the planes xy, yz, zx in which it
/// has an area; below that none.  The first vertex is the lexicographically smallest.
struct MinkowskiSum3 {
  int dimension = -1;
  std::vector<SumVertex3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first{0};

  [[nodiscard]] std::size_t face_count() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(first[f], first[f + 1] - first[f]);
  }
};

MinkowskiSum2 minkowski_sum(const Polygon2& a, const Polygon2& b);
MinkowskiSum2 minkowski_sum(std::span<const Point2> a, std::span<const Point2> b);
MinkowskiSum3 minkowski_sum(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b);
MinkowskiSum3 minkowski_sum(std::span<const Point3> a, std::span<const Point3> b);

/// All x - y for x in a and y in b.
MinkowskiSum2 minkowski_difference(const Polygon2& a, const Polygon2& b);
MinkowskiSum2 minkowski_difference(std::span<const Point2> a, std::span<const Point2> b);
MinkowskiSum3 minkowski_difference(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b);
MinkowskiSum3 minkowski_difference(std::span<const Point3> a, std::span<const Point3> b);

/// Exactly; what has no interior is all boundary.  Linear in the edges, in space in the faces.
Location locate(const MinkowskiSum2& sum, const Point2& p);
Location locate(const MinkowskiSum3& sum, const Point3& p);
bool contains(const MinkowskiSum2& sum, const Point2& p);
bool contains(const MinkowskiSum3& sum, const Point3& p);

/// Of a difference: do the two shapes have a point in common?
bool contains_origin(const MinkowskiSum2& sum);
bool contains_origin(const MinkowskiSum3& sum);

/// Each coordinate of the vertices rounded once; these need not be convex.  Throws BeyondDoubles.
std::vector<Point2> rounded_vertices(const MinkowskiSum2& sum);
std::vector<Point3> rounded_vertices(const MinkowskiSum3& sum);

}  // namespace plumb
