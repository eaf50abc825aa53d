#include "query/lp/corner_point.hpp"

#include "arith/big_rounding.hpp"

namespace plumb::query {
namespace {

template <std::size_t D, class Maker>
auto numbers_of_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes, const Maker& maker) {
  std::array<LpPlane<D>, D> p;
  for (std::size_t k = 0; k < D; ++k) p[k] = {numbers_of(planes[k].normal), planes[k].offset};
  return corner_numbers<D>(p, false, maker);
}

}  // namespace

template <std::size_t D>
Numbers<D> nearest_corner(const std::array<typename LpOf<D>::Halfspace, D>& planes) {
  Numbers<D> r{};
  const auto c = numbers_of_corner<D>(planes, [](double x) { return Ball(x); });
  bool certain = true;
  for (std::size_t k = 0; k < D; ++k) {
    const auto quick = quotient(c.at[k], c.weight).nearest();
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
  for (std::size_t k = 0; k < D; ++k) r[k] = big_rational(big.at[k]).value / big_rational(big.weight).value;
  return r;
}

template Numbers<2> nearest_corner<2>(const std::array<Halfspace2, 2>&);
template Numbers<3> nearest_corner<3>(const std::array<Halfspace3, 3>&);
template std::array<mpq_class, 2> exact_corner<2>(const std::array<Halfspace2, 2>&);
template std::array<mpq_class, 3> exact_corner<3>(const std::array<Halfspace3, 3>&);

}  // namespace plumb::query
