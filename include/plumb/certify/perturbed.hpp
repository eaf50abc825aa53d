// On which side, if nothing may be degenerate?  Signs under symbolic perturbation: an option of every formula.
//
//   orient2d(perturbed, {a, 0}, {b, 1}, {c, 2})          // never zero
//   decide<F>(perturbed, coordinates, indices)           // the same of any formula
//
// Every coordinate is thought to be moved up by an infinitesimal of its own.  An index, which the user gives to each
// argument, says how far: the lower the index, the larger the move; within an argument x moves more than y, y more than
// z.  Each infinitesimal is smaller than any power of a larger one.
// Laws: (1) never zero.  (2) Where the exact sign is not zero, it is the answer.  (3) Finitely many answers, of any
// formulas, are together the exact signs of one set of points, which are as close to the given ones as one likes: what
// holds of all points in general position holds of these answers.  Permuted arguments, for one, give the permuted sign.
// (4) Of the indices only their order matters.
// Two arguments of one index cannot be told apart: RepeatedIndex, also where they are the same point (looked at only
// where the exact sign is zero).  A coordinate that is NaN or infinite: NonFinite.  A formula that is zero wherever it
// is evaluated: Error.
// Source: Edelsbrunner and Muecke, "Simulation of simplicity", 1990; docs/proof.md, "Perturbation".
// Cost: nothing where the exact sign is not zero; otherwise two or three signs more, seldom some microseconds.
#pragma once

#include <span>

#include "plumb/arith/occurrence.hpp"
#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/detail/alternating.hpp"

namespace plumb {

/// Selects the sign under perturbation.
struct Perturbed {};
inline constexpr Perturbed perturbed;

/// A point with the index that tells it from all others: its place in the user's array, say.
struct Indexed2 {
  Point2 point;
  std::uint64_t index;
};
struct Indexed3 {
  Point3 point;
  std::uint64_t index;
};

/// One for each argument.
template <Formula F>
using Indices = std::array<std::uint64_t, arguments<F>.size()>;

namespace certify::perturbation {

/// What a perturbation knows of its formula.
struct Subject {
  std::string_view name;
  std::span<const int> arguments;
  bool alternating, homogeneous;
  certify::tape::Program program;
  std::span<const std::uint8_t> degree;   // of each coordinate (arith/occurrence.hpp) ...
  std::span<const std::uint64_t> beside;  // ... and with which it is multiplied; both empty beyond 64 coordinates
  Sign (*decide)(std::span<const double> coordinates);
};

template <Formula F>
inline constexpr auto occurrence = [] {
  if constexpr (arity<F> <= 64) {
    return evaluate<F>([](std::size_t i) { return Occurrence<arity<F>>::coordinate(i); });
  } else {
    return Occurrence<0>{};
  }
}();

template <Formula F>
Sign decide_span(std::span<const double> coordinates) {
  Coordinates<F> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = coordinates[i];
  return decide<F>(p);
}

template <Formula F>
inline constexpr Subject subject{F::name,
                                 arguments<F>,
                                 is_alternating<F>,
                                 is_homogeneous<F>,
                                 certify::tape::program<F>(),
                                 occurrence<F>.degree,
                                 occurrence<F>.beside,
                                 decide_span<F>};

/// The perturbed sign where the exact one is zero.
template <Formula F>
[[gnu::noinline]] Sign sign_of_zero(const Coordinates<F>& p, const Indices<F>& indices);

Sign sign_of_zero(const Subject& subject, std::span<const double> coordinates, std::span<const std::uint64_t> indices);

/// The same by nothing but the expansion in infinitesimals: coordinate order[0] is moved by the largest, and so on.  A
/// hint: the expansion is known to be zero in the first `known_zero` infinitesimals alone.  Zero where the polynomial
/// is.
Sign expanded_sign(certify::tape::Program program, bool homogeneous, std::span<const double> coordinates,
                   std::span<const std::uint16_t> order, std::size_t known_zero = 0);

template <Formula F>
Sign sign_of_zero(const Coordinates<F>& p, const Indices<F>& indices) {
  return sign_of_zero(subject<F>, p, indices);
}

// Compiled once, into the library.
extern template Sign sign_of_zero<predicates::Orient2d>(const Coordinates<predicates::Orient2d>&,
                                                        const Indices<predicates::Orient2d>&);
extern template Sign sign_of_zero<predicates::Orient3d>(const Coordinates<predicates::Orient3d>&,
                                                        const Indices<predicates::Orient3d>&);
extern template Sign sign_of_zero<predicates::InCircle>(const Coordinates<predicates::InCircle>&,
                                                        const Indices<predicates::InCircle>&);
extern template Sign sign_of_zero<predicates::InSphere>(const Coordinates<predicates::InSphere>&,
                                                        const Indices<predicates::InSphere>&);

}  // namespace certify::perturbation

/// The sign of F at p, perturbed; never zero.  The recorder is told which stage decided the sign before perturbation.
template <Formula F, class Recorder = NoRecorder>
Sign decide(Perturbed, const Coordinates<F>& p, const Indices<F>& indices, Recorder&& recorder = {}) {
  const Sign s = decide<F>(p, recorder);
  if (s != Sign::zero) return s;
  return certify::perturbation::sign_of_zero<F>(p, indices);
}

/// As orient2d(a, b, c), perturbed.
template <int = 0>
inline Sign orient2d(Perturbed, const Indexed2& a, const Indexed2& b, const Indexed2& c) {
  return decide<predicates::Orient2d>(perturbed, {a.point.x, a.point.y, b.point.x, b.point.y, c.point.x, c.point.y},
                                      {a.index, b.index, c.index});
}

/// As orient3d(a, b, c, d), perturbed.
template <int = 0>
inline Sign orient3d(Perturbed, const Indexed3& a, const Indexed3& b, const Indexed3& c, const Indexed3& d) {
  return decide<predicates::Orient3d>(perturbed,
                                      {a.point.x, a.point.y, a.point.z, b.point.x, b.point.y, b.point.z,  //
                                       c.point.x, c.point.y, c.point.z, d.point.x, d.point.y, d.point.z},
                                      {a.index, b.index, c.index, d.index});
}

/// As incircle(a, b, c, d), perturbed.  "Inside" where orient2d(perturbed, a, b, c) is positive.
template <int = 0>
inline Sign incircle(Perturbed, const Indexed2& a, const Indexed2& b, const Indexed2& c, const Indexed2& d) {
  return decide<predicates::InCircle>(
      perturbed, {a.point.x, a.point.y, b.point.x, b.point.y, c.point.x, c.point.y, d.point.x, d.point.y},
      {a.index, b.index, c.index, d.index});
}

/// As insphere(a, b, c, d, e), perturbed.  "Inside" where orient3d(perturbed, a, b, c, d) is positive.
template <int = 0>
inline Sign insphere(Perturbed, const Indexed3& a, const Indexed3& b, const Indexed3& c, const Indexed3& d,
                     const Indexed3& e) {
  return decide<predicates::InSphere>(perturbed,
                                      {a.point.x, a.point.y, a.point.z, b.point.x, b.point.y, b.point.z,  //
                                       c.point.x, c.point.y, c.point.z, d.point.x, d.point.y, d.point.z,  //
                                       e.point.x, e.point.y, e.point.z},
                                      {a.index, b.index, c.index, d.index, e.index});
}

}  // namespace plumb
