#include "surface/file/assembly.hpp"

#include <limits>

namespace plumb::surface {

void Assembly::charge(std::uint64_t count, std::uint64_t bytes_each) {
  if (count > left_ / bytes_each)
    fail_at_file(MeshFileProblem::too_large, parse_.file,
                 "its parts make more than " + std::to_string(parse_.limit) +
                     " bytes, expected no more; raise the limit if you trust it");
  left_ -= count * bytes_each;
}

void Assembly::also_read(std::uint64_t bytes) {
  parse_.read += bytes;
  const std::uint64_t limit = unpacked_limit(parse_.read, parse_.options);
  left_ += limit - parse_.limit;
  parse_.limit = limit;
}

std::uint32_t Assembly::place(std::span<const Point3> vertices, const Placement& placement, const std::string& part) {
  charge(vertices.size(), sizeof(Point3));
  auto& all = parse_.mesh.vertices;
  const std::size_t first = all.size();
  if (vertices.size() > std::numeric_limits<std::uint32_t>::max() - first)
    fail_at_file(MeshFileProblem::unsupported, parse_.file,
                 "more than 4294967295 vertices, expected fewer; cut the mesh up");
  Placed placed;
  for (const Point3& p : vertices) {
    const auto moved = placement(p, placed);
    if (!moved)
      fail_at_file(MeshFileProblem::bad_number, parse_.file,
                   part + ": its transform takes vertex " + std::to_string(all.size() - first) +
                       " beyond the largest double, expected a place within; mend the transform");
    all.push_back(*moved);
  }
  parse_.report.transformed += placed.coordinates;
  parse_.report.rounded += placed.inexact;
  return static_cast<std::uint32_t>(first);
}

void Assembly::add(std::span<const TriangleMesh::Triangle> triangles, std::uint32_t first, const Placement& placement) {
  charge(triangles.size(), 4 * sizeof(std::uint32_t));
  const bool mirrored = !placement.is_identity() && placement.mirrors();
  for (const auto& t : triangles) {
    const std::array<std::uint32_t, 3> corners{t[0], mirrored ? t[2] : t[1], mirrored ? t[1] : t[2]};
    for (const std::uint32_t v : corners) parse_.mesh.corners.push_back(first + v);
    parse_.end_face();
  }
}

}  // namespace plumb::surface
