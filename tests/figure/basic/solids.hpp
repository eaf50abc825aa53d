// Closed surfaces with integer coordinates, so that much of them lies in a plane: boxes, voxels, tori, random heaps.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::solids {

using Cell = std::array<int, 3>;

/// The boundary of a set of unit cubes: squares between a cube and none, vertices shared.
inline TriangleMesh voxels(const std::set<Cell>& cells) {
  TriangleMesh mesh;
  std::map<Cell, std::uint32_t> number;
  const auto vertex = [&](const Cell& c) {
    const auto [at, is_new] = number.emplace(c, static_cast<std::uint32_t>(number.size()));
    if (is_new) mesh.vertices.push_back({double(c[0]), double(c[1]), double(c[2])});
    return at->second;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int out : {-1, 1}) {
        Cell beside = cell;
        beside[axis] += out;
        if (cells.contains(beside)) continue;
        const std::size_t u = (axis + (out > 0 ? 1 : 2)) % 3, v = (axis + (out > 0 ? 2 : 1)) % 3;
        Cell corner = cell;
        corner[axis] += out > 0;
        std::array<std::uint32_t, 4> square;
        for (std::size_t k = 0; k < 4; ++k) {
          Cell c = corner;
          c[u] += k == 1 || k == 2;
          c[v] += k >= 2;
          square[k] = vertex(c);
        }
        mesh.triangles.push_back({square[0], square[1], square[2]});
        mesh.triangles.push_back({square[0], square[2], square[3]});
      }
    }
  }
  return mesh;
}

inline void append(TriangleMesh& mesh, const TriangleMesh& other, bool inside_out = false) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back(inside_out ? TriangleMesh::Triangle{t[0] + n, t[2] + n, t[1] + n}
                                        : TriangleMesh::Triangle{t[0] + n, t[1] + n, t[2] + n});
  }
}

inline TriangleMesh box(const Point3& min, const Point3& max) {
  TriangleMesh mesh = voxels({{0, 0, 0}});
  for (Point3& p : mesh.vertices) p = {p.x == 0 ? min.x : max.x, p.y == 0 ? min.y : max.y, p.z == 0 ? min.z : max.z};
  return mesh;
}

/// Over a polygon from z = -1 to 1, without a bottom and a top.
inline TriangleMesh walls(std::span<const Point2> polygon) {
  TriangleMesh mesh;
  for (const Point2& p : polygon) mesh.vertices.insert(mesh.vertices.end(), {{p.x, p.y, -1}, {p.x, p.y, 1}});
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t i = 0; i < n; i += 2) {
    const std::uint32_t next = (i + 2) % n;
    mesh.triangles.insert(mesh.triangles.end(), {{i, next, next + 1}, {i, next + 1, i + 1}});
  }
  return mesh;
}

/// A square of n by n pillars of half the width of their cells, from the origin on, one to a cell.
inline TriangleMesh pillars(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t x = 0; x < n; ++x) {
    for (std::uint32_t y = 0; y < n; ++y) append(mesh, box({x + 0.25, y + 0.25, -1}, {x + 0.75, y + 0.75, 1}));
  }
  return mesh;
}

/// Around the z axis.
inline TriangleMesh torus(double far, double thick, std::uint32_t around, std::uint32_t across) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * k / across, r = far + thick * std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), thick * std::sin(v)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) { return i % around * across + k % across; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

/// A torus around the middle of another one that is wound inside out: solid between the two, with a hollow all around.
inline TriangleMesh hollow_torus(double far, double thick, std::uint32_t around, std::uint32_t across) {
  TriangleMesh mesh = torus(far, thick, around, across);
  append(mesh, torus(far, thick / 2, around, across), true);
  return mesh;
}

/// About the x axis, so that coordinates are rounded and faces stand askew.
inline TriangleMesh turned(TriangleMesh mesh) {
  for (Point3& p : mesh.vertices) p = {p.x, (3 * p.y - 4 * p.z) / 5, (4 * p.y + 3 * p.z) / 5};
  return mesh;
}

/// As it is where a reader lost some faces: those that `every` divides the number of.
inline TriangleMesh torn(TriangleMesh mesh, std::size_t every) {
  std::size_t number = 0;
  std::erase_if(mesh.triangles, [&](const auto&) { return number++ % every == 0; });
  return mesh;
}

/// Tetrahedra on a small grid: flat ones, touching ones, some wound inside out; closed all the same.
inline TriangleMesh heap(std::mt19937_64& random, int tetrahedra, int size) {
  TriangleMesh mesh;
  std::uniform_int_distribution<int> coordinate(-size, size);
  for (int i = 0; i < tetrahedra; ++i) {
    TriangleMesh one;
    for (int k = 0; k < 4; ++k)
      one.vertices.push_back({double(coordinate(random)), double(coordinate(random)), double(coordinate(random))});
    one.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    append(mesh, one);
  }
  return mesh;
}

}  // namespace plumb::solids
