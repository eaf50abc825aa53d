// Orientation tests: on which side of this one line, plane, circle or sphere do points lie?  A predicate with the last
// point left open.
//
// Laws: (1) Side<F>(a, b, ...)(p) is the sign of F at a, b, ..., p, for all finite doubles.  (2) What is NaN or
//       infinite throws NonFinite by name, a given point when the object is made.  (3) An object is a value.
// The minors of the given points are computed once, with their magnitudes.  A query is the last sum of products, with a
// filter of its own; where that is unsure the predicate's exact stages are asked (certify/detail/side_form.hpp).
// Many points at once, side(points, out): the laws of certify/batch.hpp, and its library, plumb::batch.
// Source: RTCD 3.1.6, 13.7; docs/batches.md.
// Cost: to make one about twice the plain formula; a query 5 to 15 operations and its filter.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include "plumb/arith/filtered.hpp"
#include "plumb/arith/point.hpp"
#include "plumb/certify/batch.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/detail/side_form.hpp"

namespace plumb {

template <Formula F>
class Side;

namespace certify::side {

// Of many points, in the library plumb::batch.
void decide_all(const Side<predicates::Orient2d>& side, std::span<const Point2> points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::Orient2d>& side, const Points2View& points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::Orient3d>& side, std::span<const Point3> points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::Orient3d>& side, const Points3View& points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::InCircle>& side, std::span<const Point2> points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::InCircle>& side, const Points2View& points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::InSphere>& side, std::span<const Point3> points, std::span<Sign> out,
                Execution execution);
void decide_all(const Side<predicates::InSphere>& side, const Points3View& points, std::span<Sign> out,
                Execution execution);

template <class F>
using PointOf = std::conditional_t<F::dimension == 2, Point2, Point3>;
template <class F>
using PointsViewOf = std::conditional_t<F::dimension == 2, Points2View, Points3View>;

inline std::array<double, 2> numbers_of(const Point2& p) { return {p.x, p.y}; }
inline std::array<double, 3> numbers_of(const Point3& p) { return {p.x, p.y, p.z}; }

template <std::size_t... I>
constexpr std::array<Filtered, sizeof...(I)> zeros(std::index_sequence<I...>) {
  return {(static_cast<void>(I), Filtered(0, 0))...};
}

/// The guards of a query's products, which are added up first (docs/proof.md, "Filter A").
template <Formula F>
inline constexpr double guards = static_cast<double>(form_of<F>.variables) * underflow_guard;

}  // namespace certify::side

template <Formula F>
class Side {
 public:
  static constexpr std::size_t dimension = certify::side::dimension<F>;
  static constexpr std::size_t variables = certify::side::form_of<F>.variables;
  using Point = certify::side::PointOf<F>;
  using PointsView = certify::side::PointsViewOf<F>;

  Side(const Point& a, const Point& b) requires(F::points == 3) : Side(std::array{a, b}) {}
  Side(const Point& a, const Point& b, const Point& c) requires(F::points == 4) : Side(std::array{a, b, c}) {}
  Side(const Point& a, const Point& b, const Point& c, const Point& d) requires(F::points == 5)
      : Side(std::array{a, b, c, d}) {}

  /// The sign for the point p; the recorder is told which stage decided.
  template <class Recorder = NoRecorder>
  PLUMB_CHECKABLE Sign operator()(const Point& p, Recorder&& recorder = {}) const {
    assert_sound_thread();
    if (const int s = filter(p); s != 0) [[likely]] {
      recorder.decided(Stage::filter);
      return static_cast<Sign>(s);
    }
    const Decision d = decide_exactly<F>(with_query(p));
    recorder.decided(d.stage);
    return d.sign;
  }

  /// out[i] is the sign for points[i].
  void operator()(std::span<const Point> points, std::span<Sign> out, Execution execution = Execution::serial) const {
    certify::side::decide_all(*this, points, out, execution);
  }
  void operator()(const PointsView& points, std::span<Sign> out, Execution execution = Execution::serial) const {
    certify::side::decide_all(*this, points, out, execution);
  }

  /// -1, 0 or 1, where 0 is 'unsure'.
  [[nodiscard]] int filter(const Point& p) const {
    const auto number = variables_at(p, std::make_index_sequence<certify::side::form_of<F>.query.size>());
    double value = 0, magnitude = certify::side::guards<F>;
    for (std::size_t v = 0; v < variables; ++v) {
      const Filtered& x = number[certify::side::form_of<F>.variable[v]];
      value = v == 0 ? x.value * coefficient_[v] : value + x.value * coefficient_[v];
      magnitude += x.magnitude * magnitude_[v];
    }
    return beyond(value, certify::side::constant<F> * magnitude);
  }

  /// The coordinates of the formula, with p as the last point.
  [[nodiscard]] Coordinates<F> with_query(const Point& p) const {
    Coordinates<F> all = given_;
    const auto q = certify::side::numbers_of(p);
    for (std::size_t a = 0; a < dimension; ++a) all[arity<F> - dimension + a] = q[a];
    return all;
  }

  /// The coordinates of the given points, then zeros.
  [[nodiscard]] const Coordinates<F>& given() const { return given_; }
  /// The point that is subtracted from a query, by axis.
  [[nodiscard]] double pivot(std::size_t axis) const { return given_[certify::side::pivot<F> * dimension + axis]; }
  /// What variable v of the form is multiplied with, and the magnitude of that.
  [[nodiscard]] double coefficient(std::size_t v) const { return coefficient_[v]; }
  [[nodiscard]] double magnitude(std::size_t v) const { return magnitude_[v]; }

 private:
  explicit Side(const std::array<Point, certify::side::points<F> - 1>& given) {
    bool finite = true;  // told one by one: require_finite loads pairs, and would wait for what is just being stored
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto numbers = certify::side::numbers_of(given[i]);
      for (std::size_t a = 0; a < dimension; ++a) {
        given_[i * dimension + a] = numbers[a];
        if (!(numbers[a] - numbers[a] == 0)) [[unlikely]]
          finite = false;
      }
    }
    if (!finite) [[unlikely]]
      require_finite<F>(given_);
    run_fixed(std::make_index_sequence<certify::side::form_of<F>.fixed.size>());
  }

  /// The numbers of the query's tape: differences to the pivot, then its results.
  template <std::size_t... I>
  auto variables_at(const Point& p, std::index_sequence<I...>) const {
    const auto q = certify::side::numbers_of(p);
    auto number = certify::side::zeros(std::make_index_sequence<dimension + sizeof...(I)>());
    for (std::size_t a = 0; a < dimension; ++a) number[a] = Filtered::Rounded{q[a] - pivot(a)};
    [[maybe_unused]] const auto run = [&]<std::size_t N>() {
      constexpr certify::tape::Instruction in = certify::side::form_of<F>.query.instructions[N];
      const Filtered &l = number[in.left], &r = number[in.right];
      if constexpr (in.operation == '*' && in.left < dimension && in.right < dimension) {
        number[dimension + N] = Filtered::Rounded{l.value} * Filtered::Rounded{r.value};
      } else {
        number[dimension + N] = in.operation == '*' ? l * r : in.operation == '-' ? l - r : l + r;
      }
    };
    (run.template operator()<I>(), ...);
    return number;
  }

  template <std::size_t... I>
  void run_fixed(std::index_sequence<I...>) {
    constexpr const auto& form = certify::side::form_of<F>;
    // The coordinates are numbers too, but are used in differences only.
    auto number = certify::side::zeros(std::index_sequence<I...>());
    const auto run = [&]<std::size_t N>() {
      constexpr certify::tape::Instruction in = form.fixed.instructions[N];
      if constexpr (in.left < arity<F>) {
        number[N] = Filtered::Rounded{given_[in.left] - given_[in.right]};
      } else {
        const Filtered &l = number[in.left - arity<F>], &r = number[in.right - arity<F>];
        number[N] = in.operation == '*' ? l * r : in.operation == '-' ? l - r : l + r;
      }
    };
    [[maybe_unused]] const bool in_turn[]{(run.template operator()<I>(), true)...};
    for (std::size_t v = 0; v < variables; ++v) {
      const Filtered& c = number[form.coefficient[v].number - arity<F>];
      coefficient_[v] = form.coefficient[v].negative ? -c.value : c.value;
      magnitude_[v] = c.magnitude;
    }
  }

  Coordinates<F> given_{};
  std::array<double, variables> coefficient_{}, magnitude_{};
};

/// side(p) is orient2d(a, b, p): positive to the left of the line from a to b.
using LineSide = Side<predicates::Orient2d>;
/// side(p) is orient3d(a, b, c, p): positive below the plane of a, b, c, where 'above' sees them counterclockwise.
using PlaneSide = Side<predicates::Orient3d>;
/// side(p) is incircle(a, b, c, p): for counterclockwise a, b, c positive inside their circle.
using CircleSide = Side<predicates::InCircle>;
/// side(p) is insphere(a, b, c, d, p): for orient3d(a, b, c, d) > 0 positive inside their sphere.
using SphereSide = Side<predicates::InSphere>;

}  // namespace plumb
