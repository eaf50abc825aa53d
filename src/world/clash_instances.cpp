#include "world/clash_instances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "plumb/arith/error_free.hpp"

namespace plumb::world {
namespace {

auto coordinates_of(const Point3& p) { return std::tie(p.x, p.y, p.z); }

/// Nothing where a difference is no double.
bool is_moved_exactly(const TriangleMesh& mesh, const Point3& origin) {
  const auto exact = [](double x, double o) {
    const Rounded r = two_sum(x, -o);
    return r.error == 0 && std::isfinite(r.value);
  };
  return std::ranges::all_of(mesh.vertices, [&](const Point3& p) {
    return exact(p.x, origin.x) && exact(p.y, origin.y) && exact(p.z, origin.z);
  });
}

/// No zero has a sign.
Point3 moved_to(const Point3& p, const Point3& origin) {
  return {p.x - origin.x + 0.0, p.y - origin.y + 0.0, p.z - origin.z + 0.0};
}

std::uint64_t hash_of(const TriangleMesh& mesh, const Point3& origin) {
  std::uint64_t hash = mesh.triangles.size();
  const auto take = [&hash](std::uint64_t x) { hash = (std::rotl(hash, 23) ^ x) * 0x9e3779b97f4a7c15U; };
  for (const Point3& vertex : mesh.vertices) {
    const Point3 p = moved_to(vertex, origin);
    for (const double x : {p.x, p.y, p.z}) take(std::bit_cast<std::uint64_t>(x));
  }
  for (const auto& corners : mesh.triangles)
    for (const std::uint32_t v : corners) take(v);
  return hash;
}

bool is_one_shape(const TriangleMesh& a, const Point3& from_a, const TriangleMesh& b, const Point3& from_b) {
  return a.triangles == b.triangles &&
         std::ranges::equal(a.vertices, b.vertices, [&](const Point3& p, const Point3& q) {
           return moved_to(p, from_a) == moved_to(q, from_b);
         });
}

}  // namespace

std::vector<PlacedShape> placed_shapes(std::span<const TriangleMesh> parts) {
  std::vector<PlacedShape> all;
  std::unordered_multimap<std::uint64_t, std::uint32_t> known;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh& mesh = parts[i];
    PlacedShape placed{i, {}};
    const bool moves = !mesh.vertices.empty() && is_moved_exactly(mesh, mesh.vertices[0]);
    if (moves) placed.origin = mesh.vertices[0];
    const std::uint64_t hash = hash_of(mesh, placed.origin) + (moves ? 1 : 0);
    const auto [first, last] = known.equal_range(hash);
    const auto same = std::find_if(first, last, [&](const auto& k) {
      const bool other_moves = !parts[k.second].vertices.empty() && all[k.second].origin == parts[k.second].vertices[0];
      return moves == other_moves && is_one_shape(parts[k.second], all[k.second].origin, mesh, placed.origin);
    });
    if (same != last)
      placed.shape = same->second;
    else
      known.emplace(hash, i);
    all.push_back(placed);
  }
  return all;
}

PlacedPair placed_pair(const PlacedShape& a, const PlacedShape& b) {
  const auto part = [](double to, double from) { return two_sum(to, -from); };
  const Rounded x = part(b.origin.x, a.origin.x), y = part(b.origin.y, a.origin.y), z = part(b.origin.z, a.origin.z);
  return {a.shape, b.shape, {x.value, x.error, y.value, y.error, z.value, z.error}};
}

bool comes_after(const TriangleMesh& a, const TriangleMesh& b) {
  if (a.triangles.size() != b.triangles.size()) return a.triangles.size() > b.triangles.size();
  const auto before = [](const Point3& p, const Point3& q) { return coordinates_of(p) < coordinates_of(q); };
  if (std::ranges::lexicographical_compare(b.vertices, a.vertices, before)) return true;
  if (std::ranges::lexicographical_compare(a.vertices, b.vertices, before)) return false;
  return b.triangles < a.triangles;
}

}  // namespace plumb::world
