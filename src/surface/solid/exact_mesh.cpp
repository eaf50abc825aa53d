#include "plumb/surface/solid/exact_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "certify/exact_coordinates.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "plumb/arith/error.hpp"
#include "surface/solid/mesh_in_order.hpp"
#include "surface/solid/point_table.hpp"

namespace plumb {
namespace {

using ExactImage = figure::PoseNumbers<BigDyadic>;

ExactPoint3 image_under(const ExactImage& by, const ExactPoint3& p) {
  const auto [at, weight] = certify::meeting::coordinates_in<BigDyadic>(p);
  const auto [x, y, z] = by.turned({at[0], at[1], at[2]}) + by.translation * weight;
  return surface::in_plain_form(
      certify::meeting::rational(certify::meeting::Weighted<BigDyadic, 3>{{x, y, z}, weight * by.weight}));
}

bool is_mirror(const ExactImage& by) {
  return dot(cross(by.columns[0], by.columns[1]), by.columns[2]).sign() == Sign::negative;
}

bool is_identity(const PoseView& pose) {
  return pose.visit([](const auto& is) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(is)>, Pose>)
      return is == identity_pose;
    else
      return false;
  });
}

/// Makes equal vertices one, and puts the mesh in order.
ExactMesh ordered_mesh(std::vector<ExactPoint3> vertices,
                       std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles) {
  std::vector<std::uint32_t> order(vertices.size()), number(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(
      order, [&](std::uint32_t a, std::uint32_t b) { return compare_xyz(vertices[a], vertices[b]) == Sign::negative; });
  std::vector<ExactPoint3> sorted;
  for (const std::uint32_t v : order) {
    if (sorted.empty() || sorted.back() != vertices[v]) sorted.push_back(std::move(vertices[v]));
    number[v] = static_cast<std::uint32_t>(sorted.size() - 1);
  }
  for (auto& [corners, source] : triangles)
    for (std::uint32_t& v : corners) v = number[v];
  return surface::mesh_in_order(std::move(sorted), std::move(triangles));
}

void require_finite_vertex(const ExactPoint3& p, std::size_t vertex) {
  const auto* given = std::get_if<Point3>(&p.as());
  if (given != nullptr && !(given->x - given->x == 0 && given->y - given->y == 0 && given->z - given->z == 0))
    throw NonFinite("exact_mesh: a coordinate of vertex " + std::to_string(vertex) + " is not a finite number");
}

template <class Mesh, class SourceOf>
ExactMesh mesh_under(const Mesh& mesh, PoseView pose, const SourceOf& source_of) {
  figure::require_sound("exact_mesh", pose);
  const ExactImage by = figure::pose_numbers<BigDyadic>(pose);
  const bool stays = is_identity(pose), is_turned = is_mirror(by);
  std::vector<std::uint8_t> is_named(mesh.vertices.size());
  std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleMesh::Triangle corners = mesh.triangles[t];
    for (const std::uint32_t v : corners) {
      if (v >= mesh.vertices.size())
        throw InvalidShape("exact_mesh: triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                           ", and there are " + std::to_string(mesh.vertices.size()));
      is_named[v] = 1;
    }
    if (is_turned) std::swap(corners[1], corners[2]);
    triangles.emplace_back(corners, source_of(t));
  }
  std::vector<ExactPoint3> vertices(mesh.vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (is_named[v] == 0) continue;
    require_finite_vertex(mesh.vertices[v], v);
    vertices[v] = stays ? surface::in_plain_form(mesh.vertices[v]) : image_under(by, mesh.vertices[v]);
  }
  return ordered_mesh(std::move(vertices), std::move(triangles));
}

Rational six_fold_volume(const std::vector<RationalPoint3>& at, std::span<const TriangleMesh::Triangle> triangles) {
  if (triangles.empty()) return 0;
  if (triangles.size() == 1) {
    const auto& [i, k, l] = triangles[0];
    const RationalPoint3 &a = at[i], &b = at[k], &c = at[l];
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  // Halves are summed, so that few sums have the denominators of many.
  const std::size_t half = triangles.size() / 2;
  return six_fold_volume(at, triangles.first(half)) + six_fold_volume(at, triangles.subspan(half));
}

}  // namespace

Rational exact_volume(const ExactMesh& mesh) {
  std::vector<RationalPoint3> at;
  at.reserve(mesh.vertices.size());
  for (const ExactPoint3& p : mesh.vertices) at.push_back(rational_point(p));
  return six_fold_volume(at, mesh.triangles) / Rational(6);
}

ExactMesh exact_mesh(const TriangleMesh& mesh, PoseView pose) {
  return mesh_under(mesh, pose, [](std::size_t t) { return SourceFace{0, static_cast<std::uint32_t>(t)}; });
}

ExactMesh exact_mesh(const ExactMesh& mesh, PoseView pose) {
  if (mesh.sources.size() != mesh.triangles.size())
    throw UnequalLengths("exact_mesh: there are " + std::to_string(mesh.sources.size()) + " sources of " +
                         std::to_string(mesh.triangles.size()) + " triangles; give one for each");
  return mesh_under(mesh, pose, [&](std::size_t t) { return mesh.sources[t]; });
}

}  // namespace plumb
