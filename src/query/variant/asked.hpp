// What do two figures answer whose kinds are known at run time?  The call by their types, compiled for every pair that a
// question takes.
//
// Laws: `ask` is called with both figures as the structs that they are, if it takes these two; any other pair throws
// Unsupported.
// Cost: two jumps.  Each pair is an instantiation: a question has a file of its own.
#pragma once

#include <optional>

#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/body/question_table.hpp"

namespace plumb::query {

inline bool is_posed_view(const PosedView& v) { return !v.pose.stands(); }
/// Of a triangle of space under a matrix, which has questions of its own.
inline std::optional<Posed<Triangle3>> posed_triangle(const PosedView& v) {
  const auto* matrix = std::get_if<const Pose*>(&v.pose.by);
  if (v.figure.kind != FigureKind::triangle || matrix == nullptr) return {};
  return Posed<Triangle3>{*static_cast<const Triangle3*>(v.figure.shape), **matrix};
}

inline void require_related(std::string_view question, const FigureView& a, const FigureView& b) {
  if (a.dimension != b.dimension || pair_method(a.kind, b.kind, a.dimension) == PairMethod::absent)
    refuse_pair(question, a, b);
}
inline void require_answer(const QuestionTable& table, std::string_view question, const FigureView& a,
                           const FigureView& b) {
  if (a.dimension != b.dimension || !table.answers(a.kind, b.kind, a.dimension)) refuse_pair(question, a, b);
}

template <class Answer, class Ask>
Answer asked_by_types(std::string_view question, const FigureView& a, const FigureView& b, const Ask& ask) {
  if (a.dimension != b.dimension) refuse_pair(question, a, b);
  return with_figure(a, [&]<class A>(const A& first) -> Answer {
    return with_figure(b, [&]<class B>(const B& second) -> Answer {
      if constexpr (figure_dimension<A> == figure_dimension<B>) {
        if constexpr (requires { ask(first, second); }) return ask(first, second);
      }
      refuse_pair(question, a, b);
    });
  });
}

/// Of a question that both orders have: it is asked in that of FigureKind alone, which answers the other one.
template <class Answer, class Ask>
Answer asked_in_order(std::string_view question, const FigureView& a, const FigureView& b, const Ask& ask) {
  return asked_by_types<Answer>(
      question, a, b,
      [&ask]<class A, class B>(const A& first, const B& second)  //
      requires(!OtherWayRound<A, B> && requires { ask(first, second); }) { return ask(first, second); });
}

}  // namespace plumb::query
