// Radicals as CGAL squares them.
#include <CGAL/Gmpq.h>
#include <CGAL/Sqrt_extension.h>

#include "oracle/radicals.hpp"

namespace plumb::oracle {
namespace {

using Number = CGAL::Gmpq;
using One = CGAL::Sqrt_extension<Number, Number>;
using Two = CGAL::Sqrt_extension<One, One>;

Number number(const mpq_class& x) { return Number(x.get_mpq_t()); }

Sign of(int cgal) { return static_cast<Sign>((cgal > 0) - (cgal < 0)); }

}  // namespace

Sign cgal_sign(const Radicals& r) {
  // CGAL asks for radicands that are not zero.
  const One one = r[2] == 0 ? One(number(r[0])) : One(number(r[0]), number(r[1]), number(r[2]));
  if (r[4] == 0) return of(one.sign());
  return of(Two(one, One(number(r[3])), One(number(r[4]))).sign());
}

}  // namespace plumb::oracle
