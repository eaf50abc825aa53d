// What is the sign among points of one box?  The filter whose threshold is computed once, from the box.
//
//   const BoundedPoints<Point3> scene(vertices);   // finds the box; NaN and infinity throw, naming the point
//   const auto side = scene.predicate<predicates::Orient3d>();
//   side(0, 1, 2, 3);                              // exact, of the points of these numbers
//
// Laws: the sign is that of decide for the same points.  The points are those that the box was found of, so that none
// can be outside of it; a number that no point has throws NoSuchPoint, naming it.  A predicate refers to its points,
// which must outlive it.
// Source: RTCD 11.2; the semi-static filters of the literature.
// Cost: the bare formula, one comparison, and the check of the numbers; where that is unsure, decide_exactly.
#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <tuple>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

/// No point has this number; the text names the argument and the number.
struct NoSuchPoint : Error {
  using Error::Error;
};

/// The least and the largest coordinate in each axis; all zero for no points.
template <std::size_t Dimension>
struct Bounds {
  std::array<double, Dimension> least{}, largest{};
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Throws NonFinite, naming the point by its number.
Bounds<2> bounds_of(std::span<const Point2> points);
Bounds<3> bounds_of(std::span<const Point3> points);

/// The largest difference (or sum, or coordinate by itself) that F can form of points within the bounds, in each axis;
/// not below the floor of filter B.
template <Formula F>
constexpr Largest<F> largest_within(const Bounds<static_cast<std::size_t>(F::dimension)>& bounds) {
  bool sums = false, alone = false;
  for (const certify::tape::Instruction& i : certify::tape::program<F>().instructions) {
    const bool left = i.left < arity<F>, right = i.right < arity<F>;
    if (left && right && i.operation != '*') {
      sums |= i.operation == '+' || axis_of_input<F>(i.left) != axis_of_input<F>(i.right);
    } else {
      alone |= left || right;
    }
  }
  double widest = 0;  // for a sum, or a difference of two axes
  for (std::size_t k = 0; k < bounds.least.size(); ++k) {
    widest = std::max({widest, magnitude_of(bounds.least[k]), magnitude_of(bounds.largest[k])});
  }
  return per_axis<F>([&](std::size_t k) {
    double most = std::max(largest_floor<F>, bounds.largest[k] - bounds.least[k]);
    if (alone) most = std::max({most, magnitude_of(bounds.least[k]), magnitude_of(bounds.largest[k])});
    if (sums) most = std::max(most, 2 * widest);
    return most;
  });
}

/// The semi-static filter: -1, 0 or 1, where 0 is 'unsure'; for finite coordinates within the bounds whose threshold
/// this is (largest_threshold over largest_within).
template <Formula F>
constexpr int bounded_filter(const Coordinates<F>& p, double threshold) {
  const double value = value_of<F>(p);
  return beyond(value, threshold + (value - value));  // as filter B: NaN where the value overflowed
}

[[noreturn]] void throw_no_such_point(std::string_view formula, std::span<const std::size_t> numbers,
                                      std::size_t count);

template <class Point>
class BoundedPoints {
 public:
  static constexpr int dimension = coordinate_count<Point>;

  /// Copies the points.
  explicit BoundedPoints(std::span<const Point> points)
      : points_(points.begin(), points.end()), bounds_(bounds_of(points)) {}

  [[nodiscard]] std::span<const Point> points() const { return points_; }
  [[nodiscard]] const Bounds<static_cast<std::size_t>(dimension)>& bounds() const { return bounds_; }

  /// F with its threshold for these bounds.
  template <Formula F>
  class Predicate {
   public:
    explicit Predicate(const BoundedPoints& scene)
        : points_(scene.points()), threshold_(largest_threshold<F>(largest_within<F>(scene.bounds()))) {}

    [[nodiscard]] double threshold() const { return threshold_; }

    /// The sign of F at the points of these numbers, one for each point that F takes.
    template <std::integral... Number>
    [[nodiscard]] PLUMB_CHECKABLE Sign operator()(Number... number) const {
      static_assert(sizeof...(Number) == F::points, "BoundedPoints: one number for each point of the formula");
      assert_sound_thread();
      if (((static_cast<std::size_t>(number) >= points_.size()) || ...)) [[unlikely]] {
        throw_no_such_point(F::name, std::array{static_cast<std::size_t>(number)...}, points_.size());
      }
      const auto p = std::apply([](auto... x) { return Coordinates<F>{x...}; },
                                std::tuple_cat(coordinates(points_[static_cast<std::size_t>(number)])...));
      if (const int s = bounded_filter<F>(p, threshold_); s != 0) [[likely]]
        return static_cast<Sign>(s);
      return decide_exactly<F>(p).sign;
    }

   private:
    std::span<const Point> points_;
    double threshold_;
  };

  template <Formula F>
  requires(TakesPoints<F>&& is_homogeneous<F>&& F::dimension == dimension)
      [[nodiscard]] Predicate<F> predicate() const {
    return Predicate<F>(*this);
  }

 private:
  std::vector<Point> points_;
  Bounds<static_cast<std::size_t>(dimension)> bounds_;
};

}  // namespace plumb
