// The surface of a hull while it grows: triangles with their planes, replaced by cones over the horizon of new points.
//
// A point is above a face if it is strictly outside its plane; what lies in the plane is not.  So faces may be coplanar
// with their neighbors, none is degenerate, and the faces above which a point lies form a disk with a simple horizon.
// A new face is never degenerate: its edge bounds a face above which the point lies strictly.
// Every sign is exact.  The plane of a face is a PlaneSide whose filter is taken at the extents of all points: rounding
// is monotone, so there its bound is at least what it is at any point within them, and a query is one comparison.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/certify/side.hpp"

namespace plumb::figure::hull3 {

using Id = std::uint32_t;
inline constexpr Id none = ~Id{0};

struct Extents {
  Point3 min, max;
};

struct Node {
  Point3 point;
  Id next = none;   // in the list that it is in
  Id index = none;  // in the input
};

struct FacePlane {
  static_assert(certify::side::form_of<predicates::Orient3d>.variables == 3 &&
                certify::side::form_of<predicates::Orient3d>.variable[0] == 0 &&
                certify::side::form_of<predicates::Orient3d>.variable[1] == 1 &&
                certify::side::form_of<predicates::Orient3d>.variable[2] == 2);
  std::array<double, 3> coefficient, pivot;
  double bound;

  FacePlane() = default;
  FacePlane(const PlaneSide& side, const Vector3& widths) {
    const std::array<double, 3> d{widths.x, widths.y, widths.z};
    double magnitude = certify::side::guards<predicates::Orient3d>;
    for (std::size_t a = 0; a < 3; ++a) {
      coefficient[a] = side.coefficient(a);
      pivot[a] = side.pivot(a);
      magnitude += d[a] * side.magnitude(a);
    }
    bound = certify::side::constant<predicates::Orient3d> * magnitude;
  }

  /// As PlaneSide computes it: below zero above the face; certain beyond the bound.
  [[nodiscard]] double value(const Point3& p) const {
    double sum = (p.x - pivot[0]) * coefficient[0];
    sum = sum + (p.y - pivot[1]) * coefficient[1];
    return sum + (p.z - pivot[2]) * coefficient[2];
  }
};

/// Edge i of a face leads from vertex[i] to the next; its half-edge is 3 face + i.
struct Face {
  std::array<Id, 3> vertex{none, none, none};  // nodes; none where the place is free
  std::array<Id, 3> twin{none, none, none};    // half-edges
  Id list = none, farthest = none;             // its points; of quickhull
  Id flat = none;                              // points in its plane; kept for all_boundary_points
  Id mark = 0;
  double height = 0;

  [[nodiscard]] bool alive() const { return vertex[0] != none; }
};

constexpr Id next_in_face(Id half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }

class Surface {
 public:
  /// All points that are ever asked about lie within the extents.
  Surface(std::vector<Node> nodes, const Extents& extents)
      : nodes_(std::move(nodes)),
        widths_{extents.max.x - extents.min.x, extents.max.y - extents.min.y, extents.max.z - extents.min.z} {}

  [[nodiscard]] std::vector<Node>& nodes() { return nodes_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::vector<Face>& faces() { return faces_; }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] const FacePlane& plane(Id face) const { return planes_[face]; }

  /// From now on points may lie within these extents, which hold the old ones.
  void widen(const Extents& extents);

  /// The tetrahedron of four nodes that are not coplanar, in any order.
  void start(const std::array<Id, 4>& simplex);

  /// -1 above the face, 0 in its plane, 1 below.
  [[nodiscard]] int side(Id face, const Point3& p) const {
    const double value = planes_[face].value(p), bound = planes_[face].bound;
    if (value > bound) return 1;
    if (value < -bound) return -1;
    return exact_side(face, p);
  }
  /// As side(face, p) where the filter of its plane is unsure.
  [[nodiscard]] int exact_side(Id face, const Point3& p) const;

  /// Walks from a face above which p lies over all of them, depth first; visible() are these, horizon() the half-edges
  /// behind them, counterclockwise around p.
  void look(Id from, const Point3& p) {
    walk(from, [&](Id face) { return side(face, p) < 0; });
  }
  template <class Sees>
  void walk(Id from, Sees sees);
  [[nodiscard]] std::span<const Id> visible() const { return visible_; }
  [[nodiscard]] std::span<const Id> horizon() const { return horizon_; }

  /// The faces from this node to the horizon, one for each of its half-edges, in its order.  The visible ones stay
  /// where they are, to be read, until drop_visible().
  std::span<const Id> cone(Id apex);
  void drop_visible();

  [[nodiscard]] Id start_of(Id half_edge) const { return faces_[half_edge / 3].vertex[half_edge % 3]; }
  [[nodiscard]] Id end_of(Id half_edge) const { return start_of(next_in_face(half_edge)); }
  [[nodiscard]] Id twin(Id half_edge) const { return faces_[half_edge / 3].twin[half_edge % 3]; }
  [[nodiscard]] const Point3& point(Id node) const { return nodes_[node].point; }

 private:
  Id make_face(Id a, Id b, Id c);
  void join(Id half_edge, Id other) {
    faces_[half_edge / 3].twin[half_edge % 3] = other;
    faces_[other / 3].twin[other % 3] = half_edge;
  }

  std::vector<Node> nodes_;
  Vector3 widths_;
  std::vector<Face> faces_;
  std::vector<FacePlane> planes_;
  std::vector<Id> free_, visible_, horizon_, made_, stack_;
  Id stamp_ = 0;
};

template <class Sees>
void Surface::walk(Id from, Sees sees) {
  if (stamp_ >= none - 2) {  // marks start over
    for (Face& f : faces_) f.mark = 0;
    stamp_ = 0;
  }
  stamp_ += 2;  // seen; and stamp_ - 1: hidden
  visible_.assign(1, from);
  horizon_.clear();
  faces_[from].mark = stamp_;
  stack_.assign({3 * from + 2, 3 * from + 1, 3 * from});
  while (!stack_.empty()) {
    const Id behind = twin(stack_.back());
    stack_.pop_back();
    Face& face = faces_[behind / 3];
    if (face.mark == stamp_) continue;
    if (face.mark != stamp_ - 1) face.mark = sees(behind / 3) ? stamp_ : stamp_ - 1;
    if (face.mark == stamp_) {
      visible_.push_back(behind / 3);
      const Id next = next_in_face(behind);
      stack_.push_back(next_in_face(next));
      stack_.push_back(next);
    } else {
      horizon_.push_back(behind);
    }
  }
}

}  // namespace plumb::figure::hull3
