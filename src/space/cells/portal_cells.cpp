#include "plumb/space/cells/portal_cells.hpp"

#include <algorithm>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "space/cells/three_points.hpp"

namespace plumb {
namespace {

using space::ThreePoints;

[[noreturn]] void refuse(const std::string& what) { throw InvalidShape("PortalCells: " + what); }

std::string portal_name(std::size_t i) { return "portals[" + std::to_string(i) + "]"; }

/// Which is convex, and in one plane.
void check_polygon(std::size_t i, const Polygon3& polygon) {
  const std::string name = portal_name(i) + ".polygon";
  figure::require_finite_points("PortalCells", name + ".vertices", std::span(polygon.vertices));
  if (polygon.vertices.size() < 3) refuse(name + " has fewer than three vertices");
  switch (convexity(polygon).kind) {
    case PolygonKind::strictly_convex:
    case PolygonKind::convex:
      return;
    case PolygonKind::concave:
      refuse(name + " turns to both sides; divide it into convex ones");
    case PolygonKind::self_winding:
      refuse(name + " goes around more than once");
    case PolygonKind::degenerate:
      refuse(name + " has all its vertices on one line");
    case PolygonKind::not_planar:
      refuse(name + " does not lie in a plane, exactly");
  }
}

/// Does it lie in a face of the cell?  A plane that holds a face and no point within holds no more than that face.
void check_in_face(const PortalCells& all, std::size_t i, std::uint32_t cell) {
  const ConvexPolyhedron3& c = all.cells()[cell];
  const Polygon3& polygon = all.portals()[i].polygon;
  std::size_t most = 0, outside = 0;
  for (std::size_t f = 0; f + 1 < c.mesh.first.size(); ++f) {
    const auto corner = [&](std::size_t k) { return c.mesh.vertices[c.mesh.corners[c.mesh.first[f] + k]]; };
    const ThreePoints plane = space::plane_of_chain(c.mesh.first[f + 1] - c.mesh.first[f], corner);
    std::size_t in_plane = 0, first_off = polygon.vertices.size();
    for (std::size_t v = 0; v < polygon.vertices.size(); ++v) {
      if (space::side(plane, polygon.vertices[v]) == Sign::zero) {
        ++in_plane;
      } else {
        first_off = std::min(first_off, v);
      }
    }
    if (in_plane >= most) most = in_plane, outside = first_off;
    if (in_plane == polygon.vertices.size()) break;
  }
  const std::string of_cell = " is not in the face of cells[" + std::to_string(cell) + "] that ";
  if (outside < polygon.vertices.size()) {
    refuse(portal_name(i) + ".polygon.vertices[" + std::to_string(outside) + "]" + of_cell +
           (most == 0 ? "any is in" : "the others are in"));
  }
  for (std::size_t v = 0; v < polygon.vertices.size(); ++v) {
    if (locate(c, polygon.vertices[v]) == Location::outside) {
      refuse(portal_name(i) + ".polygon.vertices[" + std::to_string(v) + "]" + of_cell + "its plane holds");
    }
  }
}

/// On which side of the plane its cell is.
Sign side_of_cell(const ThreePoints& plane, const ConvexPolyhedron3& cell) {
  for (const Point3& v : cell.mesh.vertices) {
    if (const Sign s = space::side(plane, v); s != Sign::zero) return s;
  }
  return Sign::zero;
}

}  // namespace

PortalCells::PortalCells(std::vector<ConvexPolyhedron3> cells, std::vector<Portal> portals)
    : cells_(std::move(cells)), portals_(std::move(portals)), first_portal_(cells_.size() + 1, 0) {
  std::vector<Aabb3> boxes;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    check_polyhedron(cells_[i], "PortalCells: cells[" + std::to_string(i) + "]");
    boxes.push_back(fit_aabb(std::span<const Point3>(cells_[i].mesh.vertices)));
  }
  boxes_ = build_octree(boxes, {.rule = CellRule::every_leaf});
  for (std::size_t i = 0; i < portals_.size(); ++i) {
    const auto& [a, b] = portals_[i].cells;
    for (const std::uint32_t cell : {a, b}) {
      if (cell >= cells_.size()) {
        refuse(portal_name(i) + " names cell " + std::to_string(cell) + " of " + std::to_string(cells_.size()));
      }
    }
    if (a == b) refuse(portal_name(i) + " leads from cell " + std::to_string(a) + " into the same");
    check_polygon(i, portals_[i].polygon);
    check_in_face(*this, i, a);
    check_in_face(*this, i, b);
    const auto& vertices = portals_[i].polygon.vertices;
    ThreePoints plane = space::plane_of_chain(vertices.size(), [&](std::size_t k) { return vertices[k]; });
    const Sign before = side_of_cell(plane, cells_[a]);
    if (before != -side_of_cell(plane, cells_[b])) {
      refuse(portal_name(i) + " has cells " + std::to_string(a) + " and " + std::to_string(b) + " on one side");
    }
    planes_.push_back(before == Sign::positive ? plane : space::turned_round(plane));
  }
  for (const Portal& p : portals_) ++first_portal_[p.cells[0] + 1], ++first_portal_[p.cells[1] + 1];
  for (std::size_t c = 0; c < cells_.size(); ++c) first_portal_[c + 1] += first_portal_[c];
  portals_of_.resize(2 * portals_.size());
  std::vector<std::uint32_t> next(first_portal_.begin(), first_portal_.end() - 1);
  for (std::uint32_t i = 0; i < portals_.size(); ++i) {
    for (const std::uint32_t cell : portals_[i].cells) portals_of_[next[cell]++] = i;
  }
}

std::array<Point3, 3> PortalCells::plane_before(std::uint32_t portal, std::uint32_t cell) const {
  return portals_[portal].cells[0] == cell ? planes_[portal] : space::turned_round(planes_[portal]);
}

std::vector<std::uint32_t> PortalCells::cells_holding(const Point3& point, std::vector<std::uint32_t> rows) const {
  rows.clear();
  figure::require_finite_parts<Point3>("PortalCells::cells_holding", {"point"}, point);
  for (const std::uint32_t cell : in_box(boxes_, {point, point})) {
    if (contains(cells_[cell], point)) rows.push_back(cell);
  }
  return rows;
}

std::vector<std::uint32_t> PortalCells::portals_at(const Point3& point, std::vector<std::uint32_t> rows) const {
  rows.clear();
  for (const std::uint32_t cell : cells_holding(point)) {
    for (const std::uint32_t portal : portals_of(cell)) {
      // Each from the first of its cells.
      if (portals_[portal].cells[0] == cell && contains(portals_[portal].polygon, point)) rows.push_back(portal);
    }
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void PortalCells::require_cell(std::string_view function, std::uint32_t cell) const {
  if (cell < cells_.size()) return;
  throw InvalidShape(std::string(function) + ": there is no cell " + std::to_string(cell) + " among " +
                     std::to_string(cells_.size()));
}

}  // namespace plumb
