// Cells and portals: which rooms are there, and where does one see from one into another?  Convex cells, and polygons
// in the faces of two of them.
//
//   const PortalCells rooms({hall, kitchen}, {{{0, 1}, door}});
//   rooms.cells_holding(point)        // ascending; on a portal both, outside none
//   rooms.portals_at(point)           // those whose closed polygon it is on
//
// Laws: (1) a portal is a convex polygon that lies, exactly, in a face of each of its two cells, which are on different
// sides of it; it may be any part of the face.  (2) Cells are closed sets, and are taken as they are: nothing asks that
// they fill a space, or that what they have in common is a portal.  (3) cells_holding and portals_at tell exactly those
// whose closed set the point is in.
// A portal that is none throws InvalidShape with what is wrong ("PortalCells: portals[2].polygon.vertices[1] is not in
// the face of cells[4] that the others are in", "... turns to both sides", "... names cell 9 of 4"), a polyhedron that
// is none what check_polyhedron throws; NaN and infinity NonFinite.
// Source: RTCD 7.6.
// Cost: a sign for each face of a cell and vertex of its portals; cells_holding asks an octree of the cells' boxes,
// then a sign for each of their faces.  Bounded by n signs for n faces, and by the octree
// (space/octree/box_octree.hpp), on integers as long as the exponents' span.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/space/octree/box_octree.hpp"

namespace plumb {

struct Portal {
  std::array<std::uint32_t, 2> cells;
  Polygon3 polygon;
};

class PortalCells {
 public:
  PortalCells(std::vector<ConvexPolyhedron3> cells, std::vector<Portal> portals);

  [[nodiscard]] std::span<const ConvexPolyhedron3> cells() const { return cells_; }
  [[nodiscard]] std::span<const Portal> portals() const { return portals_; }
  /// Ascending.
  [[nodiscard]] std::span<const std::uint32_t> portals_of(std::uint32_t cell) const {
    return std::span(portals_of_).subspan(first_portal_[cell], first_portal_[cell + 1] - first_portal_[cell]);
  }
  /// The cell on the other side.
  [[nodiscard]] std::uint32_t beyond(std::uint32_t portal, std::uint32_t cell) const {
    const auto& [a, b] = portals_[portal].cells;
    return a == cell ? b : a;
  }
  /// Three points of its plane, by which orient3d is positive of what lies on the side of this cell.
  [[nodiscard]] std::array<Point3, 3> plane_before(std::uint32_t portal, std::uint32_t cell) const;

  [[nodiscard]] std::vector<std::uint32_t> cells_holding(const Point3& point,
                                                         std::vector<std::uint32_t> rows = {}) const;
  [[nodiscard]] std::vector<std::uint32_t> portals_at(const Point3& point, std::vector<std::uint32_t> rows = {}) const;

  /// Throws InvalidShape, naming the function.
  void require_cell(std::string_view function, std::uint32_t cell) const;

 private:
  std::vector<ConvexPolyhedron3> cells_;
  std::vector<Portal> portals_;
  std::vector<std::array<Point3, 3>> planes_;  // of the portals: positive before cells[0]
  std::vector<std::uint32_t> portals_of_, first_portal_;
  BoxOctree boxes_;
};

}  // namespace plumb
