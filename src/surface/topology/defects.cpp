#include "plumb/surface/topology/defects.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>

#include "figure/basic/lists_by_number.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "space/bvh/parts.hpp"
#include "surface/topology/between.hpp"
#include "surface/topology/box_around.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/mesh_corner.hpp"

namespace plumb {
namespace {

using surface::is_strictly_between;
using surface::names_a_vertex_twice;
using surface::place_of;

constexpr std::size_t vertices_of_block = 1024;
constexpr auto none = std::numeric_limits<std::uint32_t>::max();

/// The boxes that have a point of this one, as boxes are rounded.
struct MeetsBox {
  std::array<float, 3> below, above;

  MeetsBox(const BoxFrame& frame, const Aabb3& box)
      : below{frame.below(box.min.x), frame.below(box.min.y), frame.below(box.min.z)},
        above{frame.above(box.max.x), frame.above(box.max.y), frame.above(box.max.z)} {}
  bool operator()(const BoxNode& node) const {
    bool holds = true;
    for (std::size_t k = 0; k < 3; ++k) holds = holds && node.min[k] <= above[k] && below[k] <= node.max[k];
    return holds;
  }
};

std::uint32_t number_of_edge(const MeshEdges& edges, std::uint32_t a, std::uint32_t b) {
  const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
  return static_cast<std::uint32_t>(std::ranges::lower_bound(edges.edges, edge) - edges.edges.begin());
}

/// Each block's list behind the one before.
template <class Item>
std::vector<Item> joined(const std::vector<std::vector<Item>>& blocks) {
  std::vector<Item> all;
  for (const auto& block : blocks) all.insert(all.end(), block.begin(), block.end());
  return all;
}

void require_length(std::string_view function, double length) {
  if (!(length - length == 0))
    throw NonFinite(std::string(function) + ": the length is not a real number; give a finite one");
  if (length < 0) throw InvalidShape(std::string(function) + ": the length is negative; give one of at least 0");
}

/// The vertices within the length of a box about an edge that are by that edge, as is_by(a, vertex, b) tells.
template <class IsBy>
std::vector<VertexOnEdge> vertices_by_edges(const MeshEdges& edges, const Bvh& bvh, double length, Execution execution,
                                            const IsBy& is_by) {
  const auto vertices = bvh.vertices.view();
  const auto triangles = bvh.triangles.view();
  std::vector<bool> used(vertices.size());
  for (const auto& t : triangles)
    for (const std::uint32_t v : t) used[v] = true;
  std::vector<std::vector<VertexOnEdge>> found(space::blocks_of(vertices.size(), vertices_of_block));
  space::for_blocks(execution, vertices.size(), vertices_of_block,
                    [&](std::size_t block, std::size_t from, std::size_t to) {
                      std::vector<VertexOnEdge>& list = found[block];
                      for (std::size_t v = from; v < to; ++v) {
                        if (!used[v]) continue;
                        const std::size_t before = list.size();
                        const MeetsBox near(bvh.tree.frame, surface::box_around(vertices[v], vertices[v], length));
                        descend(bvh.tree, near, [&](std::uint32_t first, std::uint32_t count) {
                          for (std::uint32_t slot = first; slot < first + count; ++slot) {
                            const auto& t = triangles[slot];
                            if (names_a_vertex_twice(t)) continue;
                            for (std::size_t k = 0; k < 3; ++k) {
                              const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                              if (a != v && b != v && is_by(vertices[a], vertices[v], vertices[b]))
                                list.push_back({static_cast<std::uint32_t>(v), number_of_edge(edges, a, b)});
                            }
                          }
                        });
                        const auto of_vertex = list.begin() + static_cast<std::ptrdiff_t>(before);
                        std::sort(of_vertex, list.end());
                        list.erase(std::unique(of_vertex, list.end()), list.end());
                      }
                    });
  return joined(found);
}

}  // namespace

std::vector<std::uint32_t> non_manifold_vertices(const TriangleMesh& mesh, const MeshEdges& edges) {
  surface::DisjointSets corners(3 * mesh.triangles.size());
  const auto corner = [&](std::uint32_t triangle, std::uint32_t vertex) {
    return 3 * triangle + place_of(mesh.triangles[triangle], vertex);
  };
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    for (std::size_t i = 1; i < uses.size(); ++i) {
      for (const std::uint32_t v : edges.edges[e]) corners.unite(corner(uses[0].face, v), corner(uses[i].face, v));
    }
  }
  std::vector<std::uint8_t> fans(mesh.vertices.size());  // 0, 1, or 2 for more
  for (std::uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    const TriangleMesh::Triangle& t = mesh.triangles[c / 3];
    if (names_a_vertex_twice(t) || corners.find(c) != c) continue;
    std::uint8_t& of_vertex = fans[t[c % 3]];
    of_vertex = of_vertex == 0 ? 1 : 2;
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < fans.size(); ++v)
    if (fans[v] == 2) found.push_back(v);
  return found;
}

std::vector<VertexOnEdge> vertices_on_edges(const MeshEdges& edges, const Bvh& bvh, Execution execution) {
  return vertices_by_edges(edges, bvh, 0, execution, is_strictly_between);
}

std::vector<VertexOnEdge> vertices_near_edges(const MeshEdges& edges, const Bvh& bvh, double length,
                                              Execution execution) {
  require_length("vertices_near_edges", length);
  auto near = vertices_by_edges(edges, bvh, length, execution, [&](const Point3& a, const Point3& p, const Point3& b) {
    return surface::runs_by(a, p, b, length);
  });
  std::erase_if(near, [&](const VertexOnEdge& on) {
    return std::ranges::any_of(edges.uses_of(on.edge), [&](const EdgeUse& u) { return u.opposite == on.vertex; });
  });
  return near;
}

std::vector<CoincidentTriangle> coincident_triangles(const TriangleMesh& mesh, std::span<const std::uint32_t> first) {
  struct Placed {
    std::array<std::uint32_t, 2> others;  // beside the least, ascending
    std::uint32_t triangle;
    bool turned;  // against that order
    [[nodiscard]] auto order() const { return std::tie(others, triangle); }
  };
  const auto points = [&](std::uint32_t t) {
    const auto& [i, j, k] = mesh.triangles[t];
    return TriangleMesh::Triangle{first[i], first[j], first[k]};
  };
  std::vector<std::uint32_t> least(mesh.triangles.size());
  for (std::uint32_t t = 0; t < least.size(); ++t)
    least[t] = names_a_vertex_twice(points(t)) ? none : std::ranges::min(points(t));
  const figure::ListsByNumber at_point(least, first.size());
  std::vector<CoincidentTriangle> found;
  std::vector<Placed> placed;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    placed.clear();
    for (const std::uint32_t t : at_point[v]) {
      TriangleMesh::Triangle p = points(t);
      std::rotate(p.begin(), std::ranges::find(p, v), p.end());
      placed.push_back({{std::min(p[1], p[2]), std::max(p[1], p[2])}, t, p[1] > p[2]});
    }
    std::ranges::sort(placed, {}, &Placed::order);
    const Placed* first_placed = nullptr;
    for (const Placed& p : placed) {
      if (first_placed == nullptr || first_placed->others != p.others) {
        first_placed = &p;
      } else {
        found.push_back({p.triangle, first_placed->triangle, p.turned != first_placed->turned});
      }
    }
  }
  std::ranges::sort(found, {}, &CoincidentTriangle::triangle);
  return found;
}
std::vector<CoincidentTriangle> coincident_triangles(const TriangleMesh& mesh) {
  return coincident_triangles(mesh, first_equal(mesh.vertices));
}

std::vector<CloseVertex> close_vertices(const TriangleMesh& mesh, double length, Execution execution) {
  require_length("close_vertices", length);
  const std::vector<std::uint32_t> first = first_equal(mesh.vertices);
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) used[first[v]] = true;
  std::vector<std::uint32_t> number;
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    number.push_back(v);
    points.push_back(mesh.vertices[v]);
  }
  if (points.size() < 2) return {};
  const KdTree3 tree = build_kd_tree(points, {.execution = execution});
  std::vector<std::vector<CloseVertex>> found(space::blocks_of(points.size(), vertices_of_block));
  space::for_blocks(execution, points.size(), vertices_of_block,
                    [&](std::size_t block, std::size_t from, std::size_t to) {
                      for (std::size_t i = from; i < to; ++i) {
                        const std::uint32_t k = nearest(tree, points[i], 2)[1].index;  // the first is the point itself
                        if (locate(Sphere3{points[i], length}, points[k]) == Location::inside)
                          found[block].push_back({number[i], number[k]});
                      }
                    });
  return joined(found);
}

}  // namespace plumb
