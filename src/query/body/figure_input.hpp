// Are these figures at all, that a question is asked about?  One answer for all questions.
//
// Laws: those of figure/basic/sound.hpp, and InvalidShape for a k-DOP whose ends are not as many as its directions.  The
// text names the function, then the part by what its figure is, which tells in whichever order the two were given
// ("distance: triangle.c.y is nan, ..."); of two figures of one kind the first is a, the second b.
// Cost: an addition a number, in a tree; lists are looked through.
#pragma once

#include <string_view>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/query/body/detail/question.hpp"
#include "plumb/query/body/pairs.hpp"

namespace plumb::query {

using figure::is_real, figure::is_sound, figure::sum_of;

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
