#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "arith/root_bounds.hpp"
#include "figure/basic/mesh_input.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/measures/measures.hpp"

namespace plumb {
namespace {

using arith::exact_sum::Number;
using figure::signed_sums::cross;
using figure::signed_sums::dot;
using figure::signed_sums::vector;
using figure::signed_sums::VectorOf;

/// For each vertex the smallest number of one at the same place.
std::vector<std::uint32_t> places(const std::vector<Point3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), place(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto less = [&](std::uint32_t i, std::uint32_t j) {
    const Point3 &a = vertices[i], &b = vertices[j];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    if (a.z != b.z) return a.z < b.z;
    return i < j;
  };
  std::sort(order.begin(), order.end(), less);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && vertices[order[k]] == vertices[order[k - 1]];
    place[order[k]] = same ? place[order[k - 1]] : order[k];
  }
  return place;
}

/// Edges passed from the smaller vertex to the larger, and those passed the other way, each sorted; as a pair of
/// vertices in one word.
struct DirectedEdges {
  std::vector<std::uint64_t> up, down;
};

template <class Faces, class Name>
DirectedEdges directed_edges(const Faces& faces, const Name& name) {
  DirectedEdges edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corners = faces[f];
    std::uint64_t a = name(corners.back());
    for (const std::uint32_t corner : corners) {
      const std::uint64_t b = name(corner);
      if (a < b) edges.up.push_back(a << 32 | b);
      if (a > b) edges.down.push_back(b << 32 | a);
      a = b;
    }
  }
  std::sort(edges.up.begin(), edges.up.end());
  std::sort(edges.down.begin(), edges.down.end());
  return edges;
}

/// Every edge must be passed as often one way as the other, by number or else by place.
template <class Mesh>
void require_closed(std::string_view function, const Mesh& mesh) {
  const auto faces = faces_of(mesh);
  DirectedEdges edges = directed_edges(faces, [](std::uint32_t v) { return v; });
  if (edges.up == edges.down) return;
  const std::vector<std::uint32_t> place = places(mesh.vertices);
  edges = directed_edges(faces, [&](std::uint32_t v) { return place[v]; });
  if (edges.up == edges.down) return;
  const auto& [up, down] = edges;
  std::size_t k = 0;
  while (k < up.size() && k < down.size() && up[k] == down[k]) ++k;
  const std::uint64_t edge = k == down.size() || (k < up.size() && up[k] < down[k]) ? up[k] : down[k];
  const auto times = [edge](const std::vector<std::uint64_t>& list) {
    const auto range = std::equal_range(list.begin(), list.end(), edge);
    return std::to_string(range.second - range.first);
  };
  throw_invalid_mesh(function, std::string("the mesh is open: the edge of vertices ")
                                   .append(std::to_string(edge >> 32))
                                   .append(" and ")
                                   .append(std::to_string(edge & 0xffffffffu))
                                   .append(" is passed ")
                                   .append(times(up))
                                   .append(" times one way and ")
                                   .append(times(down))
                                   .append(" the other; it must be equally often"));
}

/// Calls visit(a, b, c) for the triangles of all faces, as fans, with corners relative to the first vertex.
template <class Maker, class Faces, class Visit>
void for_each_triangle(const Maker& number, const Faces& faces, const Visit& visit) {
  using V = VectorOf<Maker>;
  if (faces.size() == 0) return;
  const V origin = vector(number, faces.at(0));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corners = faces[f];
    const V a = vector(number, faces.at(corners[0])) - origin;
    V b = vector(number, faces.at(corners[1])) - origin;
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const V c = vector(number, faces.at(corners[k])) - origin;
      visit(a, b, c);
      b = c;
    }
  }
}

template <class Mesh>
double sum_of_volumes(const Mesh& mesh) {
  return arith::exact_sum::nearest(
      [&](const auto& number) {
        using V = VectorOf<std::decay_t<decltype(number)>>;
        auto sum = number(0.0);
        for_each_triangle(number, faces_of(mesh),
                          [&](const V& a, const V& b, const V& c) { sum = sum + dot(a, cross(b, c)); });
        return sum;
      },
      6);
}

template <class Mesh>
Point3 volume_centroid(const Mesh& mesh) {
  if (mesh.vertices.empty()) throw InvalidShape("centroid: the mesh has no vertices; give at least one");
  const auto found = arith::exact_sum::nearest_quotients<3>([&](const auto& number) {
    using T = Number<std::decay_t<decltype(number)>>;
    using V = VectorOf<std::decay_t<decltype(number)>>;
    V sum = figure::signed_sums::zero(number);
    T whole = number(0.0);
    for_each_triangle(number, faces_of(mesh), [&](const V& a, const V& b, const V& c) {
      const T part = dot(a, cross(b, c));
      sum = sum + part * (a + b + c);
      whole = whole + part;
    });
    whole = number(4.0) * whole;
    const V moved = sum + whole * vector(number, mesh.vertices[0]);
    return std::array<T, 4>{moved.x, moved.y, moved.z, whole};
  });
  if (found.degenerate) return centroid(std::span<const Point3>(mesh.vertices));
  const Point3 c{found.value[0], found.value[1], found.value[2]};
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z))
    throw BeyondDoubles("centroid: the mesh's centroid is beyond all doubles");
  return c;
}

template <class Mesh>
double sum_of_areas(const Mesh& mesh) {
  const auto faces = faces_of(mesh);
  return arith::exact_sum::sum_of_roots(
      faces.size(),
      [&](const auto& number, std::size_t f) {
        const auto corners = faces[f];
        const auto n = figure::signed_sums::twice_vector_area(
            number, corners.size(), [&](std::size_t k) -> const Point3& { return faces.at(corners[k]); });
        return dot(n, n);
      },
      2);
}

template <class Mesh>
double checked_volume(std::string_view function, const Mesh& mesh) {
  require_mesh(function, mesh);
  require_closed(function, mesh);
  return sum_of_volumes(mesh);
}

template <class Mesh>
double checked_area(const Mesh& mesh) {
  require_mesh("surface_area", mesh);
  return sum_of_areas(mesh);
}

template <class Mesh>
Point3 checked_centroid(const Mesh& mesh) {
  require_mesh("centroid", mesh);
  require_closed("centroid", mesh);
  return volume_centroid(mesh);
}

}  // namespace

double signed_volume(const TriangleMesh& mesh) { return checked_volume("signed_volume", mesh); }
double signed_volume(const PolygonMesh& mesh) { return checked_volume("signed_volume", mesh); }
double volume(const TriangleMesh& mesh) { return std::fabs(checked_volume("volume", mesh)); }
double volume(const PolygonMesh& mesh) { return std::fabs(checked_volume("volume", mesh)); }
double volume(const ConvexPolyhedron3& polyhedron) { return checked_volume("volume", polyhedron.mesh); }

double surface_area(const TriangleMesh& mesh) { return checked_area(mesh); }
double surface_area(const PolygonMesh& mesh) { return checked_area(mesh); }
double surface_area(const ConvexPolyhedron3& polyhedron) { return checked_area(polyhedron.mesh); }

double surface_area(const Tetrahedron3& t) {
  figure::require_sound("surface_area", t);
  return surface_area(TriangleMesh{{t.a, t.b, t.c, t.d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
}

Point3 centroid(const TriangleMesh& mesh) { return checked_centroid(mesh); }
Point3 centroid(const PolygonMesh& mesh) { return checked_centroid(mesh); }
Point3 centroid(const ConvexPolyhedron3& polyhedron) { return checked_centroid(polyhedron.mesh); }

}  // namespace plumb
