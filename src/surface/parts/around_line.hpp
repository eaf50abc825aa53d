// In which order do half planes lie around an edge that they share?
//
// Law: counterclockwise, seen from the edge's larger vertex; exact.
// Source: Zhou et al. 2016, 3.3.
// Cost: a look-up a comparison, once two planes have been compared.
#pragma once

#include "surface/parts/cut_cell.hpp"

namespace plumb::surface {

/// From one half plane on.
class AroundLine {
 public:
  AroundLine(CutSpace& space, EdgeRay from) : space_(space), from_(from) {}

  /// 0 for the half plane itself, 1 for what is less than half a turn ahead, 2 for the opposite one, 3 for the rest.
  [[nodiscard]] int quarter(EdgeRay r) const {
    if (r.plane == from_.plane) return r.side == from_.side ? 0 : 2;
    return ahead(from_, r) ? 1 : 3;
  }
  [[nodiscard]] bool before(EdgeRay l, EdgeRay r) const {
    const int of_l = quarter(l), of_r = quarter(r);
    if (of_l != of_r) return of_l < of_r;
    return of_l % 2 == 1 && l.plane != r.plane && ahead(l, r);
  }

 private:
  [[nodiscard]] bool ahead(EdgeRay l, EdgeRay r) const { return l.side * r.side * space_.bend(l.plane, r.plane) > 0; }

  CutSpace& space_;
  EdgeRay from_;
};

/// Is the half plane strictly inside of the wedge?
inline bool is_inside(CutSpace& space, const EdgeWedge& wedge, EdgeRay r) {
  const AroundLine around(space, wedge.from);
  if (around.quarter(r) == 0) return false;
  return around.quarter(wedge.to) == 0 || around.before(r, wedge.to);
}

}  // namespace plumb::surface
