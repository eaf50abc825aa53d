// How is a plane polygon, convex or not, cut into triangles that all turn the same way?
//
// Laws: with success, triangles turn as asked or have zero area, and not all of them zero; then they cover every point
// as often as the polygon winds around it, for the winding number is the sum of theirs.  A simple polygon, corners on
// straight edges included, succeeds without any zero area: its ears are the leaves of a triangulation, and one whose
// closed triangle holds no other corner leaves a simple polygon behind.  There only corners that are not strictly
// convex can stand in the way of an ear (of those in its triangle, the one nearest the tip sees a half plane inside),
// and cutting one off makes or unmakes an ear at its two neighbors only (the polygon shrinks, and no other diagonal can
// have crossed an ear).
// Source: RTCD 12.5.1; Meisters 1975 (two ears).
// Cost: for each ear the corners in its x-range that are not convex.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::surface {

using Corners = std::span<const std::uint32_t>;

class EarClipping {
 public:
  EarClipping(std::span<const Point2> points, Sign turn);

  /// False, and `out` as before, when the polygon cannot be cut so.
  bool run(Corners corners, std::vector<TriangleMesh::Triangle>& out);

 private:
  // What may be cut off.  The second and third are for polygons that touch themselves.
  enum class Ears { empty_closed, flat, empty_open };

  struct Obstacle {
    Point2 at;  // here, too, for the sake of the cache
    std::uint32_t corner;
  };

  bool is_ear(std::uint32_t i, Ears ears) const;
  void note_turn(std::uint32_t i);
  bool blocks(std::uint32_t u, std::uint32_t i, Ears ears) const;
  bool edges_enter(std::uint32_t u, const Point2& corner, const Point2& from, const Point2& to) const;
  bool turns(const Point2& a, const Point2& b, const Point2& c) const;
  bool folds_back(std::uint32_t i) const;
  void clip(std::uint32_t i, Corners corners, std::vector<TriangleMesh::Triangle>& out);
  void clip_folds(std::uint32_t i, Corners corners, std::vector<TriangleMesh::Triangle>& out);
  bool clip_all(Ears ears, Corners corners, std::vector<TriangleMesh::Triangle>& out);

  std::span<const Point2> points_;
  Sign turn_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<Obstacle> by_x_;  // corners that may stand in the way; the others leave from time to time
  std::vector<bool> clipped_, convex_;
  std::deque<std::uint32_t> candidates_;  // first come, first served: going around keeps the triangles small
  std::size_t left_, idle_ = 0;           // corners left; clipped since by_x_ was last cleaned
  bool has_area_ = false;
};

}  // namespace plumb::surface
