#include "space/bsp/checked_polygons.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "figure/basic/mesh_input.hpp"
#include "space/cells/three_points.hpp"

namespace plumb::space {
namespace {

[[noreturn]] void refuse_face(std::size_t face, std::string_view what) {
  throw InvalidShape(std::string("build_bsp: face ")
                         .append(std::to_string(face))
                         .append(" is not ")
                         .append(what)
                         .append("; triangulate it"));
}

void require_convex(const PolygonFaces& faces, std::size_t face) {
  const auto named = faces[face];
  const auto corner = [&](std::size_t k) { return faces.at(named[k]); };
  const ThreePoints plane = plane_of_chain(named.size(), corner);
  const Sign turn = coplanar_orientation(plane[0], plane[1], plane[2]);
  if (turn == Sign::zero) return;  // on one line
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (side(plane, corner(i)) != Sign::zero) refuse_face(face, "planar");
    for (std::size_t j = 0; j < named.size(); ++j) {
      const Sign s = coplanar_orientation(corner(i), corner((i + 1) % named.size()), corner(j));
      if (s * turn == Sign::negative) refuse_face(face, "convex");
    }
  }
}

/// Of each vertex the number of the first one at its place.
std::vector<std::uint32_t> places(const std::vector<Point3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::uint32_t v) { return std::array{vertices[v].x, vertices[v].y, vertices[v].z}; };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto p = key(a), q = key(b);
    return p < q || (p == q && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || key(order[i - 1]) != key(order[i]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

}  // namespace

void require_convex_faces(const PolygonMesh& mesh) {
  require_mesh("build_bsp", mesh);
  const PolygonFaces faces{mesh};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].size() > 3) require_convex(faces, f);
  }
}

void require_closed(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> place = places(mesh.vertices);
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = place[t[i]], b = place[t[(i + 1) % 3]];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto at = edges.begin(); at != edges.end();) {
    const auto end = std::upper_bound(at, edges.end(), *at);
    if ((end - at) % 2 != 0) {
      throw InvalidShape(
          std::string("build_bsp: the mesh is not closed: an odd number of faces has the edge of vertices ")
              .append(std::to_string((*at)[0]))
              .append(" and ")
              .append(std::to_string((*at)[1]))
              .append("; mend it, or ask for node_storing"));
    }
    at = end;
  }
}

TriangleMesh fans_of(const PolygonMesh& mesh) {
  TriangleMesh fans{mesh.vertices, {}};
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
    for (std::uint32_t i = mesh.first[f] + 1; i + 1 < mesh.first[f + 1]; ++i)
      fans.triangles.push_back({mesh.corners[mesh.first[f]], mesh.corners[i], mesh.corners[i + 1]});
  }
  return fans;
}

}  // namespace plumb::space
