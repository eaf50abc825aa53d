// Volume and surface area of an oriented box, rounded once.
#include <cmath>

#include "arith/big_rounding.hpp"
#include "arith/vec.hpp"
#include "figure/obb/exact_volume.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb {
namespace {

using arith::cross, arith::vec, arith::dot, figure::signed_volume_of;

// The square of the area of both faces through axis i.
template <class N>
N squared_area(const Obb3& box, std::size_t i) {
  const std::array half{box.half.x, box.half.y, box.half.z};
  const auto normal = cross(vec<N>(box.axes[(i + 1) % 3]), vec<N>(box.axes[(i + 2) % 3]));
  const N size = N(8) * (N(half[(i + 1) % 3]) * N(half[(i + 2) % 3]));
  return size * size * dot(normal, normal);
}

// floor(2^bits root(x)), and whether that is all.
mpz_class floor_root(const BigDyadic& x, long bits, bool& exact) {
  mpz_class shifted = x.mantissa();
  const long shift = x.exponent() + 2 * bits;
  if (shift >= 0) {
    shifted <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    exact = exact && mpz_divisible_2exp_p(shifted.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift)) != 0;
    shifted >>= static_cast<mp_bitcnt_t>(-shift);
  }
  mpz_class root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), shifted.get_mpz_t());
  exact = exact && rest == 0;
  return root;
}

double nearest(const mpz_class& n, long bits) {
  mpq_class x(n);
  mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
  return rounded(Rounding::nearest, x);
}

// A sum of roots is rational only where each root is: then enough bits are exact, and otherwise it is no double and no
// tie, so that enough bits leave one double.
double sum_of_roots(const std::array<BigDyadic, 3>& squares) {
  for (long bits = 1200;; bits *= 2) {
    bool exact = true;
    mpz_class sum = 0;
    for (const BigDyadic& s : squares) sum += floor_root(s, bits, exact);
    const double low = nearest(sum, bits);
    if (exact || nearest(sum + 3, bits) == low) return low;
  }
}

}  // namespace

double volume(const Obb3& box) {
  figure::require_sound("volume", box);
  const auto quick = signed_volume_of<Ball>(box).nearest();
  return std::fabs(quick ? *quick : rounded(Rounding::nearest, signed_volume_of<BigDyadic>(box)));
}

double surface_area(const Obb3& box) {
  figure::require_sound("surface_area", box);
  const Ball quick =
      root(squared_area<Ball>(box, 0)) + (root(squared_area<Ball>(box, 1)) + root(squared_area<Ball>(box, 2)));
  if (const auto area = quick.nearest()) return *area;
  return sum_of_roots(
      {squared_area<BigDyadic>(box, 0), squared_area<BigDyadic>(box, 1), squared_area<BigDyadic>(box, 2)});
}

}  // namespace plumb
