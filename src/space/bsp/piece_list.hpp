// What does a plane leave of pieces on either side?  Convex pieces of polygons, cut exactly.
//
// Each corner carries doubles near it, a guess: it is for choosing planes and for looking for a point in a leaf, and
// decides nothing.
// Laws: a piece without a corner strictly behind the plane goes to the front as it is, and the other way round; one
// whose corners are all in the plane is coplanar.  Of a piece that is cut each part has its corners in the order of
// the piece.
// Source: RTCD 8.3.3, 8.3.4; Sutherland and Hodgman 1974.
// Cost: a sign a corner; each cut makes two corners.
#pragma once

#include "space/bsp/plane_side.hpp"

namespace plumb::space {

struct GuessedCorner {
  BspCorner corner;
  Point3 guess;
};

struct ListedPiece {
  std::uint32_t face;
  std::uint32_t first, count;  // of the list's corners
  bool is_used;                // its plane is that of a node above
};

struct PieceList {
  std::vector<ListedPiece> pieces;
  std::vector<GuessedCorner> corners;

  [[nodiscard]] std::span<const GuessedCorner> corners_of(const ListedPiece& p) const {
    return std::span(corners).subspan(p.first, p.count);
  }
  void add(std::uint32_t face, std::span<const GuessedCorner> its_corners, bool is_used);
};

struct DividedPieces {
  PieceList front, back, coplanar;
  std::size_t splits = 0;
};

DividedPieces divided(const BspTree& tree, const PieceList& list, std::uint32_t plane);

/// Of the corners of a polygon as given.
void add_polygon(const BspTree& tree, std::uint32_t face, PieceList& list);

/// About how far the point is in front, in any unit that is the same for all points.
class GuessedPlane {
 public:
  GuessedPlane(const BspTree& tree, std::uint32_t plane);
  [[nodiscard]] double operator()(const Point3& p) const {
    return (p.x - at_.x) * normal_.x + (p.y - at_.y) * normal_.y + (p.z - at_.z) * normal_.z;
  }
  [[nodiscard]] const Vector3& normal() const { return normal_; }

 private:
  Point3 at_;
  Vector3 normal_;  // of a length near one
};

}  // namespace plumb::space
