// Clash, interference check: how do two parts of an assembly lie to one another, and which pairs of many are in each
// other's way?
//
//   const ClashPart bolt(read_mesh("bolt.stl")), plate(read_mesh("plate.stl"));
//   const Clash c = find_clash(bolt, plate, {.clearance = 0.05});
//   if (c.kind == ClashKind::overlapping) use(c.place, c.volume, c.depth);
//
// A part whose mesh is closed is a solid: the points around which the mesh winds, whichever way, and its triangles.  Any
// other is a sheet: its triangles.  The inside of a solid is the interior of those points; triangles that cancel one
// another bound nothing.
// Laws: (1) the first word that holds:
// - apart: no point in common, and farther from one another than the clearance, where one is asked for.
// - within clearance: no point in common, a distance of at most the clearance.
// - touching: points in common, but no point of an inside is in the other's inside, nor on a sheet.
// - duplicate: solids with the same inside; sheets of the same triangles.
// - enclosed: the inside of one is in the other's, or a sheet is in a solid; `inner` says which lies in the other.
// - piercing through: solids of which one, less the other, is in more pieces than it was.  Solids that have an edge or a
//   point in common alone are two pieces.
// - overlapping: any other.  Two sheets overlap where a triangle crosses one of another plane, both in their interiors;
//   sheets that pass through one another by edges and vertices alone, or lie on one another, touch.
// (2) All of it is decided in real arithmetic.  A number is the exact one, rounded once; a place is the rounding of an
// exact point of both parts, or of the point of the first that is nearest to the second.  (3) The answer depends on the
// two meshes alone, not on threads; with the parts the other way round the word, the volume and the depth are the same.
// (4) depth: the least translation after which the hulls are parted is `upper`; where both parts are convex that is
// the depth, and `lower` is the same.  Else no translation that is shorter than `lower` frees their insides, for so far
// a corner of one is inside the other.  (5) A number that is beyond all doubles is infinite.
// NaN and infinity throw NonFinite, a triangle that names no vertex InvalidShape, as build_bvh does.
// Source: RTCD 2.4.1; Requicha 1980 (regularized sets).
// Cost: of a part that of a tree, and n log n to see whether it is closed.  Of a pair that of intersecting_pairs and of
// cutting what meets; where insides have points in common that of arrange for both, but of simple solids that stay
// one piece each without the other.  Bounded by n^4 signs, as arrange is.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb {

enum class ClashKind : unsigned char { apart, within_clearance, touching, overlapping, piercing, enclosed, duplicate };
inline constexpr std::size_t clash_kinds = 7;

std::string_view name_of(ClashKind kind);  // "within clearance", "piercing through"

/// What is found out of a mesh once, for all pairs that it is in.
class ClashPart {
 public:
  explicit ClashPart(TriangleMesh mesh, Execution execution = Execution::parallel);
  /// The mesh is shared, not copied.
  explicit ClashPart(std::shared_ptr<const TriangleMesh> mesh, Execution execution = Execution::parallel);

  /// A component over vertices, and a vertex of it; components that bound nothing have none.
  static constexpr std::uint32_t no_shell = 0xffffffff;
  struct Shells {
    std::vector<std::uint32_t> of;        // each triangle
    std::vector<std::uint32_t> vertices;  // of each shell
  };

  [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const Bvh& bvh() const { return bvh_; }
  [[nodiscard]] bool empty() const { return mesh_->triangles.empty(); }
  /// It holds the triangles, or the origin where there are none.
  [[nodiscard]] const Aabb3& box() const { return box_; }
  /// Is it a solid?
  [[nodiscard]] bool is_solid() const { return solid_; }
  [[nodiscard]] const Shells& shells() const { return shells_; }
  /// Is it one surface, whose triangles have areas and meet in the edges and vertices that they share alone?  It is found
  /// out when it is first asked, from any thread.
  [[nodiscard]] bool is_simple() const;
  /// What each edge of a simple part has over it: the triangle, from each corner to the next.
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& neighbors() const;
  /// The corners of its hull, and whether that has the volume that the mesh bounds, which is below zero where triangles
  /// turn inward; not of an empty mesh.
  struct Hull {
    std::vector<Point3> corners;
    bool has_volume_of_part = false;
    double volume_of_part = 0;
  };
  [[nodiscard]] const Hull& hull() const;

  struct Surface;  // src/world/clash_surface.hpp

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::shared_ptr<Surface> surface_;
  Bvh bvh_;
  Aabb3 box_{};
  bool solid_ = false;
  Shells shells_;
};

/// The first part moves along `direction`, of length 1 but for rounding.
struct ClashDepth {
  double lower = 0, upper = 0;
  Vector3 direction{};
  friend bool operator==(const ClashDepth&, const ClashDepth&) = default;
};

struct Clash {
  ClashKind kind = ClashKind::apart;
  Point3 place{};                        // of any but apart
  std::optional<double> distance;        // of what is within clearance
  std::optional<std::uint32_t> inner{};  // 0 where the first lies in the second, 1 where the second in the first
  std::optional<double> volume{};        // in common: of two solids whose insides meet
  std::optional<ClashDepth> depth{};     // of the same
  std::vector<TrianglePair> meeting{};   // triangles that meet
};

struct ClashOptions {
  std::optional<double> clearance{};
  bool measure = true;  // volume and depth
};

Clash find_clash(const ClashPart& a, const ClashPart& b, const ClashOptions& options = {});

}  // namespace plumb
