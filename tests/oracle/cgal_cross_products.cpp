// Products of cross products, gaps of boxes and moving points as CGAL states them.
#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

// 3 b1 of the determinant g(s) = det(u + s v) = b0 + 3 b1 s + 3 b2 s^2 + b3 s^3, from g(1), g(-1) and b3 = det(v).
Sign middle(Arguments& p) {
  std::array<Kernel::Point_3, 8> x;
  for (auto& point : x) point = p.point3();
  const auto g = [&](int before, int after) {
    const auto row = [&](std::size_t i) { return before * (x[i] - x[3]) + after * (x[4 + i] - x[7]); };
    return CGAL::determinant(row(0), row(1), row(2));
  };
  return of((g(1, 1) - g(1, -1)) / 2 - g(0, 1));
}

}  // namespace

std::optional<Sign> cross_products_by_cgal(std::string_view predicate, Arguments p) {
  if (predicate == "dot_of_crosses") {
    const auto a = p.vector3(), b = p.vector3(), c = p.vector3(), d = p.vector3();
    return of(CGAL::cross_product(a, b) * CGAL::cross_product(c, d));
  }
  if (predicate == "coplanar_side") {
    const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3();
    return of(CGAL::angle(CGAL::normal(a, b, c), CGAL::normal(a, b, d)));
  }
  if (predicate == "order_along_cross") {
    const auto u = p.vector3(), v = p.vector3();
    const auto from = p.point3(), to = p.point3();
    return of(CGAL::orientation(u, v, to - from));
  }
  if (predicate == "box_gap") {
    const auto from = p.point3(), to = p.point3();
    const auto u = p.vector3(), v = p.vector3();
    std::array<Kernel::Vector_3, 4> w;
    for (auto& vector : w) vector = p.vector3();
    Number gap = CGAL::determinant(u, v, to - from);
    for (const auto& vector : w) gap -= p.number() * CGAL::determinant(u, v, vector);
    return of(gap);
  }
  if (predicate == "coplanarity_middle") return middle(p);
  return std::nullopt;
}

}  // namespace plumb::oracle
