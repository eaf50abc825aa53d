#include "python/fractions.hpp"

#include "plumb/arith/big.hpp"

namespace plumb::python {
namespace {

py::object integer_of(const mpz_class& x) {
  // In hexadecimal: Python refuses decimals of some thousand digits.
  PyObject* made = PyLong_FromString(x.get_str(16).c_str(), nullptr, 16);
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(made);
}

}  // namespace

py::object fraction_of(const Rational& x) {
  const mpq_class& value = x.value().value;
  return py::module_::import("fractions").attr("Fraction")(integer_of(value.get_num()), integer_of(value.get_den()));
}

py::tuple fractions_of(const RationalPoint2& p) { return py::make_tuple(fraction_of(p.x), fraction_of(p.y)); }
py::tuple fractions_of(const RationalPoint3& p) {
  return py::make_tuple(fraction_of(p.x), fraction_of(p.y), fraction_of(p.z));
}
py::tuple fractions_of(const ExactVector3& v) {
  return py::make_tuple(fraction_of(v.x), fraction_of(v.y), fraction_of(v.z));
}

py::object number_of_parameter(const RayParameter& t) {
  mpq_class root = t.square.value().value;
  if (mpz_perfect_square_p(root.get_num_mpz_t()) != 0 && mpz_perfect_square_p(root.get_den_mpz_t()) != 0) {
    root = mpq_class(sqrt(root.get_num()), sqrt(root.get_den()));
    return fraction_of(Rational(BigRational{t.base.value().value + (t.greater ? root : -root)}));
  }
  return answer("SquareRoot", fraction_of(t.base), fraction_of(t.square), t.greater);
}

py::object number_of_root(const Root& t) {
  if (const std::optional<Rational> rational = t.rational()) return fraction_of(*rational);
  py::list coefficients;
  for (const Rational& c : t.polynomial()) coefficients.append(fraction_of(c).attr("numerator"));
  const auto [low, high] = t.interval();
  return answer("PolynomialRoot", coefficients, py::make_tuple(fraction_of(low), fraction_of(high)));
}

}  // namespace plumb::python
