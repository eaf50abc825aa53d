// What do all batches do before the first vector?  Lengths are compared, spans become cases.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "certify/batch/cases.hpp"
#include "plumb/certify/side.hpp"

namespace plumb::certify::batch {

template <class Point>
inline constexpr std::size_t dimension_of = sizeof(Point) / sizeof(double);

inline std::array<std::span<const double>, 2> axes_of(const Points2View& v) { return {v.x, v.y}; }
inline std::array<std::span<const double>, 3> axes_of(const Points3View& v) { return {v.x, v.y, v.z}; }

/// Looks that a span of that name is as long as the first argument's.
class EqualLengths {
 public:
  EqualLengths(std::string_view formula, std::string_view first, std::size_t length)
      : formula_(formula), first_(first), length_(length) {}

  void look(std::string_view name, std::size_t length) const {
    if (length != length_) throw_unequal(formula_, name, length, first_, length_);
  }
  template <class Point>
  void look(char argument, std::span<const Point> points) const {
    look(std::string_view(&argument, 1), points.size());
  }
  template <class View>
  void look_at_axes(char argument, const View& view) const {
    std::array<char, 3> name{argument, '.', 'x'};
    for (const std::span<const double> axis : axes_of(view)) {
      look(std::string_view(name.data(), name.size()), axis.size());
      ++name[2];
    }
  }

 private:
  std::string_view formula_, first_;
  std::size_t length_;
};

/// Argument number `argument` of the cases: these points, one a case.
template <class Point>
void set_points(Cases& cases, std::size_t argument, std::span<const Point> points) {
  constexpr std::size_t dimension = dimension_of<Point>;
  static_assert(dimension * sizeof(double) == sizeof(Point), "a point is its coordinates");
  for (std::size_t k = 0; k < dimension; ++k) {
    cases.at[argument * dimension + k] = reinterpret_cast<const double*>(points.data()) + k;
    cases.stride[argument * dimension + k] = dimension;
  }
}

template <class View>
void set_axes(Cases& cases, std::size_t argument, const View& view) {
  const auto axes = axes_of(view);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    cases.at[argument * axes.size() + k] = axes[k].data();
    cases.stride[argument * axes.size() + k] = 1;
  }
}

inline constexpr std::string_view argument_names = "abcde";

template <Formula F, class Point, std::size_t N>
void ask_points(const std::array<std::span<const Point>, N>& points, std::span<Sign> out, Filter filter,
                Execution execution) {
  const EqualLengths lengths(F::name, "a", points[0].size());
  for (std::size_t p = 1; p < N; ++p) lengths.look(argument_names[p], points[p]);
  lengths.look("out", out.size());
  if (out.empty()) return;
  Cases cases;
  for (std::size_t p = 0; p < N; ++p) set_points(cases, p, points[p]);
  decide_cases(question<F>, cases, filter, nullptr, out, execution);
}

template <Formula F, class View, std::size_t N>
void ask_views(const std::array<View, N>& views, std::span<Sign> out, Filter filter, Execution execution) {
  const EqualLengths lengths(F::name, "a.x", views[0].x.size());
  for (std::size_t p = 0; p < N; ++p) lengths.look_at_axes(argument_names[p], views[p]);
  lengths.look("out", out.size());
  if (out.empty()) return;
  Cases cases;
  for (std::size_t p = 0; p < N; ++p) set_axes(cases, p, views[p]);
  decide_cases(question<F>, cases, filter, nullptr, out, execution);
}

template <Formula F>
Cases given_cases(const Side<F>& side) {
  Cases cases;
  for (std::size_t k = 0; k < arity<F>; ++k) cases.at[k] = &side.given()[k];
  return cases;
}

template <Formula F>
void ask_points(const Side<F>& side, std::span<const certify::side::PointOf<F>> points, std::span<Sign> out,
                Filter filter, Execution execution) {
  EqualLengths(F::name, "points", points.size()).look("out", out.size());
  if (out.empty()) return;
  Cases cases = given_cases(side);
  set_points(cases, certify::side::points<F> - 1, points);
  decide_cases(question<F>, cases, filter, &side, out, execution);
}

template <Formula F>
void ask_views(const Side<F>& side, const certify::side::PointsViewOf<F>& points, std::span<Sign> out, Filter filter,
               Execution execution) {
  const EqualLengths lengths(F::name, "points.x", points.x.size());
  lengths.look("points.y", points.y.size());
  if constexpr (certify::side::dimension<F> == 3) lengths.look("points.z", points.z.size());
  lengths.look("out", out.size());
  if (out.empty()) return;
  Cases cases = given_cases(side);
  set_axes(cases, certify::side::points<F> - 1, points);
  decide_cases(question<F>, cases, filter, &side, out, execution);
}

}  // namespace plumb::certify::batch
