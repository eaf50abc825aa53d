// BSP tree: what do planes make of space, and of the polygons in it?  Planes of the polygons' own and planes across the
// axes, the pieces that they leave of each polygon, and convex leaves.
//
//   const BspTree tree = build_bsp(mesh);                      // build_bsp.hpp
//   tree.report.depth, tree.report.splits
//   tree.pieces[i].face, tree.corners_of(i)                    // which polygon a piece is of, and its exact corners
//
// Laws: (1) no coordinate is made: a corner of a piece is a vertex as given, or where an edge as given meets a plane,
// or where the polygon's plane meets two others.  So the pieces of a polygon cover it without gaps, none is a sliver, and
// no plane is thick.  (2) The front of a polygon's plane is where its corners are seen to turn counterclockwise, the front
// of a plane across an axis where the coordinate is greater.  (3) Each leaf is a closed convex set with inner points;
// leaves have their borders in common, and nothing else.  (4) Nodes stand before what is below them.
// A corner's edge or plane is a number: an edge of the polygon as it counts its corners, `face_plane` and a face, or
// `axis_plane` and a number in axis_planes.
// Source: RTCD 8.1, 8.2.1, 8.2.2, 8.2.3, 8.3.4, 8.3.5, 8.3.6.
// Cost: 24 bytes a node, 12 a corner, 8 a piece; report.bytes counts all.  Nothing is searched.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

/// Where are the pieces, and what is told of leaves?
/// node_storing: at the node in whose plane they are.  leaf_storing: in the leaves.  solid_leaf: as node_storing, and
/// each leaf is told to be in the solid that the mesh bounds, or outside.
enum class BspKind : unsigned char { node_storing, leaf_storing, solid_leaf };

/// A node, or a leaf.
struct BspChild {
  std::uint32_t code;

  static constexpr std::uint32_t leaf_bit = 0x80000000, solid_bit = 0x40000000;
  [[nodiscard]] constexpr bool is_leaf() const { return (code & leaf_bit) != 0; }
  [[nodiscard]] constexpr bool is_solid() const { return (code & solid_bit) != 0; }
  /// In nodes, or in the leaves.
  [[nodiscard]] constexpr std::uint32_t index() const { return code & ~(leaf_bit | solid_bit); }
  friend bool operator==(const BspChild&, const BspChild&) = default;
};

struct BspNode {
  double at;            // where a plane across an axis is
  std::uint32_t axis;   // 0, 1, 2; 3 where it is the plane of a face
  std::uint32_t plane;  // by its number
  BspChild front, back;
};

struct BspCorner {
  std::uint32_t first, second;  // a vertex of the face and no_plane, an edge and a plane, or two planes
  std::uint32_t edge;           // to the next corner: one of the face, or a plane

  static constexpr std::uint32_t face_plane = 0x80000000, axis_plane = 0xc0000000, no_plane = 0xffffffff;
  friend bool operator==(const BspCorner&, const BspCorner&) = default;
};

struct BspPiece {
  std::uint32_t face;
  std::uint32_t first_corner;  // up to that of the next piece
};

struct BspAxisPlane {
  std::uint32_t axis;
  double at;
};

struct BspReport {
  std::size_t nodes = 0, axis_nodes = 0, leaves = 0, solid_leaves = 0;
  std::size_t depth = 0;          // nodes above the deepest leaf
  std::size_t longest_chain = 0;  // nodes one below the other with a leaf at their sides
  std::size_t pieces = 0;
  std::size_t splits = 0;               // pieces that a plane cut in two
  std::size_t faces_left_out = 0;       // without area: they have no plane
  std::size_t leaves_by_rationals = 0;  // in which no double was found, so that rational points tell what they are
  std::size_t bytes = 0;
};

struct BspTree {
  BspKind kind = BspKind::node_storing;
  BspChild root{BspChild::leaf_bit};
  std::vector<BspNode> nodes;
  std::vector<std::uint32_t> first_piece{0};  // of a node, or of a leaf of a leaf-storing tree; and one more
  std::vector<BspPiece> pieces;               // and one more
  std::vector<BspCorner> corners;
  std::vector<BspAxisPlane> axis_planes;
  std::vector<std::array<Point3, 3>> planes;  // of the faces
  PolygonMesh mesh;                           // as given
  double reach = 1;                           // a coordinate that no other exceeds, for points of axis planes
  BspReport report;

  /// The pieces of a node, or of a leaf of a leaf-storing tree, by their numbers.
  [[nodiscard]] std::size_t piece_count() const { return pieces.empty() ? 0 : pieces.size() - 1; }
  [[nodiscard]] std::span<const BspCorner> piece_corners(std::size_t piece) const {
    return std::span(corners).subspan(pieces[piece].first_corner,
                                      pieces[piece + 1].first_corner - pieces[piece].first_corner);
  }
  /// Counterclockwise seen from the front of its face.
  [[nodiscard]] std::vector<ExactPoint3> corners_of(std::size_t piece, std::vector<ExactPoint3> rows = {}) const;
  /// Three points of a plane by its number, counterclockwise seen from its front.
  [[nodiscard]] std::array<Point3, 3> points_of_plane(std::uint32_t plane) const;
  [[nodiscard]] const Point3& vertex(std::uint32_t face, std::uint32_t corner) const {
    const std::uint32_t first = mesh.first[face], count = mesh.first[face + 1] - first;
    return mesh.vertices[mesh.corners[first + (corner < count ? corner : corner - count)]];
  }
};

}  // namespace plumb
