// The digest's answers about many figures: boxes, hulls, trees, sections, solids.
#include <map>

#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/ray/inside.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "plumb/surface/section/section.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "tool/doctor/digest.hpp"

namespace plumb::tool {
namespace {

/// The boundary of some cells of a grid: closed, with walls that meet at edges and corners; each vertex is where it
/// was in the grid, or moved a little.
TriangleMesh digest_cells(Entropy& e, std::int64_t side, bool is_moved) {
  std::map<std::array<std::int64_t, 3>, std::uint32_t> filled, numbers;
  for (std::int64_t x = 0; x < side; ++x) {
    for (std::int64_t y = 0; y < side; ++y) {
      for (std::int64_t z = 0; z < side; ++z) {
        if (e.below(2) == 0) filled[{x, y, z}] = 1;
      }
    }
  }
  TriangleMesh mesh;
  const auto vertex = [&](const std::array<std::int64_t, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) {
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = static_cast<double>(at[k]) + (is_moved ? static_cast<double>(e.within(1000)) * 0x1p-14 : 0);
      mesh.vertices.push_back({p[0], p[1], p[2]});
    }
    return found->second;
  };
  for (const auto& [cell, one] : filled) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::int64_t step : {-1, 1}) {
        std::array<std::int64_t, 3> beside = cell;
        beside[axis] += step;
        if (filled.contains(beside)) continue;
        std::array<std::uint32_t, 4> ring{};  // counterclockwise about the axis
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<std::int64_t, 3> corner = cell;
          corner[axis] += (step + 1) / 2;
          corner[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
          corner[(axis + 2) % 3] += k >= 2 ? 1 : 0;
          ring[k] = vertex(corner);
        }
        if (step < 0) std::swap(ring[1], ring[3]);
        mesh.triangles.push_back({ring[0], ring[1], ring[2]});
        mesh.triangles.push_back({ring[0], ring[2], ring[3]});
      }
    }
  }
  return mesh;
}

double digest_number(Entropy& e, std::int64_t side) {
  return static_cast<double>(e.below(16 * static_cast<std::uint64_t>(side))) / 16;
}
Point3 digest_place(Entropy& e, std::int64_t side) {
  const double x = digest_number(e, side), y = digest_number(e, side), z = digest_number(e, side);
  return {x, y, z};
}

TriangleMesh digest_shifted(TriangleMesh mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}

}  // namespace

void answer_boxes(HashedAnswers& to, std::uint64_t times) {
  std::vector<Aabb3> boxes;
  std::vector<Aabb2> flat;
  Entropy e(5);
  for (std::uint64_t i = 0; i < 400 * times; ++i) {
    const Point3 min = digest_place(e, 10);
    const Point3 size = digest_place(e, 1);
    boxes.push_back({min, {min.x + 2 * size.x, min.y + size.y, min.z + size.z}});
    flat.push_back({{min.x, min.y}, {min.x + size.x / 4, min.y + size.y / 4}});
  }
  const auto add = [&to](const std::vector<BoxPair>& pairs) {
    to.add(pairs.size());
    for (const BoxPair& p : pairs) to.add(p.a), to.add(p.b);
  };
  add(overlapping_pairs(std::span<const Aabb3>(boxes)));
  add(overlapping_pairs(std::span<const Aabb2>(flat)));
}

void answer_hulls(HashedAnswers& to, std::uint64_t times) {
  std::uint64_t number = 0;
  for (std::uint64_t i = 0; i < 3 * times; ++i) {
    for (const FamilyInfo& f : families) {
      for (const Degeneracy about : degeneracies) {
        Entropy e(6, number++);
        to.add(convex_hull(points2(f.family, about, 12, e)).vertices);
        const Hull3 hull = convex_hull(points3(f.family, about, 12, e));
        to.add(hull.dimension), to.add(hull.corners), to.add(hull.first);
      }
    }
  }
}

void answer_trees(HashedAnswers& to, std::uint64_t times) {
  constexpr std::int64_t side = 5;
  for (std::uint64_t i = 0; i < 2; ++i) {
    Entropy e(7, i);
    const TriangleMesh mesh = digest_cells(e, side, i == 1);
    const Bvh tree = build_bvh(mesh), other = build_bvh(digest_shifted(mesh, {0.5, 0.25, i == 0 ? 0 : 0x1p-30}));
    for (const TrianglePair& p : intersecting_pairs(tree, other)) to.add(p.a), to.add(p.b), to.add(p.relation);
    for (const TrianglePair& p : intersecting_pairs(tree)) to.add(p.a), to.add(p.b), to.add(p.relation);
    to.add(distance(tree, build_bvh(digest_shifted(mesh, {side + 1.25, side + 1.5, 0.125}))));
    std::vector<Point3> points;
    std::vector<AnyRay> rays;
    for (std::uint64_t k = 0; k < 400 * times; ++k) {
      points.push_back(digest_place(e, side));
      const Point3 to_where = digest_place(e, side), from = points.back();
      rays.emplace_back(Ray3{from, {to_where.x - from.x, to_where.y - from.y, to_where.z - from.z + 0x1p-10}});
    }
    std::vector<std::optional<NumberedHit>> hits(rays.size());
    first_hit(tree, rays, hits);
    for (const auto& hit : hits) {
      to.add(hit.has_value());
      if (hit) to.add(hit->index), to.add(hit->hit.t), to.add(hit->hit.point);
    }
    std::vector<Location> where(points.size());
    locate(tree, points, where);
    to.add(where);
    std::vector<ClosestOnMesh> closest(points.size());
    closest_on_mesh(tree, points, closest);
    for (const ClosestOnMesh& c : closest) to.add(c.triangle), to.add(c.point), to.add(c.distance);
    const KdTree3 places = build_kd_tree(points);
    std::vector<NearestPoint> nearest_places(3 * points.size());
    nearest(places, mesh.vertices, 3, std::span(nearest_places).first(3 * mesh.vertices.size()));
    for (const NearestPoint& n : std::span(nearest_places).first(3 * mesh.vertices.size()))
      to.add(n.index), to.add(n.distance);
    to.add(within(places, std::span<const Point3>(mesh.vertices), 0.25).numbers);
  }
}

void answer_sections(HashedAnswers& to, std::uint64_t times) {
  for (std::uint64_t i = 0; i < times; ++i) {
    Entropy e(8, i);
    const TriangleMesh mesh = digest_cells(e, 4, i % 2 == 1);
    std::vector<AnyPlane3> planes;
    for (int k = 0; k < 8; ++k) {
      const Vector3 normal{static_cast<double>(e.within(2)), static_cast<double>(e.within(2)), 1};
      planes.emplace_back(Plane3{normal, static_cast<double>(e.below(9)) / 2});
    }
    for (const Section& cut : sections(mesh, planes)) {
      to.add(cut.cut_triangles), to.add(cut.touching_corners), to.add(cut.canceled_segments);
      for (const Contour& c : cut.contours) {
        to.add(c.closed), to.add(c.turn), to.add(c.depth), to.add(c.parent.value_or(~0U)), to.add(c.corners.size());
        for (const SectionCorner& corner : c.corners) to.add(corner.nearest);
      }
    }
  }
}

/// What real arithmetic says of them, however the faces are cut into triangles: points where the surfaces meet, volume,
/// where places lie; and what is wrong with the meshes they were made of.
void answer_solids(HashedAnswers& to, std::uint64_t times) {
  constexpr std::int64_t side = 3;
  for (std::uint64_t i = 0; i < times; ++i) {
    Entropy e(9, i);
    const bool is_moved = i % 2 == 1;
    const TriangleMesh a = digest_cells(e, side, false);
    TriangleMesh b = digest_cells(e, side, is_moved);
    if (is_moved) b = digest_shifted(b, {0.5, 0.25, 0.125});
    const SurfaceFaults faults = find_faults(a);
    to.add(faults.shells.size()), to.add(faults.non_manifold_edges), to.add(faults.non_manifold_vertices);
    to.add(faults.met.touching), to.add(faults.met.overlapping);
    const std::array meshes{a, b};
    for (const ExactMesh& exact : {unite(meshes), intersect(meshes), subtract(meshes), symmetric_difference(meshes)}) {
      for (const ExactPoint3& p : exact.vertices) to.add(approximate(p));
      to.add(exact_volume(exact).rounded());
      const Bvh tree = build_bvh(round(exact).mesh);
      std::vector<Point3> places;
      for (int k = 0; k < 40; ++k) {  // off the surfaces by more than rounding moves them
        const Point3 p = digest_place(e, side);
        places.push_back({p.x + 0x1p-7, p.y + 0x1p-8, p.z + 0x1p-9});
      }
      std::vector<Location> where(places.size());
      locate(tree, places, where);
      to.add(where);
    }
  }
}

}  // namespace plumb::tool
