// Which triangles surely meet no earlier than those that meet first as yet?  What lands flat does so in many pairs at
// once, and each takes long to ask.
//
// A wall is a direction along which two meshes' triangles approach: what lies no farther ahead than one triangle of a,
// and what lies no nearer than one of b, meets no earlier than these two would.  Walls are the axes and the planes of
// the two triangles, where that is as late as they do meet.
// Law: what a wall stops meets no earlier than the time that it was built for.
// Source: RTCD 5.2.1, 5.5.2 (separating axes).
// Cost: comparisons of boxes for axes; for a plane a sign a vertex, which is kept.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"
#include "query/body/posed_corners.hpp"
#include "space/closest/vertex_sides.hpp"

namespace plumb::space {

class ContactWalls {
 public:
  /// a moves by the image of a vector: a pose's matrix times it.
  ContactWalls(const PosedMesh& a, const Posed<Vector3>& by, const PosedMesh& b) : a_(a), b_(b), by_(by) {}

  void clear();
  /// Of the triangles in two slots, which meet first at this time.  Their boxes where they are exact, else nothing.
  void build(std::uint32_t slot_a, std::uint32_t slot_b, const Rational& time,
             const std::optional<std::array<Aabb3, 2>>& boxes);

  [[nodiscard]] bool stop(const Aabb3& box_a, const Aabb3& box_b) const;
  [[nodiscard]] bool stop(std::uint32_t slot_a, std::uint32_t slot_b);

 private:
  /// How high: along a direction that a moves in.
  template <class T>
  struct Heights {
    query::Vec3<T> up;
    T of_a, of_b;  // of the highest of a's triangle, and the lowest of b's, each times the weight of its pose
  };
  struct Plane {
    Heights<Ball> quick;
    Heights<BigDyadic> exact;
    VertexSides sides_a, sides_b;
  };
  struct Axis {
    Sign way = Sign::zero;  // zero: none
    double of_a = 0, of_b = 0;
  };

  bool build_plane(const PosedTriangle& plane, std::uint32_t slot_a, std::uint32_t slot_b, const Rational& time);
  bool stops_a(std::uint32_t vertex);
  bool stops_b(std::uint32_t vertex);

  const PosedMesh &a_, &b_;
  const Posed<Vector3>& by_;
  std::array<Axis, 3> axes_{};
  std::optional<Plane> plane_;
};

}  // namespace plumb::space
