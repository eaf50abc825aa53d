// Which cells of a view does a body take?  A view has pixels along two axes and depths along the third, all whole
// numbers.
//
// Laws: a point p of the view's box is in the cell of floor((p - origin) * scale) along each axis, of those exact
// numbers. The cells of a body's faces, and of its edges, hold those of all their points in that box; of a solid they
// hold, in the pixel of each such point that is inside, depths on both sides of it.
// Source: RTCD 10.1.
// Cost: interval arithmetic for each corner, integers for each part of a triangle; a thousand parts a triangle at most
// where it fills the view.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "world/gpu/shape.hpp"

namespace plumb::world {

/// Pixels and depths, the last ones included, in a tile of what is drawn on.
struct CellRange {
  std::array<std::int32_t, 4> pixels;  // from x, y, up to x, y
  std::array<std::int32_t, 2> depths;
  std::int32_t tile;
};

class CellView {
 public:
  static constexpr int depth_bits = 16;

  /// Depths are along `depth_axis`; `around` is a box around the bodies that are drawn.
  CellView(const Aabb3& box, const Aabb3& around, std::size_t depth_axis, int pixel_bits);

  void draw_faces(const DrawnShape& shape, std::int32_t tile, std::vector<CellRange>& to) const;
  void draw_edges(const DrawnShape& shape, std::int32_t tile, std::vector<CellRange>& to) const;

 private:
  struct Place {
    std::array<std::int64_t, 3> low, high;  // along the pixels' axes, then along the depth
    bool is_far;                            // beyond what integers are asked to hold
  };
  template <std::size_t corners>
  struct Drawing;

  [[nodiscard]] Place place_of(const Aabb3& corner) const;
  [[nodiscard]] std::vector<Place> places_of(const DrawnShape& shape) const;

  std::array<std::size_t, 3> axes_{};
  std::array<double, 3> origin_{}, scale_{};
  std::array<std::int64_t, 3> last_{}, top_{};  // an end of the box, and of the cells that it has
  int shift_;
  std::int64_t fine_;  // along one axis, and along all of them: parts so small are not divided
  double small_ = 0;
};

}  // namespace plumb::world
