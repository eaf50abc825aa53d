// The relation of two boxes, as a linear program over CGAL's rationals.
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "oracle/boxes.hpp"

namespace plumb::oracle {
namespace {

using Number = CGAL::Gmpq;
using Vector = std::array<Number, 3>;

Vector numbers(double x, double y, double z) { return {Number(x), Number(y), Number(z)}; }

}  // namespace

// A point of both is b's center + sum of t_i half_i b_i and a's center + sum of s_i half_i a_i.  It lies in both
// relative interiors when all |s_i| and |t_i| are below one: then the largest `slack` that can be left is positive.
Relation box_relation(const Obb3& a, const Obb3& b) {
  CGAL::Quadratic_program<Number> program(CGAL::EQUAL, false, Number(0), false, Number(0));
  constexpr int slack = 6;
  int row = 3;
  int variable = 0;
  for (const auto& [box, sign] : {std::pair{&a, 1}, std::pair{&b, -1}}) {
    const Vector half = numbers(box->half.x, box->half.y, box->half.z);
    for (std::size_t i = 0; i < 3; ++i, ++variable) {
      const Vector axis = numbers(box->axes[i].x, box->axes[i].y, box->axes[i].z);
      for (std::size_t k = 0; k < 3; ++k) {
        program.set_a(variable, static_cast<int>(k), Number(sign) * half[i] * axis[k]);
      }
      for (const int way : {1, -1}) {
        program.set_a(variable, row, Number(way));
        program.set_a(slack, row, Number(1));
        program.set_b(row, Number(1));
        program.set_r(row++, CGAL::SMALLER);
      }
    }
  }
  const Vector from = numbers(a.center.x, a.center.y, a.center.z), to = numbers(b.center.x, b.center.y, b.center.z);
  for (std::size_t k = 0; k < 3; ++k) {
    program.set_b(static_cast<int>(k), to[k] - from[k]);
    program.set_r(static_cast<int>(k), CGAL::EQUAL);
  }
  program.set_l(slack, true, Number(0));
  program.set_c(slack, Number(-1));  // the solver minimizes
  const auto solution = CGAL::solve_linear_program(program, Number());
  if (solution.is_infeasible()) return Relation::disjoint;
  return solution.objective_value() < 0 ? Relation::overlapping : Relation::touching;
}

}  // namespace plumb::oracle
