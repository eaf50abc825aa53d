#include "query/convex/posed_radius.hpp"

#include <string>

#include "plumb/arith/error.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"

namespace plumb::query {
namespace {

std::optional<mpq_class> rational_root(const mpq_class& x) {
  mpq_class root;
  if (mpz_perfect_square_p(x.get_num_mpz_t()) == 0 || mpz_perfect_square_p(x.get_den_mpz_t()) == 0) return {};
  mpz_sqrt(root.get_num_mpz_t(), x.get_num_mpz_t());
  mpz_sqrt(root.get_den_mpz_t(), x.get_den_mpz_t());
  return root;
}

}  // namespace

mpq_class radius_of_image(std::string_view function, const PosedView& figure, const PosedSet& s) {
  if (!s.is_round()) return 0;
  const auto square = squared_scale(s.map, s.dimension);
  const auto scale = square ? rational_root(*square) : std::nullopt;
  if (scale) return s.radius * *scale;
  throw UnevenPose(std::string(function)
                       .append(": ")
                       .append(spoken(figure.figure))
                       .append(": its pose makes an ellipsoid of it, or its scale is not rational; ")
                       .append(rigid_instead)
                       .append(", or columns at right angles and of one rational length"));
}

}  // namespace plumb::query
