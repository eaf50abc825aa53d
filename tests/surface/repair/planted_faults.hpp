// Faults planted in a closed mesh, each by its name, away from one another as long as the mesh is large.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::planted {

inline constexpr std::array<std::string_view, 10> faults{
    "repeated vertex", "hole",       "wide hole",     "turned triangle", "duplicate",
    "opposite",        "T-junction", "flat triangle", "unused vertex",   "inside out"};

/// False where the mesh has no place for it.
inline bool plant(std::string_view fault, TriangleMesh& mesh, std::mt19937& random) {
  const auto t = static_cast<std::uint32_t>(random() % mesh.triangles.size());
  const TriangleMesh::Triangle corners = mesh.triangles[t];
  const auto [a, b, c] = corners;
  const auto add = [&mesh](const Point3& p) {
    mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  };
  if (fault == "repeated vertex") {
    mesh.triangles[t][0] = add(Point3{mesh.vertices[a]});
  } else if (fault == "hole") {
    mesh.triangles.erase(mesh.triangles.begin() + t);
  } else if (fault == "wide hole") {  // all triangles at a vertex: what is left is filled without it
    const std::uint32_t v = corners[0];
    std::erase_if(mesh.triangles, [v](const auto& s) { return std::ranges::count(s, v) != 0; });
  } else if (fault == "turned triangle") {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  } else if (fault == "duplicate") {
    mesh.triangles.push_back({b, c, a});
  } else if (fault == "opposite") {
    mesh.triangles.push_back({b, a, c});
  } else if (fault == "T-junction") {  // one side of an edge is divided at its middle, where that is exact
    const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    const Point3 middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
    if (!collinear(p, middle, q)) return false;
    const std::uint32_t m = add(middle);
    mesh.triangles[t] = {a, m, c};
    mesh.triangles.push_back({m, b, c});
  } else if (fault == "flat triangle") {
    mesh.triangles.push_back({a, b, a});
  } else if (fault == "unused vertex") {
    add({1e6, -3, 7});
  } else if (fault == "inside out") {
    for (auto& s : mesh.triangles) std::swap(s[1], s[2]);
  }
  return true;
}

}  // namespace plumb::planted
