// CGAL's exact solver of linear and quadratic programs, as its users call it.
#pragma once

#include <memory>
#include <span>

#include "plumb/figure/basic/plane.hpp"

namespace plumb::bench {

/// maximize direction . x over the halfspaces, whose numbers it holds as CGAL's exact ones.
class CgalLinearProgram {
 public:
  CgalLinearProgram(const Vector3& direction, std::span<const Halfspace3> halfspaces);
  /// 0: optimal, 1: infeasible, 2: unbounded.
  [[nodiscard]] int kind() const;

 private:
  struct Held;
  std::shared_ptr<const Held> held_;
};

}  // namespace plumb::bench
