// Are these figures at all, that a question is asked about?  One answer for all questions.
//
// Laws: NonFinite for a number that is none, InvalidShape for a negative radius, a chain of fewer than three vertices,
// a polyhedron without faces and a k-DOP whose ends are not as many as its directions.  The text names the function,
// then the part by what its figure is, which tells in whichever order the two were given ("distance: triangle.c.y is
// nan, ..."); of two figures of one kind the first is a, the second b.
// Cost: an addition a number, in a tree; lists are looked through.
#pragma once

#include <algorithm>
#include <string_view>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/body/detail/question.hpp"
#include "plumb/query/body/pairs.hpp"
#include "query/body/figure_parts.hpp"

namespace plumb::query {

template <class Numbers>
constexpr double sum_of(const Numbers& x) {
  if constexpr (requires { x.z; }) {
    return x.x + (x.y + x.z);
  } else if constexpr (requires { x.y; }) {
    return x.x + x.y;
  } else if constexpr (requires { x.begin(); }) {
    double sum = 0;
    for (const auto& item : x) sum += sum_of(item);
    return sum;
  } else {
    return x;
  }
}
constexpr bool is_real(double sum) { return sum - sum == 0; }

/// May the figure go to the quick tests?  Not where a sum of real numbers is beyond all doubles.
template <class Shape>
bool is_sound(const Shape& s) {
  if constexpr (requires { s.directions; }) {
    const std::size_t n = s.directions.size();
    return s.min.size() == n && s.max.size() == n && is_real(sum_of(s.min) + sum_of(s.max));
  } else if constexpr (requires { s.halfspaces; }) {
    return std::ranges::all_of(s.halfspaces, [](const auto& h) { return is_sound(h); });
  } else if constexpr (requires { s.mesh; }) {
    return !s.mesh.corners.empty() && is_real(sum_of(s.mesh.vertices));
  } else if constexpr (requires { s.outer; }) {
    return is_sound(s.outer) && std::ranges::all_of(s.holes, [](const auto& hole) { return is_sound(hole); });
  } else if constexpr (requires { s.vertices; }) {
    return s.vertices.size() >= 3 && is_real(sum_of(s.vertices));
  } else {
    const double sum = std::apply([](const auto&... part) { return (sum_of(part.numbers) + ...); }, parts(s));
    if constexpr (HasRadius<Shape>) {
      return is_real(sum) && s.radius >= 0;
    } else {
      return is_real(sum);
    }
  }
}

/// Of what is sound: is there no point in it?  Only axis-aligned boxes can say so at a glance.
template <class Shape>
constexpr bool is_nothing(const Shape& s) {
  if constexpr (requires { s.min.x, s.max.x; }) {
    return is_empty(s);
  } else {
    return false;
  }
}

/// By another name than that of its kind.
void require_figure(std::string_view function, std::string_view name, const FigureView& figure);
template <Figure Shape>
void require_figure(std::string_view function, std::string_view name, const Shape& s) {
  if (!is_sound(s)) [[unlikely]]
    require_figure(function, name, view_of(s));
}

void require_figures(std::string_view function, const FigureView& a, const FigureView& b);
template <Figure A, Figure B>
void require_figures(std::string_view function, const A& a, const B& b) {
  if (!is_sound(a) || !is_sound(b)) [[unlikely]]
    require_figures(function, view_of(a), view_of(b));
}

template <Figure A, Figure B>
void require_figures(Question question, const A& a, const B& b) {
  if (!is_sound(a) || !is_sound(b)) [[unlikely]]
    require_figures(name_of(question), view_of(a), view_of(b));
}

/// What a text calls it.
std::string_view spoken(const FigureView& figure);

}  // namespace plumb::query
