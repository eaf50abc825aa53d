// Which solids are BSP trees built of?  Boxes, voxels, tori, what crosses itself, what is a few ulps thick.
#pragma once

#include <string>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bsp_cases {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

inline TriangleMesh any_voxels(std::uint64_t seed, int size) {
  Entropy e(41, seed);
  std::set<solids::Cell> cells;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < size; ++z) {
        if (e.below(3) == 0) cells.insert({x, y, z});
      }
    }
  }
  return solids::voxels(cells);
}

/// A wall of a few ulps.
inline TriangleMesh thin_wall() {
  TriangleMesh mesh = solids::box({1, 0, 0}, {1 + 0x1p-51, 1, 1});
  for (Point3& p : mesh.vertices) p = {p.x + 0.25 * p.y, p.y - 0.125 * p.z, p.z};
  return mesh;
}

/// Two tetrahedra through one another, one a copy of the other.
inline TriangleMesh crossing() {
  TriangleMesh one{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  TriangleMesh other = one;
  for (Point3& p : other.vertices) p = {3 - p.x, 3 - p.y, 3 - p.z};
  solids::append(one, other);
  return one;
}

/// About the origin, of radius one, with two poles: 2 around rows triangles.
inline TriangleMesh sphere(std::uint32_t around, std::uint32_t rows) {
  TriangleMesh ball;
  ball.vertices = {{0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 0; i < rows; ++i) {
    const double u = M_PI * (i + 1) / (rows + 1);
    for (std::uint32_t k = 0; k < around; ++k) {
      const double v = 2 * M_PI * k / around;
      ball.vertices.push_back({std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) { return 2 + i * around + k % around; };
  for (std::uint32_t k = 0; k < around; ++k) {
    ball.triangles.push_back({0, at(0, k), at(0, k + 1)});
    ball.triangles.push_back({1, at(rows - 1, k + 1), at(rows - 1, k)});
    for (std::uint32_t i = 0; i + 1 < rows; ++i) {
      ball.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      ball.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return ball;
}

inline std::vector<NamedMesh> closed_meshes() {
  std::vector<NamedMesh> all{{"box", solids::box({0, 0, 0}, {1, 2, 3})},
                             {"tiny box", solids::box({0, 0, 0}, {0x1p-300, 0x1p-299, 0x1p-301})},
                             {"voxels", any_voxels(1, 4)},
                             {"turned voxels", solids::turned(any_voxels(2, 3))},
                             {"torus", solids::torus(3, 1, 12, 8)},
                             {"hollow torus", solids::turned(solids::hollow_torus(3, 1, 10, 6))},
                             {"ring", meshes::ring(8)},
                             {"sphere", sphere(12, 7)},
                             {"pillars", solids::pillars(3)},
                             {"crossing", crossing()},
                             {"thin wall", thin_wall()}};
  std::mt19937_64 random(7);
  all.push_back({"heap", solids::heap(random, 12, 4)});
  return all;
}

/// Vertices, points of edges and faces and beside them, on the lattice, and anywhere.
inline std::vector<Point3> points_about(const TriangleMesh& mesh, std::uint64_t seed, std::size_t count) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    Entropy e(seed, i);
    const auto& t = mesh.triangles[e.below(mesh.triangles.size())];
    const Point3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const auto mixed = [&](double u, double v) {
      return Point3{a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y),
                    a.z + u * (b.z - a.z) + v * (c.z - a.z)};
    };
    const auto eighths = [&] { return static_cast<double>(e.within(12)) / 8; };
    switch (e.below(6)) {
      case 0:
        points.push_back(a);
        break;
      case 1:
        points.push_back(mixed(0.5, 0));
        break;
      case 2:
        points.push_back(mixed(0.25, 0.5));
        break;
      case 3:
        points.push_back(mixed(eighths(), eighths()));
        break;
      case 4: {
        const Point3 &p = mesh.vertices[e.below(mesh.vertices.size())],
                     &q = mesh.vertices[e.below(mesh.vertices.size())];
        points.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
        break;
      }
      default: {
        const Point3 p = mixed(eighths(), eighths());
        points.push_back({p.x * (1 + eighths() / 64), p.y, p.z * (1 + eighths() / 64)});
      }
    }
  }
  return points;
}

}  // namespace plumb::bsp_cases
