// What went wrong, and how is it mended?  The exceptions of the library; there are no others.
//
// Law: predicates are total over finite doubles; only input that stands for no real number or no point, misuse and bad
// files throw.
// Every text names the argument, or the file with its line or byte, and what was expected.
#pragma once

#include <stdexcept>
#include <string>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// Base of everything the library throws.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A NaN or an infinity was given where a real number is needed; the text names the argument.
struct NonFinite : Error {
  using Error::Error;
};

/// Spans that belong together have different lengths; the text names them with their lengths.
struct UnequalLengths : Error {
  using Error::Error;
};

/// A construction has no point: parallel lines, a line parallel to the plane.  The text names the argument and why.
struct DegeneratePoint : Error {
  using Error::Error;
};

/// The nearest double to a number would be infinite; the text names the number.
struct BeyondDoubles : Error {
  using Error::Error;
};

/// A square root of a negative number was asked for; the text names the number.
struct NegativeRadicand : Error {
  using Error::Error;
};

/// Numbers that are no shape: a negative radius, a polygon of two vertices, a bound of no points.  The text says which
/// and what is wanted.
struct InvalidShape : Error {
  using Error::Error;
};

/// A pose makes an ellipsoid of what is round, and what was asked of it is answered of balls alone; the text names the
/// figures and what is answered.
struct UnevenPose : Error {
  using Error::Error;
};

/// Two arguments of a perturbed predicate have the same index; the text names both.
struct RepeatedIndex : Error {
  using Error::Error;
};

}  // namespace plumb
