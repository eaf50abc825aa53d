// Grid traversal (voxel walk, digital differential analyzer): which cells of a uniform grid does a ray or segment
// visit?
//
//   GridWalk3 walk(grid, ray, {.range = {{0, 0, 0}, {63, 63, 63}}});
//   while (walk.next()) use(walk.cell());                                // in the order in which the ray comes to them
//   GridWalk2 touched(grid, segment, {.cells = WalkedCells::closed});    // with all that it only touches
//
// Laws: (1) half_open: the cells of law (1) of cell_grid.hpp that hold a point of the ray, exactly: each point is in
// one cell, so a ray along a wall is in the cells above it.  (2) closed: the cells that the ray touches, corners,
// edges and walls included.  (3) Each once, in the order of the parameters at which the ray comes to them; of those
// to which it comes at once (closed) the one whose first axes have been crossed less.  (4) Only cells of the range,
// and all of them: a ray may begin anywhere.  Without a range the walk goes on until who asks has enough.  (5) A ray
// of zero direction and a segment of equal ends are the points that they are.
// Numbers of cells are those that cell_grid.hpp names.  A size that is not above zero throws InvalidShape, NaN and
// infinity NonFinite, by name.
// Which wall comes first is told by whole numbers: the times of the next walls in units so small that each is known to
// one of them, and the units by which those may be off.  They begin anew every few hundred steps.  Times too near to be
// told apart are compared to a hundred bits, then exactly, as the sign of a determinant of two exact differences.
// Source: RTCD 7.4.2; Amanatides and Woo 1987.
// Cost: a few ns a cell, and some 1 us to begin; some 50 ns where two walls are crossed at once or nearly so, and
// where a closed ray runs in a wall.  Bounded by a fixed number of operations a cell and axis, on integers as long as
// the exponents' span.
#pragma once

#include <limits>

#include "plumb/space/bvh/walked_cells.hpp"
#include "plumb/space/grid/cell_grid.hpp"

namespace plumb {

template <std::size_t n>
struct GridWalkOptions {
  WalkedCells cells = WalkedCells::closed;
  CellRange<n> range = {};
};

namespace space {

/// One axis of a grid, and of a line through it: from + t (to - base), of which the difference is not rounded.
struct WalkAxis {
  double origin, size, from, base, to;
};
/// To some hundred bits, and how far it can be off: what arith/ball.hpp computes with.
struct WalkTime {
  double high, low, radius;
};

}  // namespace space

template <std::size_t n>
class GridWalk {
 public:
  using Cell = std::array<std::int64_t, n>;
  using Ray = std::conditional_t<n == 2, Ray2, Ray3>;
  using Segment = std::conditional_t<n == 2, Segment2, Segment3>;

  GridWalk(const CellGridOf<n>& grid, const Ray& ray, const GridWalkOptions<n>& options = {});
  GridWalk(const CellGridOf<n>& grid, const Segment& segment, const GridWalkOptions<n>& options = {});

  /// To the next cell, if there is one.
  bool next() {
    std::size_t a = time_[1] < time_[0] ? 1 : 0;
    if constexpr (n == 3) a = time_[2] < time_[a] ? 2 : a;
    const std::int64_t now = time_[a], to = cell_[a] + step_[a];
    int near = 0;  // this wall, and those that may be crossed as early
    for (const std::int64_t t : time_) near += t - now <= slack_ ? 1 : 0;
    if (near != 1 || now >= window || to == stop_[a]) [[unlikely]]
      return next_slowly();
    cell_[a] = told_[a] = to;
    time_[a] = now + pace_[a];
    return true;
  }
  [[nodiscard]] const Cell& cell() const { return told_; }

 private:
  /// Times are below the window, or it begins anew; of what is not crossed any more they are `never`.
  static constexpr std::int64_t window = std::int64_t{1} << 61, never = std::int64_t{1} << 62,
                                all_near = std::numeric_limits<std::int64_t>::max();
  enum class Stage : unsigned char { before, within, behind };

  bool next_slowly();
  void set(const CellGridOf<n>& grid, const std::array<std::array<double, n>, 3>& line,
           const GridWalkOptions<n>& options);
  void begin();
  bool enter(unsigned outside);
  void cross();
  void cross_together(unsigned group);
  void set_times();
  void stop();
  void queue_cells(const Cell& old, unsigned crossed);
  [[nodiscard]] bool is_in_range(std::size_t a, std::int64_t i) const { return first_[a] <= i && i <= last_[a]; }
  [[nodiscard]] std::int64_t next_wall(std::size_t a) const { return step_[a] > 0 ? cell_[a] + 1 : cell_[a]; }
  [[nodiscard]] int order(std::size_t a, std::size_t b) const;

  Cell cell_{}, step_{}, stop_{},
      told_{};                     // at stop an axis leaves the range, or the segment ends before its next wall
  Cell time_{}, pace_{};           // of the next wall, and from wall to wall; in units, rounded down
  std::int64_t slack_ = all_near;  // times that differ by no more are not told apart
  // What is seldom needed.
  Stage stage_ = Stage::before;
  bool is_closed_ = false, is_segment_ = false, is_in_wall_ = false;
  std::array<bool, n> moves_{}, exits_{}, in_wall_{};  // in_wall: in both cells beside a wall all the time
  std::int64_t doubt_ = all_near;                      // what slack is while nothing is queued
  std::size_t taken_ = 0, queued_ = 0;
  std::array<Cell, 8> queue_{};
  Cell first_{}, last_{};
  std::array<space::WalkAxis, n> axis_{};
  Cell known_cell_{};  // where times began anew, and what they were
  std::array<space::WalkTime, n> known_time_{}, known_pace_{};
};

using GridWalk2 = GridWalk<2>;
using GridWalk3 = GridWalk<3>;
using GridWalkOptions2 = GridWalkOptions<2>;
using GridWalkOptions3 = GridWalkOptions<3>;

}  // namespace plumb
