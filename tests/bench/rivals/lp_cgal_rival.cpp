#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "bench/rivals/lp_rival.hpp"

namespace plumb::bench {

struct CgalLinearProgram::Held {
  CGAL::Quadratic_program<CGAL::Gmpq> program{CGAL::SMALLER, false, 0, false, 0};
};

CgalLinearProgram::CgalLinearProgram(const Vector3& direction, std::span<const Halfspace3> halfspaces) {
  auto held = std::make_shared<Held>();
  const double d[3] = {direction.x, direction.y, direction.z};
  for (int i = 0; i < 3; ++i) held->program.set_c(i, -CGAL::Gmpq(d[i]));
  for (int j = 0; j < static_cast<int>(halfspaces.size()); ++j) {
    const Halfspace3& h = halfspaces[static_cast<std::size_t>(j)];
    const double n[3] = {h.normal.x, h.normal.y, h.normal.z};
    for (int i = 0; i < 3; ++i) held->program.set_a(i, j, CGAL::Gmpq(n[i]));
    held->program.set_b(j, CGAL::Gmpq(h.offset));
  }
  held_ = std::move(held);
}

int CgalLinearProgram::kind() const {
  const auto solution = CGAL::solve_linear_program(held_->program, CGAL::Gmpq());
  return solution.is_infeasible() ? 1 : solution.is_unbounded() ? 2 : 0;
}

}  // namespace plumb::bench
