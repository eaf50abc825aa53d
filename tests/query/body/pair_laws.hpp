// How many cases has each pair of the table, and did every answer come?
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "certify/sanitized.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/body/pair_types.hpp"

namespace plumb::pair_cases {

/// Cases in an ordinary run, of which the long run takes shape_cases::more as many, and the sanitized one a quarter or
/// less: of each pair of shapes, of one whose brute force is costly, and of each pair for the laws.
inline const std::uint64_t cases_of_pair = battery::sanitized ? 12 : 64,
                           cases_of_costly_pair = battery::sanitized ? 1 : 16,
                           cases_of_law = battery::sanitized ? 8 : 32;

/// How often each answer came, of all pairs together.
class Answers {
 public:
  void add(Relation r) { ++of_[static_cast<std::size_t>(static_cast<int>(r) + 1)]; }
  void add(const Answers& others) {
    for (std::size_t i = 0; i < of_.size(); ++i) of_[i] += others.of_[i];
  }
  [[nodiscard]] int all() const { return of_[0] + of_[1] + of_[2]; }
  [[nodiscard]] int of(Relation r) const { return of_[static_cast<std::size_t>(static_cast<int>(r) + 1)]; }

 private:
  std::array<int, 3> of_{};
};

template <class A, class B>
std::pair<A, B> pair_of(Material& m) {
  if constexpr (figure_kind<A> == FigureKind::point) {  // near to what is there
    B b = figure<B>(m);
    A a = figure<A>(m);
    return {std::move(a), std::move(b)};
  } else {
    A a = figure<A>(m);
    B b = near_figure<B>(m);
    return {std::move(a), std::move(b)};
  }
}

/// Brute force costs most for polygons and for what halfspaces bound.
constexpr bool is_costly(FigureKind k) {
  return query::is_one_of(k, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon,
                              FigureKind::k_dop, FigureKind::halfspace_intersection});
}
constexpr std::uint64_t cases_by_brute_force(FigureKind a, FigureKind b) {
  return is_costly(a) || is_costly(b) ? cases_of_costly_pair : cases_of_pair;
}

/// Of each kind with all others.
using AnswersByKind = std::array<Answers, figure_kinds>;

inline void add_to_kinds(AnswersByKind& answers, FigureKind a, FigureKind b, const Answers& one) {
  answers[static_cast<std::size_t>(a)].add(one);
  if (a != b) answers[static_cast<std::size_t>(b)].add(one);
}
template <class A, class B>
void add_to_kinds(AnswersByKind& answers, const Answers& one) {
  add_to_kinds(answers, figure_kind<A>, figure_kind<B>, one);
}

/// Each answer in at least one case of fifty of every kind that was asked.
inline void expect_every_answer(const AnswersByKind& answers) {
  for (std::size_t i = 0; i < figure_kinds; ++i) {
    const Answers& of_kind = answers[i];
    if (of_kind.all() == 0) continue;
    std::printf("%s: disjoint %d, touching %d, overlapping %d\n", std::string(figure_names[i]).c_str(),
                of_kind.of(Relation::disjoint), of_kind.of(Relation::touching), of_kind.of(Relation::overlapping));
    for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
      EXPECT_GE(of_kind.of(r) * 50, of_kind.all()) << figure_names[i];
  }
}

}  // namespace plumb::pair_cases
