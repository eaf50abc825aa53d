// What are our coordinates in CGAL's terms?  Its kernel over rationals, and the arguments of a predicate as its points.
//
// For the .cpp files of this folder alone: it includes CGAL.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <optional>
#include <span>
#include <string_view>

#include "oracle/oracle.hpp"

namespace plumb::oracle {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Number = CGAL::Gmpq;

/// Of CGAL's signs, comparisons, sides and angles, whose positive is ours.
inline Sign of(int cgal) { return static_cast<Sign>((cgal > 0) - (cgal < 0)); }
inline Sign of(const Number& x) { return of(CGAL::sign(x)); }

/// The arguments of a predicate, taken one after another; zeros follow the last.
class Arguments {
 public:
  explicit Arguments(std::span<const double> coordinates) : left_(coordinates) {}

  Number number() {
    if (left_.empty()) return 0;
    const Number x(left_.front());
    left_ = left_.subspan(1);
    return x;
  }
  // Named first: the order in which arguments of a call are evaluated is not fixed.
  Kernel::Point_2 point2() {
    const Number x = number(), y = number();
    return {x, y};
  }
  Kernel::Point_3 point3() {
    const Number x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Kernel::Vector_2 vector2() { return point2() - CGAL::ORIGIN; }
  Kernel::Vector_3 vector3() { return point3() - CGAL::ORIGIN; }
  Kernel::Weighted_point_2 weighted2() {
    const Kernel::Point_2 p = point2();
    return {p, number()};
  }
  Kernel::Weighted_point_3 weighted3() {
    const Kernel::Point_3 p = point3();
    return {p, number()};
  }

 private:
  std::span<const double> left_;
};

/// What CGAL says of the predicates of one subject; nothing for others.
using Judge = std::optional<Sign> (*)(std::string_view predicate, Arguments p);
std::optional<Sign> directions_by_cgal(std::string_view predicate, Arguments p);
std::optional<Sign> distances_by_cgal(std::string_view predicate, Arguments p);
std::optional<Sign> planes_by_cgal(std::string_view predicate, Arguments p);
std::optional<Sign> spheres_by_cgal(std::string_view predicate, Arguments p);
std::optional<Sign> rays_by_cgal(std::string_view predicate, Arguments p);
std::optional<Sign> cross_products_by_cgal(std::string_view predicate, Arguments p);
std::optional<Sign> radicals_by_cgal(std::string_view predicate, Arguments p);

}  // namespace plumb::oracle
