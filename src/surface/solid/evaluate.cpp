#include "plumb/surface/solid/evaluate.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "surface/file/placement.hpp"
#include "surface/solid/face_pool.hpp"

namespace plumb {
namespace {

/// Whose type tells evaluate that the leaf is a mesh.
struct MeshLeaf {
  TriangleMesh mesh;
};

Location place_in_leaf(const void* leaf, const Point3& p) {
  const auto winding = winding_number(static_cast<const MeshLeaf*>(leaf)->mesh, p);
  if (!winding) return Location::boundary;
  return *winding > 0 ? Location::inside : Location::outside;
}

[[noreturn]] void refuse_leaf(std::size_t number, const std::string& why) {
  throw InvalidShape("evaluate: leaf " + std::to_string(number) + " is " + why);
}

/// Do three edges from a corner turn as those of the axes do, or are they in one plane?
bool turns_as_axes(const Point3& corner, const Point3& x, const Point3& y, const Point3& z) {
  return orient3d(corner, x, y, z) != -orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
}

/// Corner i is at the greater end along axis k where bit k of i is set.
TriangleMesh mesh_of_eight(std::vector<Point3> corners) {
  TriangleMesh mesh{std::move(corners),
                    {{0, 2, 3},
                     {0, 3, 1},
                     {4, 5, 7},
                     {4, 7, 6},
                     {0, 1, 5},
                     {0, 5, 4},
                     {2, 6, 7},
                     {2, 7, 3},
                     {0, 4, 6},
                     {0, 6, 2},
                     {1, 3, 7},
                     {1, 7, 5}}};
  const auto& c = mesh.vertices;
  if (!turns_as_axes(c[0], c[1], c[2], c[4]))
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// The box of all places between these under the map, whose corners must be doubles.
TriangleMesh mapped_box(const surface::Placement& map, double least, std::size_t number, const char* name) {
  std::vector<Point3> corners;
  surface::Placed placed;
  for (unsigned i = 0; i < 8; ++i) {
    const auto end = [&](unsigned axis) { return (i >> axis) % 2 != 0 ? 1.0 : least; };
    const auto corner = map({end(0), end(1), end(2)}, placed);
    if (!corner || placed.inexact != 0)
      refuse_leaf(number, std::string(name) + " with a corner that no double holds; give a mesh of rounded corners");
    corners.push_back(*corner);
  }
  return mesh_of_eight(std::move(corners));
}

surface::Placement scaled_by(const Vector3& by, const Point3& to) {
  return surface::Placement({{{by.x, 0, 0, to.x}, {0, by.y, 0, to.y}, {0, 0, by.z, to.z}}});
}

TriangleMesh leaf_mesh(const MeshLeaf& leaf, std::size_t) { return leaf.mesh; }
TriangleMesh leaf_mesh(const Aabb3& b, std::size_t) {
  if (is_empty(b)) return {};
  std::vector<Point3> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.push_back(
        {i % 2 != 0 ? b.max.x : b.min.x, i / 2 % 2 != 0 ? b.max.y : b.min.y, i / 4 != 0 ? b.max.z : b.min.z});
  return mesh_of_eight(std::move(corners));
}
TriangleMesh leaf_mesh(const AabbWidths3& b, std::size_t number) {
  return mapped_box(scaled_by(b.widths, b.min), 0, number, "an AabbWidths3");
}
TriangleMesh leaf_mesh(const AabbCenter3& b, std::size_t number) {
  return mapped_box(scaled_by(b.half, b.center), -1, number, "an AabbCenter3");
}
TriangleMesh leaf_mesh(const Obb3& b, std::size_t number) {
  const auto& [u, v, w] = b.axes;
  const surface::Placement axes(
      {{{u.x, v.x, w.x, b.center.x}, {u.y, v.y, w.y, b.center.y}, {u.z, v.z, w.z, b.center.z}}});
  return mapped_box(axes * scaled_by(b.half, {0, 0, 0}), -1, number, "an Obb3");
}
TriangleMesh leaf_mesh(const Tetrahedron3& t, std::size_t) {
  TriangleMesh mesh{{t.a, t.b, t.c, t.d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  if (!turns_as_axes(t.a, t.b, t.c, t.d))
    for (auto& corners : mesh.triangles) std::swap(corners[1], corners[2]);
  return mesh;
}
TriangleMesh leaf_mesh(const ConvexPolyhedron3& p, std::size_t) { return triangulate(p.mesh); }

/// How leaves of a type become meshes.
struct LeafMesh {
  const void* type;
  TriangleMesh (*made)(const void* shape, std::size_t number);
};
template <class Shape>
constexpr LeafMesh way_to_mesh() {
  return {&figure::shape_tag<Shape>,
          [](const void* shape, std::size_t number) { return leaf_mesh(*static_cast<const Shape*>(shape), number); }};
}

struct RefusedLeaf {
  const void* type;
  const char* why;
};

TriangleMesh mesh_of_leaf(const Csg3::Leaf& leaf, std::size_t number) {
  static constexpr std::array meshes{way_to_mesh<MeshLeaf>(),         way_to_mesh<Aabb3>(), way_to_mesh<AabbWidths3>(),
                                     way_to_mesh<AabbCenter3>(),      way_to_mesh<Obb3>(),  way_to_mesh<Tetrahedron3>(),
                                     way_to_mesh<ConvexPolyhedron3>()};
  const auto by_type = [&](const auto& row) { return row.type == leaf.type; };
  if (const auto* const found = std::ranges::find_if(meshes, by_type); found != meshes.end())
    return found->made(leaf.shape.get(), number);
  static constexpr std::array refused{RefusedLeaf{&figure::shape_tag<Sphere3>, "a Sphere3, which is round"},
                                      RefusedLeaf{&figure::shape_tag<Capsule3>, "a Capsule3, which is round"},
                                      RefusedLeaf{&figure::shape_tag<Lozenge3>, "a Lozenge3, which is round"},
                                      RefusedLeaf{&figure::shape_tag<Cylinder3>, "a Cylinder3, which is round"},
                                      RefusedLeaf{&figure::shape_tag<Cone3>, "a Cone3, which is round"},
                                      RefusedLeaf{&figure::shape_tag<Ellipsoid3>, "an Ellipsoid3, which is round"},
                                      RefusedLeaf{&figure::shape_tag<Halfspace3>, "a Halfspace3, which is unbounded"},
                                      RefusedLeaf{&figure::shape_tag<Slab3>, "a Slab3, which is unbounded"},
                                      RefusedLeaf{&figure::shape_tag<Plane3>, "a Plane3, which bounds nothing"}};
  const auto* const named = std::ranges::find_if(refused, by_type);
  refuse_leaf(number,
              std::string(named != refused.end() ? named->why : "of a type that is not known to be flat-sided") +
                  "; give a mesh of it, csg(mesh)");
}

}  // namespace

Csg3 csg(TriangleMesh mesh) {
  surface::pool_faces({&mesh, 1});
  return Csg3(Csg3::Leaf{std::make_shared<const MeshLeaf>(MeshLeaf{std::move(mesh)}), &place_in_leaf, true,
                         &figure::shape_tag<MeshLeaf>});
}

ExactMesh evaluate(const Csg3& tree, Pieces pieces) {
  if (tree.holds_what([](std::size_t, bool complemented) { return complemented; }))
    throw InvalidShape("evaluate: the solid of the tree is unbounded; intersect it with one that is not");
  std::vector<TriangleMesh> meshes;
  for (std::size_t i = 0; i < tree.leaf_count(); ++i) meshes.push_back(mesh_of_leaf(tree.leaf(i), i));
  return solid_where(
      meshes,
      [&tree](std::span<const std::int32_t> windings) {
        return tree.holds_what(
            [&](std::size_t leaf, bool complemented) { return (windings[leaf] > 0) != complemented; });
      },
      pieces);
}

}  // namespace plumb
