#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

double distance_of_views(const PosedView& a, const PosedView& b, Question question) {
  require_answer(closest_pairs, name_of(question), a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) return posed_distance(a, b, question);
  if (b.figure.kind < a.figure.kind) return distance_of_views(b, a, question);
  return asked_in_order<PairsOf<closest_pairs>, double>(
      name_of(question), a.figure,
      b.figure, [question](const auto& x, const auto& y) requires requires { distance_as(Question::distance, x, y); } {
        return distance_as(question, x, y);
      });
}

ExactDistance exact_distance_of_views(const PosedView& a, const PosedView& b, Question question) {
  require_answer(closest_pairs, name_of(question), a.figure, b.figure);
  const bool is_squared = question == Question::squared_distance_exact;
  const auto is_ball = [](const PosedView& v) {
    return is_one_of(v.figure.kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge});
  };
  if (is_squared && (is_ball(a) || is_ball(b))) refuse_pair(name_of(question), a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) return posed_exact_distance(a, b, question);
  if (b.figure.kind < a.figure.kind) return exact_distance_of_views(b, a, question);
  if (is_squared) {
    return asked_in_order<PairsOf<closest_pairs>, ExactDistance>(
        name_of(question), a.figure, b.figure, [](const auto& x, const auto& y) requires requires {
          squared_distance_exact(x, y);
        } { return ExactDistance{squared_distance_exact(x, y)}; });
  }
  return asked_in_order<PairsOf<closest_pairs>, ExactDistance>(
      name_of(question), a.figure, b.figure,
      [](const auto& x, const auto& y) requires requires { exact_distance(x, y); } { return exact_distance(x, y); });
}

}  // namespace

// Whichever question it is asked for, which an error names.
double any_distance(const PosedView& a, const PosedView& b, Question question) {
  return recorded("distance", {a, b}, {}, [&] { return distance_of_views(a, b, question); });
}
ExactDistance any_exact_distance(const PosedView& a, const PosedView& b, Question question) {
  const bool is_squared = question == Question::squared_distance_exact;
  return recorded(is_squared ? "squared_distance_exact" : "exact_distance", {a, b}, {},
                  [&] { return exact_distance_of_views(a, b, question); });
}

}  // namespace plumb::query
