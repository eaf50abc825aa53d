#include "query/lp/system_rows.hpp"

#include <string>

#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::query {

std::vector<Rational> to_rationals(std::span<const mpq_class> all) {
  std::vector<Rational> r;
  for (const mpq_class& x : all) r.push_back(exact_number(x));
  return r;
}

arith::RationalVector to_mpq(std::span<const Rational> all) {
  arith::RationalVector r;
  for (const Rational& x : all) r.push_back(gmp_number(x));
  return r;
}

arith::Constraints constraints_of(std::string_view function, const LinearSystem& system, std::size_t dimension) {
  const auto refuse = [&](const std::string& what, std::size_t size, std::size_t wanted) {
    throw InvalidShape(std::string(function).append(": ").append(what).append(" has ").append(
        std::to_string(size).append(" numbers where there are ").append(std::to_string(wanted))));
  };
  if (system.limits.size() != system.rows.size()) refuse("system.limits", system.limits.size(), system.rows.size());
  arith::Constraints r;
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    if (system.rows[i].size() != dimension)
      refuse("system.rows[" + std::to_string(i) + "]", system.rows[i].size(), dimension);
    r.add(to_mpq(system.rows[i]), gmp_number(system.limits[i]));
  }
  return r;
}

}  // namespace plumb::query
