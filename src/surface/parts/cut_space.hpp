// Which points and planes do cuts of a solid come to, and how do they lie to one another?  Those of its triangles, and
// where an edge crosses a plane.
//
// Vertices and planes have numbers; a point has one number, and so has a plane, however many triangles lie in it.
// Laws: (1) vertices as given are numbered in lexicographic order, planes in the order of their equations: both follow
// from the points alone.  (2) Every sign is that of the exact points and planes.  (3) A plane has a side above, that of
// its normal; the normal's first part that is not zero is positive.
// Source: Chazelle 1984; Bernstein and Fussell 2009 for solids held by their planes.
// Cost: an exact plane once a triangle, some microseconds; a sign 2 to 500 ns, by what exact points remember.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::surface {

/// Through two vertices as given, or in two planes that are not parallel.
struct CutLine {
  std::uint32_t first, second;
  bool of_planes;
  friend bool operator==(const CutLine&, const CutLine&) = default;
};

class CutSpace {
 public:
  /// The vertices ascend, no two of them equal; no triangle is without area.
  explicit CutSpace(const TriangleMesh& mesh);

  [[nodiscard]] std::size_t vertices() const { return points_.size(); }
  [[nodiscard]] const ExactPoint3& point(std::uint32_t vertex) const { return points_[vertex]; }
  [[nodiscard]] std::uint32_t plane_of(std::uint32_t triangle) const { return plane_of_[triangle]; }
  /// Is the triangle seen counterclockwise from below its plane?
  [[nodiscard]] bool is_turned(std::uint32_t triangle) const { return turned_[triangle] != 0; }

  [[nodiscard]] Sign side(std::uint32_t vertex, std::uint32_t plane);
  [[nodiscard]] bool before(std::uint32_t vertex, std::uint32_t other) const {
    return certify::order(points_[vertex], points_[other]) == Sign::negative;
  }
  /// The cross product of two normals points forward along their line (positive), backward, or is zero: forward is from
  /// lexicographically smaller points to larger ones.
  [[nodiscard]] int bend(std::uint32_t plane, std::uint32_t other);
  /// Where the line crosses the plane, which it does.
  std::uint32_t meet(const CutLine& line, std::uint32_t plane);

 private:
  struct PlaneEntry {
    query::Exact3 normal;
    mpq_class offset;
    std::array<std::uint32_t, 3> corners;  // counterclockwise seen from above
  };
  [[nodiscard]] std::array<Point3, 3> given(std::uint32_t plane) const;
  [[nodiscard]] const Point3& given_vertex(std::uint32_t v) const { return std::get<Point3>(points_[v].as()); }
  [[nodiscard]] ExactPoint3 crossing(const CutLine& line, std::uint32_t plane) const;

  std::vector<ExactPoint3> points_;
  std::vector<std::vector<std::uint32_t>> planes_at_;  // planes that are known to hold a vertex
  std::vector<PlaneEntry> planes_;
  std::vector<std::uint32_t> plane_of_;
  std::vector<std::uint8_t> turned_;
  std::unordered_map<ExactPoint3, std::uint32_t> number_of_;
  std::unordered_map<std::uint64_t, signed char> bends_;
};

}  // namespace plumb::surface
