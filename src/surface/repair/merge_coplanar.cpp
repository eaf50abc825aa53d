// Which triangle a face grows from first is a guess; what joins it is decided exactly.
#include "plumb/surface/repair/merge_coplanar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "figure/basic/mesh_input.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/surface/topology/adjacency.hpp"
#include "surface/repair/face_rings.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/repair/weld_groups.hpp"
#include "surface/topology/between.hpp"
#include "surface/topology/region_rings.hpp"

namespace plumb {
namespace {

using surface::comes_before;
using Vertices = std::vector<std::uint32_t>;

constexpr std::uint32_t no_face = std::numeric_limits<std::uint32_t>::max();

std::array<Point3, 3> corners_of(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// A guess: some four times the square of the area, the same however the triangle is numbered.
double guessed_size(std::array<Point3, 3> p) {
  std::ranges::sort(p, comes_before);
  const double ux = p[1].x - p[0].x, uy = p[1].y - p[0].y, uz = p[1].z - p[0].z;
  const double vx = p[2].x - p[0].x, vy = p[2].y - p[0].y, vz = p[2].z - p[0].z;
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const double size = x * x + y * y + z * z;
  return std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
}

/// In the order in which faces may grow from them.
Vertices seeds_of(const TriangleMesh& mesh, double tolerance) {
  Vertices order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  if (tolerance == 0) return order;  // a plane is that of any of its triangles
  std::vector<double> size(order.size());
  for (std::uint32_t t = 0; t < order.size(); ++t) size[t] = guessed_size(corners_of(mesh, t));
  std::ranges::sort(order, [&](std::uint32_t l, std::uint32_t r) {
    if (size[l] != size[r]) return size[l] > size[r];
    std::array<Point3, 3> p = corners_of(mesh, l), q = corners_of(mesh, r);
    std::ranges::sort(p, comes_before), std::ranges::sort(q, comes_before);
    return std::ranges::lexicographical_compare(p, q, comes_before);
  });
  return order;
}

/// A triangle's plane, and what joins it.
class PlaneOfFace {
 public:
  PlaneOfFace(const TriangleMesh& mesh, std::uint32_t triangle, double tolerance)
      : mesh_(mesh), corners_(corners_of(mesh, triangle)), tolerance_(tolerance) {
    const auto& [a, b, c] = corners_;
    spans_ = !collinear(a, b, c);
    if (!spans_) return;
    look_ = look_at_plane(a, b, c);
    turn_ = turn_of(triangle);
  }
  [[nodiscard]] bool spans() const { return spans_; }
  [[nodiscard]] Look look() const { return look_; }
  [[nodiscard]] Sign turn() const { return turn_; }
  /// Of a triangle whose other corners are near enough.
  [[nodiscard]] bool takes(std::uint32_t triangle, std::uint32_t third) const {
    return turn_of(triangle) == turn_ && is_near(mesh_.vertices[third]);
  }

 private:
  [[nodiscard]] Sign turn_of(std::uint32_t triangle) const {
    const std::array<Point3, 3> p = corners_of(mesh_, triangle);
    return orient2d(projected(look_, p[0]), projected(look_, p[1]), projected(look_, p[2]));
  }
  [[nodiscard]] bool is_near(const Point3& p) const {
    const auto& [a, b, c] = corners_;
    return tolerance_ == 0 ? orient3d(a, b, c, p) == Sign::zero
                           : compare_distance_to_plane(a, b, c, p, tolerance_) != Sign::positive;
  }

  const TriangleMesh& mesh_;
  std::array<Point3, 3> corners_;
  double tolerance_;
  bool spans_ = false;
  Look look_ = Look::along_z;
  Sign turn_ = Sign::zero;
};

/// A face while it is made; rings are those of its triangles, the outer one first.
struct GrownFace {
  std::uint32_t plane;
  Vertices triangles;
  std::vector<Vertices> rings;
};

class CoplanarGrowth {
 public:
  CoplanarGrowth(const TriangleMesh& mesh, double tolerance)
      : mesh_(mesh),
        tolerance_(tolerance),
        twin_(half_edges(mesh, find_edges(mesh)).twin),
        face_(mesh.triangles.size(), no_face),
        rings_(mesh.triangles, twin_, face_),
        uses_(mesh.vertices.size()) {
    for (const auto& corners : mesh.triangles)
      for (const std::uint32_t v : corners) ++uses_[v];
    for (const std::uint32_t seed : seeds_of(mesh, tolerance))
      if (face_[seed] == no_face) grow(seed);
    for (GrownFace& f : faces) std::ranges::sort(f.triangles);
    std::ranges::sort(faces, {}, [](const GrownFace& f) { return f.triangles[0]; });
    std::ranges::sort(apart);
  }

  std::vector<GrownFace> faces;
  Vertices apart;

 private:
  void grow(std::uint32_t seed) {
    const PlaneOfFace plane(mesh_, seed, tolerance_);
    GrownFace grown{seed, {seed}, {}};
    const auto number = static_cast<std::uint32_t>(faces.size());
    face_[seed] = number;
    for (std::size_t i = 0; i < grown.triangles.size() && plane.spans(); ++i) {
      for (std::uint32_t h = 3 * grown.triangles[i]; h < 3 * grown.triangles[i] + 3; ++h) {
        const std::uint32_t beyond = twin_[h];
        if (beyond == no_half_edge || face_[beyond / 3] != no_face) continue;
        if (!plane.takes(beyond / 3, from(previous_half_edge(beyond)))) continue;
        face_[beyond / 3] = number;
        grown.triangles.push_back(beyond / 3);
      }
    }
    grown.rings = rings_.of(grown.triangles);
    for (Vertices& ring : grown.rings) surface::begin_with_first(mesh_.vertices, ring);
    if (grown.triangles.size() > 2 && (has_shared_midst(grown) || !order_rings(grown, plane))) {
      take_apart(grown);
    } else {
      faces.push_back(std::move(grown));
    }
  }

  [[nodiscard]] std::uint32_t from(std::uint32_t h) const { return mesh_.triangles[h / 3][h % 3]; }

  /// Would the polygon lose a vertex in its midst that triangles of others have?
  [[nodiscard]] bool has_shared_midst(const GrownFace& face) const {
    Vertices named, on_rings;
    for (const std::uint32_t t : face.triangles)
      named.insert(named.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    for (const Vertices& ring : face.rings) on_rings.insert(on_rings.end(), ring.begin(), ring.end());
    std::ranges::sort(named), std::ranges::sort(on_rings);
    for (auto v = named.begin(); v != named.end();) {
      const auto end = std::upper_bound(v, named.end(), *v);
      if (static_cast<std::uint32_t>(end - v) != uses_[*v] && !std::ranges::binary_search(on_rings, *v)) return true;
      v = end;
    }
    return false;
  }

  /// False where the rings are those of no polygon.
  [[nodiscard]] bool order_rings(GrownFace& face, const PlaneOfFace& plane) const {
    const std::vector<surface::RingOfVertices> rings(face.rings.begin(), face.rings.end());
    if (!surface::triangles_within(mesh_.vertices, rings, plane.look(), plane.turn())) return false;
    const auto is_hole = [&](const Vertices& ring) {
      std::vector<Point2> seen;
      for (const std::uint32_t v : ring) seen.push_back(projected(plane.look(), mesh_.vertices[v]));
      return figure::signed_sums::area_sign(seen) != plane.turn();
    };
    const auto holes = std::stable_partition(face.rings.begin(), face.rings.end(),
                                             [&](const Vertices& ring) { return !is_hole(ring); });
    const auto before = [&](std::uint32_t l, std::uint32_t r) {
      return comes_before(mesh_.vertices[l], mesh_.vertices[r]);
    };
    std::sort(holes, face.rings.end(),
              [&](const Vertices& l, const Vertices& r) { return std::ranges::lexicographical_compare(l, r, before); });
    return true;
  }

  void take_apart(const GrownFace& face) {
    apart.push_back(*std::ranges::min_element(face.triangles));
    for (const std::uint32_t t : face.triangles) {
      face_[t] = static_cast<std::uint32_t>(faces.size());
      Vertices ring(mesh_.triangles[t].begin(), mesh_.triangles[t].end());
      surface::begin_with_first(mesh_.vertices, ring);
      faces.push_back({t, {t}, {std::move(ring)}});
    }
  }

  const TriangleMesh& mesh_;
  double tolerance_;
  Vertices twin_, face_;
  surface::RegionRings rings_;
  Vertices uses_;  // of each vertex by triangles
};

/// Do all rings run straight through a vertex?
std::vector<std::uint8_t> straight_vertices(const TriangleMesh& mesh, const std::vector<GrownFace>& faces) {
  surface::RingNeighbors beside(mesh.vertices.size());
  std::vector<std::uint8_t> keeps(mesh.vertices.size()), straight(mesh.vertices.size());
  for (const GrownFace& f : faces) {
    for (const Vertices& ring : f.rings) beside.add(ring);
    const auto& [a, b, c] = mesh.triangles[f.triangles[0]];
    if (f.triangles.size() == 1 && collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]))
      keeps[a] = keeps[b] = keeps[c] = 1;
  }
  const auto between = [&](std::uint32_t a, std::uint32_t v, std::uint32_t b) {
    return surface::is_strictly_between(mesh.vertices[a], mesh.vertices[v], mesh.vertices[b]);
  };
  for (std::uint32_t v = 0; v < straight.size(); ++v) straight[v] = keeps[v] == 0 && beside.is_straight(v, between);
  return straight;
}

}  // namespace

CoplanarFaces merge_coplanar(const TriangleMesh& mesh, const CoplanarOptions& options) {
  surface::require_tolerance("merge_coplanar", options.tolerance);
  require_mesh("merge_coplanar", mesh);
  CoplanarGrowth growth(mesh, options.tolerance);
  std::vector<std::uint8_t> dropped(mesh.vertices.size());
  if (options.collinear == CollinearVertices::dropped) dropped = straight_vertices(mesh, growth.faces);
  CoplanarFaces made;
  made.apart = std::move(growth.apart);
  for (const GrownFace& f : growth.faces) {
    for (const Vertices& ring : f.rings) {
      for (const std::uint32_t v : ring)
        if (dropped[v] == 0) made.corners.push_back(v);
      made.first_corner.push_back(static_cast<std::uint32_t>(made.corners.size()));
    }
    made.first_ring.push_back(static_cast<std::uint32_t>(made.first_corner.size() - 1));
    made.triangles.insert(made.triangles.end(), f.triangles.begin(), f.triangles.end());
    made.first_triangle.push_back(static_cast<std::uint32_t>(made.triangles.size()));
    made.plane.push_back(f.plane);
  }
  return made;
}

TriangleMesh triangulated(const TriangleMesh& mesh, const CoplanarFaces& faces) {
  std::vector<std::vector<TriangleMesh::Triangle>> instead(mesh.triangles.size());
  std::vector<std::uint8_t> left_out(mesh.triangles.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto before = faces.triangles_of(f);
    if (faces.fewest_triangles(f) >= before.size()) continue;
    const PlaneOfFace plane(mesh, faces.plane[f], 0);
    auto within = surface::triangles_within(mesh.vertices, faces.rings_of(f), plane.look(), plane.turn());
    if (!within) throw InvalidShape("triangulated: the faces are not those of the mesh");
    for (const std::uint32_t t : before) left_out[t] = 1;
    instead[before[0]] = std::move(*within);
  }
  TriangleMesh out{mesh.vertices, {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (left_out[t] == 0) out.triangles.push_back(mesh.triangles[t]);
    out.triangles.insert(out.triangles.end(), instead[t].begin(), instead[t].end());
  }
  return out;
}

}  // namespace plumb
