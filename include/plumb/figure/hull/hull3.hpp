// What is the convex hull of points in space?  Its vertices, and its faces as polygons of indices into the input.
//
// Laws: (1) the hull is that of real arithmetic, for every input: points repeated, collinear, coplanar, cospherical.
//       (2) The answer follows from the points alone: both methods, every number of threads and every machine give the
//       same numbers in the same order.  (3) Of equal points (-0 equals 0) the one of the smallest index stands for
//       all.  (4) Each face starts at its smallest index; faces are ordered by their first two corners.
// A coordinate that is NaN or infinite throws NonFinite ("convex_hull: points[17].y is nan, ..."); more than 2^29
// points throw InvalidShape.
// Source: RTCD 3.9, 3.9.2; Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for convex hulls"; Clarkson and Shor,
// "Applications of random sampling in computational geometry".  How it works: docs/hulls.md.
// Cost: n log n expected for `incremental`, whatever the points; quickhull is several times as fast on nearly all
// inputs, quadratic on contrived ones.  Bounded by n^3 signs, on integers as long as the exponents' span: an insertion
// makes 2 n faces at most, and asks each point that loses its face for each of them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"

namespace plumb {

enum class HullMethod : unsigned char {
  quickhull,    // always the farthest point of a face
  incremental,  // one point after the other in a shuffled order (always the same), with a conflict graph
};

struct HullOptions {
  bool triangulate = false;          // faces as triangles, coplanar ones side by side
  bool all_boundary_points = false;  // every point on the boundary, instead of the extreme ones
  HullMethod method = HullMethod::quickhull;
};

/// Corners of face f: corners[first[f]] up to corners[first[f + 1]], counterclockwise seen from outside.
/// dimension -1: no points; 0: all equal; 1: collinear, two vertices; 2: coplanar, one polygon, counterclockwise as
/// coplanar_orientation sees it; 3: the faces close.
/// With all_boundary_points every point of the boundary is among the vertices (all points, where the hull is flat),
/// those on an edge are corners of the faces on both of its sides, and those within a face are corners of its triangles
/// if it is triangulated.
struct Hull3 {
  int dimension = -1;
  std::vector<std::uint32_t> vertices;  // ascending
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first{0};

  [[nodiscard]] std::size_t face_count() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(first[f], first[f + 1] - first[f]);
  }
  friend bool operator==(const Hull3&, const Hull3&) = default;
};

Hull3 convex_hull(std::span<const Point3> points, HullOptions options = {});

/// The hull as a polyhedron of its own vertices, numbered in the order of hull.vertices.  Throws InvalidShape for a
/// hull of dimension below 3, and for one that is not a hull of these points' corners.
ConvexPolyhedron3 convex_polyhedron(const Hull3& hull, std::span<const Point3> points);

/// Indices of the points farthest along the direction, ascending: all of those that tie, equal points included.  All
/// points for a zero direction.  Linear.
std::vector<std::uint32_t> extreme_points(std::span<const Point3> points, const Vector3& direction);

/// A hull that grows point by point.  hull(options) is what convex_hull gives for all points so far, number for number.
/// Cost: an insertion looks at every face once, at a few operations each.
class Hull3Builder {
 public:
  Hull3Builder();
  ~Hull3Builder();
  Hull3Builder(Hull3Builder&&) noexcept;
  Hull3Builder& operator=(Hull3Builder&&) noexcept;

  /// Did the point lie outside?  Its index is the number of those before it.  Throws NonFinite, and InvalidShape for
  /// more than 2^29 points; the hull is as before then.
  bool insert(const Point3& point);
  [[nodiscard]] std::span<const Point3> points() const;
  /// -1, and 0 to 3 as of a Hull3.
  [[nodiscard]] int dimension() const;
  /// Of the options, method does not matter.
  [[nodiscard]] Hull3 hull(const HullOptions& options = {}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
