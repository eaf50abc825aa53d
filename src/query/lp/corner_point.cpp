#include "query/lp/corner_point.hpp"

#include "arith/big_rounding.hpp"
#include "arith/exact_number.hpp"
#include "arith/running_error.hpp"
#include "plumb/arith/ball.hpp"

namespace plumb::query {
namespace {

template <std::size_t D, class Maker>
auto numbers_of_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes, const Maker& maker) {
  std::array<LpPlane<D>, D> p;
  for (std::size_t k = 0; k < D; ++k) p[k] = {numbers_of(planes[k].normal), planes[k].offset};
  return corner_numbers<D>(p, false, maker);
}

/// The point of the planes with other offsets.
template <std::size_t D>
CornerNumbers<Running, D> corner_through(const std::array<typename LpOf<D>::Halfspace, D>& planes,
                                         const std::array<Running, D>& offsets) {
  std::array<std::array<Running, D>, D> n;
  for (std::size_t k = 0; k < D; ++k) n[k] = made<D>([](double x) { return Running(x); }, numbers_of(planes[k].normal));
  const auto minors = minors_of(n, Running(0.0));
  return {meeting_of(minors, offsets), {}, dot_of(n[0], minors[0])};
}

}  // namespace

template <std::size_t D>
Numbers<D> nearest_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes) {
  // A point in doubles, and how far the exact one is from it: the solution of the same planes through what they lack
  // there.
  const auto rough = numbers_of_corner<D>(planes, [](double x) { return x; });
  Numbers<D> near{};
  for (std::size_t k = 0; k < D; ++k) near[k] = rough.at[k] / rough.weight;
  std::array<Running, D> lack;
  for (std::size_t i = 0; i < D; ++i) {
    const Numbers<D> n = numbers_of(planes[i].normal);
    Ball rest(planes[i].offset);
    for (std::size_t k = 0; k < D; ++k) rest = rest - Ball(n[k]) * Ball(near[k]);
    lack[i] = Running(rest.high, magnitude_of(rest.low) + rest.radius);
  }
  const auto off = corner_through<D>(planes, lack);
  Numbers<D> r{};
  bool certain = true;
  for (std::size_t k = 0; k < D; ++k) {
    const Running by = quotient(off.at[k], off.weight);
    const auto quick = (Ball(near[k]) + Ball(by.value, 0, by.bound())).nearest();
    certain = certain && quick.has_value();
    if (quick) r[k] = *quick;
  }
  if (certain) return r;
  const auto big = numbers_of_corner<D>(planes, [](double x) { return BigDyadic(x); });
  for (std::size_t k = 0; k < D; ++k) r[k] = rounded_quotient(Rounding::nearest, big.at[k], big.weight);
  return r;
}

template <std::size_t D>
std::array<mpq_class, D> exact_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes) {
  const auto big = numbers_of_corner<D>(planes, [](double x) { return BigDyadic(x); });
  std::array<mpq_class, D> r;
  for (std::size_t k = 0; k < D; ++k) r[k] = gmp_number(big.at[k]) / gmp_number(big.weight);
  return r;
}

template Numbers<2> nearest_corner<2>(const std::array<Halfspace2, 2>&);
template Numbers<3> nearest_corner<3>(const std::array<Halfspace3, 3>&);
template std::array<mpq_class, 2> exact_corner<2>(const std::array<Halfspace2, 2>&);
template std::array<mpq_class, 3> exact_corner<3>(const std::array<Halfspace3, 3>&);

}  // namespace plumb::query
