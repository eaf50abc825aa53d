// Cells and portals: through which portals does what moves straight go, and in which cell is it then?
//
//   const Passage p = passage(rooms, cell, Segment3{from, to});
//   p.portals; p.cell; p.arrives
//   PortalObjects things(rooms);
//   const std::uint32_t handle = things.insert(place);        // in the first cell that holds it
//   things.move(handle, elsewhere);                           // and what it went through
//   things.objects_in(cell)
//
// Laws: (1) a passage goes from one closed cell into another at a place that the segment has in common with a portal of
// both: it arrives exactly where some chain of cells and portals covers the segment from its beginning to its end.
// (2) It is one of the fewest portals, the same in every run.  Through a corner that portals have in common it may lead
// through several at one place.  (3) Where none arrives it is one that comes farthest, and `until` the part of the
// segment up to there, exactly: 1 where it arrives.  (4) An object that arrives is moved, one that does not stays where
// it was.  On a portal it is in the cell that it came from.
// A segment that begins outside the cell, and an object outside all cells, throw InvalidShape; a
// handle that holds nothing Error; NaN and infinity NonFinite.
// Source: RTCD 7.6.
// Cost: a sign for each face while it stays in the cell; rational numbers for each cell that it leaves.  Bounded by
// n^2 places that are come to in n cells, one for each cell and number of portals, on integers as long as the exponents'
// span.
#pragma once

#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/space/cells/portal_cells.hpp"

namespace plumb {

struct Passage {
  std::vector<std::uint32_t> portals;  // in their order
  std::uint32_t cell;
  bool arrives;
  Rational until;  // the part of the segment that is passed
};

Passage passage(const PortalCells& rooms, std::uint32_t cell, const Segment3& segment);

class PortalObjects {
 public:
  /// The rooms must outlive it.
  explicit PortalObjects(const PortalCells& rooms) : rooms_(&rooms), objects_in_(rooms.cells().size()) {}

  std::uint32_t insert(const Point3& place);
  void remove(std::uint32_t handle);
  Passage move(std::uint32_t handle, const Point3& to);

  [[nodiscard]] std::uint32_t cell_of(std::uint32_t handle) const;
  [[nodiscard]] const Point3& place_of(std::uint32_t handle) const;
  /// In the order of their coming.
  [[nodiscard]] std::span<const std::uint32_t> objects_in(std::uint32_t cell) const;

 private:
  struct Object {
    Point3 place;
    std::uint32_t cell;
  };
  void require_held(std::string_view function, std::uint32_t handle) const;

  const PortalCells* rooms_;
  std::vector<Object> objects_;
  std::vector<std::uint32_t> free_;
  std::vector<std::vector<std::uint32_t>> objects_in_;
};

}  // namespace plumb
