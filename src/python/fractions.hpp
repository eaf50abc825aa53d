// What is a rational number in Python?  A fractions.Fraction, of any length.
//
// Source: none.
// Cost: some microseconds a number.
#pragma once

#include "plumb/arith/exact_vector.hpp"
#include "plumb/arith/root.hpp"
#include "plumb/certify/exact_point.hpp"
#include "plumb/certify/ray_parameter.hpp"
#include "python/numbers.hpp"

namespace plumb::python {

py::object fraction_of(const Rational& x);
/// A tuple of them.
py::tuple fractions_of(const RationalPoint2& p);
py::tuple fractions_of(const RationalPoint3& p);
py::tuple fractions_of(const ExactVector3& v);

/// A fraction where it is one, else plumb.SquareRoot.
py::object number_of_parameter(const RayParameter& t);
/// A fraction where it is one, else plumb.PolynomialRoot.
py::object number_of_root(const Root& t);

/// plumb.NAME(parts...), a tuple whose parts have names.
template <class... Parts>
py::object answer(const char* name, Parts&&... parts) {
  return py::module_::import("plumb.answers").attr(name)(std::forward<Parts>(parts)...);
}

}  // namespace plumb::python
