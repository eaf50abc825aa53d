// Radicals, and the polynomials that decide them, as CGAL squares and multiplies them.
#include <CGAL/Sqrt_extension.h>

#include "oracle/cgal_kernel.hpp"
#include "oracle/radicals.hpp"

namespace plumb::oracle {
namespace {

using One = CGAL::Sqrt_extension<Number, Number>;
using Two = CGAL::Sqrt_extension<One, One>;

Number number(const mpq_class& x) { return Number(x.get_mpq_t()); }

// a + b sqrt(c); CGAL asks for radicands that are not zero.
One radical(const Number& a, const Number& b, const Number& c) { return c == 0 ? One(a) : One(a, b, c); }

// The product with the conjugate.
Number norm(const One& x) { return (x * x.conjugate()).a0(); }

}  // namespace

Sign cgal_sign(const Radicals& r) {
  const One one = radical(number(r[0]), number(r[1]), number(r[2]));
  if (r[4] == 0) return of(one.sign());
  return of(Two(one, One(number(r[3])), One(number(r[4]))).sign());
}

std::optional<Sign> radicals_by_cgal(std::string_view predicate, Arguments p) {
  if (!predicate.starts_with("radical_")) return std::nullopt;
  const Number a = p.number(), b = p.number(), c = p.number(), d = p.number(), e = p.number();
  const One x = radical(a, b, c);
  if (predicate == "radical_norm") return of(norm(x));
  const One difference = x * x - One(d * d * e);
  if (predicate == "radical_pair_part") return of(difference.a0());
  if (predicate == "radical_pair_norm") return of(norm(difference));
  return std::nullopt;
}

}  // namespace plumb::oracle
