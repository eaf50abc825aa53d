// Orders, angles, cross products and determinants as CGAL states them.
#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

// Of vectors in space whose coordinate along the axis is zero, given by the other two in cyclic order.
Kernel::Vector_3 beside_axis(int axis, Arguments& p) {
  const Number i = p.number(), j = p.number();
  if (axis == 0) return {0, i, j};
  if (axis == 1) return {j, 0, i};
  return {i, j, 0};
}

int axis_of(std::string_view predicate) { return predicate.back() - 'x'; }

template <std::size_t N>
std::array<Number, N> numbers(Arguments& p) {
  std::array<Number, N> x;
  for (Number& n : x) n = p.number();
  return x;
}

std::optional<Sign> order(std::string_view predicate, Arguments& p) {
  if (predicate == "order_on_axis") {
    const Number a = p.number(), b = p.number();
    return of(CGAL::compare(a, b));
  }
  if (predicate == "order_along_direction2d") {
    const auto a = p.point2(), b = p.point2();
    return of((a - b) * p.vector2());
  }
  if (predicate == "order_along_direction3d") {
    const auto a = p.point3(), b = p.point3();
    return of((a - b) * p.vector3());
  }
  if (predicate == "order_along_line2d") {
    const auto a = p.point2(), b = p.point2(), c = p.point2(), d = p.point2();
    return of((a - b) * (d - c));
  }
  if (predicate == "order_along_line3d") {
    const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3();
    return of((a - b) * (d - c));
  }
  return std::nullopt;
}

std::optional<Sign> determinant(std::string_view predicate, Arguments& p) {
  const auto sign = [](const auto&... entries) { return of(CGAL::sign_of_determinant(entries...)); };
  if (predicate == "determinant2") return std::apply(sign, numbers<4>(p));
  if (predicate == "determinant3") return std::apply(sign, numbers<9>(p));
  if (predicate == "determinant4") return std::apply(sign, numbers<16>(p));
  if (predicate == "determinant5") return std::apply(sign, numbers<25>(p));
  return std::nullopt;
}

}  // namespace

std::optional<Sign> directions_by_cgal(std::string_view predicate, Arguments p) {
  if (predicate.starts_with("order_")) return order(predicate, p);
  if (predicate.starts_with("determinant")) return determinant(predicate, p);
  if (predicate == "dot2d") {
    const auto a = p.vector2(), b = p.vector2();
    return of(CGAL::angle(a, b));
  }
  if (predicate == "dot3d") {
    const auto a = p.vector3(), b = p.vector3();
    return of(CGAL::angle(a, b));
  }
  if (predicate == "angle2d") {
    const auto a = p.point2(), b = p.point2(), c = p.point2();
    return of(CGAL::angle(a, b, c));
  }
  if (predicate == "angle3d") {
    const auto a = p.point3(), b = p.point3(), c = p.point3();
    return of(CGAL::angle(a, b, c));
  }
  if (predicate == "cross2d") {
    const auto a = p.vector2(), b = p.vector2();
    return of(CGAL::orientation(a, b));
  }
  if (predicate == "cross_x" || predicate == "cross_y" || predicate == "cross_z") {
    const int axis = axis_of(predicate);
    const auto a = beside_axis(axis, p), b = beside_axis(axis, p);
    return of(CGAL::cross_product(a, b)[axis]);
  }
  if (predicate == "orient_x" || predicate == "orient_y" || predicate == "orient_z") {
    const int axis = axis_of(predicate);
    const auto a = beside_axis(axis, p), b = beside_axis(axis, p), c = beside_axis(axis, p);
    return of(CGAL::cross_product(b - a, c - a)[axis]);
  }
  if (predicate == "collinear") {  // zero when they are
    const auto a = p.point3(), b = p.point3(), c = p.point3();
    return CGAL::collinear(a, b, c) ? Sign::zero : Sign::positive;
  }
  return std::nullopt;
}

}  // namespace plumb::oracle
