// Rooms to test with: a lattice of boxes, sheared, with portals of many kinds in their walls.
#pragma once

#include <cmath>
#include <vector>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/space/cells/portal_cells.hpp"

namespace plumb::rooms {

/// A map of whole numbers, which rounds nothing here.
struct Shear {
  double xy = 0, xz = 0, yz = 0;
  [[nodiscard]] Point3 operator()(double x, double y, double z) const { return {x + xy * y + xz * z, y + yz * z, z}; }
};

inline ConvexPolyhedron3 box(const Shear& shear, const Point3& low, const Point3& high) {
  PolygonMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        shear((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z));
  }
  for (const auto& face : {std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}, std::array{0u, 1u, 5u, 4u},
                           std::array{2u, 6u, 7u, 3u}, std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}}) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return convex_polyhedron(std::move(mesh));
}

struct Made {
  std::vector<ConvexPolyhedron3> cells;
  std::vector<Portal> portals;
  Shear shear;
  int nx, ny, nz;
  [[nodiscard]] PortalCells rooms() const { return {cells, portals}; }
};

/// Cells of side 1; in each wall none, one, or two portals that may touch: rectangles of eighths, triangles, whole
/// walls.
inline Made lattice(Entropy& e, int nx, int ny, int nz) {
  Made made;
  made.nx = nx, made.ny = ny, made.nz = nz;
  if (e.coin())
    made.shear = {static_cast<double>(e.within(1)), static_cast<double>(e.within(1)), static_cast<double>(e.within(1))};
  const auto number = [&](int x, int y, int z) { return static_cast<std::uint32_t>((z * ny + y) * nx + x); };
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        made.cells.push_back(box(made.shear, {1.0 * x, 1.0 * y, 1.0 * z}, {x + 1.0, y + 1.0, z + 1.0}));
      }
    }
  }
  const auto wall = [&](int x, int y, int z, int axis) {
    const std::uint32_t a = number(x, y, z), b = number(x + (axis == 0), y + (axis == 1), z + (axis == 2));
    const auto at = [&](double u, double v) {
      if (axis == 0) return made.shear(x + 1.0, y + u, z + v);
      if (axis == 1) return made.shear(x + u, y + 1.0, z + v);
      return made.shear(x + u, y + v, z + 1.0);
    };
    const auto rectangle = [&](double u, double v, double s, double t) {
      Portal p{{a, b}, {{at(u, v), at(s, v), at(s, t), at(u, t)}}};
      if (e.coin()) p = {{b, a}, {{at(u, v), at(u, t), at(s, t), at(s, v)}}};
      made.portals.push_back(p);
    };
    const auto eighth = [&](std::uint64_t from, std::uint64_t to) {
      return static_cast<double>(from + e.below(to - from + 1)) / 8;
    };
    switch (e.below(6)) {
      case 0:
        break;
      case 1:
        rectangle(0, 0, 1, 1);
        break;
      case 2:
        rectangle(0, 0, 0.5, 0.5), rectangle(0.5, 0.5, 1, 1);  // touch in a vertex
        break;
      case 3:
        made.portals.push_back({{a, b}, {{at(eighth(0, 3), 0), at(1, eighth(1, 8)), at(0.5, 1)}}});
        break;
      default:
        rectangle(eighth(0, 3), eighth(0, 3), eighth(4, 8), eighth(4, 8));
    }
  };
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        if (x + 1 < nx) wall(x, y, z, 0);
        if (y + 1 < ny) wall(x, y, z, 1);
        if (z + 1 < nz) wall(x, y, z, 2);
      }
    }
  }
  return made;
}

/// Of quarters, so that it often is in a wall, an edge or a corner; in the lattice.
inline Point3 place(const Made& made, Entropy& e) {
  const auto along = [&](int n) { return static_cast<double>(e.below(static_cast<std::uint64_t>(8 * n + 1))) / 8; };
  const double x = along(made.nx), y = along(made.ny), z = along(made.nz);
  return made.shear(x, y, z);
}

}  // namespace plumb::rooms
