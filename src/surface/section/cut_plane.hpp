// What does a section ask of its plane?  The side of a point, where an edge meets it, and two coordinates to look at
// it.
//
// Laws: sides are exact; `nearest` is rounded once; seen along the axis, no two points of the plane are one.
// Cost: a comparison for planes of one coordinate, else a filter; `nearest` some 100 ns.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "plumb/certify/side.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/section/planes.hpp"

namespace plumb::surface {

/// The points whose coordinate `axis` is `height`.
struct AxisPlane {
  std::size_t axis;
  double height;
  bool down;  // the normal points down the axis
};

inline double coordinate(const Point3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

class CutPlane {
 public:
  explicit CutPlane(const AnyPlane3& plane);

  /// Positive on the side of the normal.
  [[nodiscard]] Sign side(const Point3& p) const;
  /// Where the edge from p to q, on different sides, meets the plane.
  [[nodiscard]] Point3 nearest(const Point3& p, const Point3& q) const;
  [[nodiscard]] ExactPoint3 exact(const Point3& p, const Point3& q) const;

  /// Two axes that show the plane as it is seen from the normal's side.
  [[nodiscard]] const std::array<std::size_t, 2>& shown() const { return shown_; }

 private:
  struct ThroughPoints {
    ThreePointPlane3 plane;
    Side<predicates::Orient3d> side;
  };
  void show_along(std::size_t axis, bool down);
  [[nodiscard]] const AxisPlane* axis_plane() const { return std::get_if<AxisPlane>(&form_); }

  std::variant<AxisPlane, Plane3, ThroughPoints> form_;
  std::array<std::size_t, 2> shown_{};
};

}  // namespace plumb::surface
