// What does Python see of an answer about figures?  Tuples whose parts have names, and arrays of the figures' dimension.
//
// Source: none.
// Cost: some microseconds.
#pragma once

#include "plumb/query/contact/contact.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "plumb/query/variant/questions.hpp"
#include "python/fractions.hpp"

namespace plumb::python {

/// Answers in the plane lie in z = 0, which Python does not see.
py::array_t<double> row_of(const Point3& p, int dimension);
py::array_t<double> row_of(const Vector3& v, int dimension);
py::object answer_of(const Feature& feature);

py::object answer_of(const Closest& closest, int dimension);
py::object answer_of(const Support3& support, int dimension);
py::object answer_of(const Penetration& penetration);
py::object answer_of(const ExactPenetration& penetration);
py::object answer_of(const ContactManifold& contact);
py::object answer_of(const ExactContact& contact);
py::object answer_of(const AnyIntersection& common, bool exact);

}  // namespace plumb::python
