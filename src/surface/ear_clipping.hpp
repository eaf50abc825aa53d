// How is a plane polygon, convex or not, cut into triangles that all turn the same way?
//
// Laws: with success, triangles turn as asked or have zero area, and not all of them zero; then they cover every point
// as often as the polygon winds around it, for the winding number is the sum of theirs.  A simple polygon, corners on
// straight edges included, succeeds without any zero area: its ears are the leaves of a triangulation, and one whose
// closed triangle holds no other corner leaves a simple polygon behind.
// Source: RTCD 12.5.1; Meisters 1975 (two ears).  Cost: for each ear the corners in its x-range.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/surface/mesh.hpp"

namespace plumb::surface {

using Corners = std::span<const std::uint32_t>;

class EarClipping {
 public:
  EarClipping(std::span<const Point2> points, Sign turn);

  /// False, and `out` as before, when the polygon cannot be cut so.
  bool run(Corners corners, std::vector<Triangle>& out);

 private:
  // What may be cut off.  The second and third are for polygons that touch themselves.
  enum class Ears { empty_closed, flat, empty_open };

  bool is_ear(std::uint32_t i, Ears ears) const;
  bool blocks(std::uint32_t u, std::uint32_t i, Ears ears) const;
  bool edges_enter(std::uint32_t u, const Point2& corner, const Point2& from, const Point2& to) const;
  bool turns(const Point2& a, const Point2& b, const Point2& c) const;
  bool folds_back(std::uint32_t i) const;
  void clip(std::uint32_t i, Corners corners, std::vector<Triangle>& out);
  void clip_folds(std::uint32_t i, Corners corners, std::vector<Triangle>& out);
  bool clip_next(Ears ears, Corners corners, std::vector<Triangle>& out);

  std::span<const Point2> points_;
  Sign turn_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<std::uint32_t> by_x_;  // corners, the clipped ones leaving from time to time
  std::vector<bool> clipped_;
  std::uint32_t at_ = 0;  // where to look for the next ear
  std::size_t left_;
  bool has_area_ = false;
};

}  // namespace plumb::surface
