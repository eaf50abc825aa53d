// Boxes that meet, as a linear program over CGAL's rationals.
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "oracle/space.hpp"

namespace plumb::oracle {
namespace {

using Number = CGAL::Gmpq;

std::array<Number, 3> numbers(double x, double y, double z) { return {Number(x), Number(y), Number(z)}; }

}  // namespace

// Factors s and t with |s_i| <= a.half_i, |t_i| <= b.half_i and sum of s_i a_i - t_i b_i equal to b.center - a.center.
bool boxes_meet(const Box& a, const Box& b) {
  CGAL::Quadratic_program<Number> program(CGAL::EQUAL, false, 0, false, 0);
  int variable = 0;
  for (const auto& [box, sign] : {std::pair{&a, 1}, std::pair{&b, -1}}) {
    const auto half = numbers(box->half.x, box->half.y, box->half.z);
    for (std::size_t i = 0; i < 3; ++i, ++variable) {
      const auto axis = numbers(box->axes[i].x, box->axes[i].y, box->axes[i].z);
      for (int row = 0; row < 3; ++row) {
        program.set_a(variable, row, Number(sign) * axis[static_cast<std::size_t>(row)]);
      }
      program.set_l(variable, true, -half[i]);
      program.set_u(variable, true, half[i]);
    }
  }
  const auto from = numbers(a.center.x, a.center.y, a.center.z), to = numbers(b.center.x, b.center.y, b.center.z);
  for (int row = 0; row < 3; ++row) {
    const auto r = static_cast<std::size_t>(row);
    program.set_b(row, to[r] - from[r]);
    program.set_r(row, CGAL::EQUAL);
  }
  return !CGAL::solve_linear_program(program, Number()).is_infeasible();
}

}  // namespace plumb::oracle
