// What do two figures answer whose kinds are known at run time?  The call by their types, compiled for every pair that a
// question takes.
//
// Laws: `ask` is called with both figures as the structs that they are, if it takes these two; any other pair throws
// Unsupported.
// Cost: two jumps.  Each pair of the question's table is an instantiation, no other is: a question has a file of its own.
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

/// The pairs that relate takes, and those of a table.
struct RelatedPairs {
  static constexpr bool answers(FigureKind a, FigureKind b, int dimension) {
    return pair_method(a, b, dimension) != PairMethod::absent;
  }
};
template <const QuestionTable& table>
struct PairsOf {
  static constexpr bool answers(FigureKind a, FigureKind b, int dimension) { return table.answers(a, b, dimension); }
};

/// Asks two figures of one dimension.
template <class Pairs, int Dimension, class Answer, class Ask, class Refuse>
Answer asked_in_dimension(const FigureView& a, const FigureView& b, const Ask& ask, const Refuse& refuse) {
  const auto ask_first = [&]<class A>(const A*) -> Answer requires(figure_dimension<A> == Dimension) {
    const auto ask_both = [&]<class B>(const B*) -> Answer requires(
                                                     figure_dimension<B> == Dimension &&
                                                     Pairs::answers(figure_kind<A>, figure_kind<B>, Dimension) &&
                                                     requires(const A& x, const B& y) { ask(x, y); }) {
      return ask(*static_cast<const A*>(a.shape), *static_cast<const B*>(b.shape));
    };
    return with_figure_type_if<Dimension>(b, ask_both, refuse);
  };
  return with_figure_type_if<Dimension>(a, ask_first, refuse);
}

template <class Pairs, class Answer, class Ask>
Answer asked_by_types(std::string_view question, const FigureView& a, const FigureView& b, const Ask& ask) {
  const auto refuse = [&]() -> Answer { refuse_pair(question, a, b); };
  if (a.dimension != b.dimension) refuse();
  return a.dimension == 2 ? asked_in_dimension<Pairs, 2, Answer>(a, b, ask, refuse)
                          : asked_in_dimension<Pairs, 3, Answer>(a, b, ask, refuse);
}

/// Of a question that both orders have: it is asked in that of FigureKind alone, which answers the other one.
template <class Pairs, class Answer, class Ask>
Answer asked_in_order(std::string_view question, const FigureView& a, const FigureView& b, const Ask& ask) {
  struct InOrder {
    static constexpr bool answers(FigureKind i, FigureKind j, int dimension) {
      return i <= j && Pairs::answers(i, j, dimension);
    }
  };
  return asked_by_types<InOrder, Answer>(question, a, b, ask);
}

}  // namespace plumb::query
