// What must hold of every pair of the table?  The answer of brute force, and the laws.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "certify/sanitized.hpp"
#include "oracle/meetings.hpp"
#include "query/body/pair_oracle.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/body/pair_types.hpp"

namespace plumb::pair_cases {

/// Cases in an ordinary run, of which the long run takes shape_cases::more as many, and the sanitized one a quarter or
/// less: of each pair of shapes, of one whose brute force is costly, and of each pair for the laws.
inline constexpr std::uint64_t cases_of_pair = battery::sanitized ? 12 : 64,
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

template <class A, class B>
Answers expect_as_oracle(std::uint64_t start, std::uint64_t cases) {
  Answers answers;
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const auto [a, b] = pair_of<A, B>(m);
    const Relation expected = oracle::relation(oracle::cells(a), oracle::cells(b));
    answers.add(expected);
    EXPECT_EQ(relate(a, b), expected) << pair_name<A, B>() << m.about(a, b);
    EXPECT_EQ(relate(b, a), expected) << pair_name<B, A>() << m.about(b, a);
    EXPECT_EQ(intersects(a, b), expected != Relation::disjoint) << pair_name<A, B>() << m.about(a, b);
    EXPECT_EQ(intersects(b, a), expected != Relation::disjoint) << pair_name<B, A>() << m.about(b, a);
  });
  return answers;
}

/// Brute force costs most for polygons and for what halfspaces bound.
template <class Shape>
inline constexpr bool is_costly = query::is_one_of(figure_kind<Shape>, {FigureKind::quadrilateral, FigureKind::polygon,
                                                                        FigureKind::holed_polygon, FigureKind::k_dop,
                                                                        FigureKind::halfspace_intersection});
template <class A, class B>
inline constexpr std::uint64_t cases_by_brute_force =
    is_costly<A> || is_costly<B> ? cases_of_costly_pair : cases_of_pair;

/// Of each kind with all others.
using AnswersByKind = std::array<Answers, figure_kinds>;

template <class A, class B>
void add_to_kinds(AnswersByKind& answers, const Answers& one) {
  answers[static_cast<std::size_t>(figure_kind<A>)].add(one);
  if (figure_kind<A> != figure_kind<B>) answers[static_cast<std::size_t>(figure_kind<B>)].add(one);
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

/// All pairs of straight edges and flat faces.
template <class All>
void expect_all_as_oracle(All all, std::uint64_t start) {
  AnswersByKind answers{};
  on_pairs_of<PairOracle::cells>(all, [&]<class A, class B>(const A*, const B*) {
    add_to_kinds<A, B>(answers, expect_as_oracle<A, B>(start++, cases_by_brute_force<A, B>));
  });
  expect_every_answer(answers);
}

template <class Shape>
using CgalFigure = std::conditional_t<figure_dimension<Shape> == 2, oracle::CgalFigure2, oracle::CgalFigure3>;

/// All pairs that CGAL has, where it accepts both shapes.
template <class All>
void expect_all_as_cgal(All all, std::uint64_t start) {
  int asked = 0, meet = 0;
  on_pairs(all, [&]<class A, class B>(const A*, const B*) {
    if constexpr (std::is_constructible_v<CgalFigure<A>, A> && std::is_constructible_v<CgalFigure<B>, B>) {
      int of_pair = 0;
      shape_cases::on_shapes(start++, cases_of_pair, [&](Material& m) {
        const auto [a, b] = pair_of<A, B>(m);
        const std::optional<bool> expected = oracle::meet_by_cgal(CgalFigure<A>(a), CgalFigure<B>(b));
        if (!expected) return;
        ++of_pair;
        meet += *expected;
        EXPECT_EQ(intersects(a, b), *expected) << pair_name<A, B>() << m.about(a, b);
        EXPECT_EQ(intersects(b, a), *expected) << pair_name<B, A>() << m.about(b, a);
      });
      EXPECT_GE(static_cast<std::uint64_t>(of_pair) * 4, cases_of_pair * shape_cases::more) << pair_name<A, B>();
      asked += of_pair;
    }
  });
  std::printf("CGAL answered %d, of which %d meet\n", asked, meet);
  EXPECT_GE(meet * 5, asked);
  EXPECT_GE((asked - meet) * 5, asked);
}

}  // namespace plumb::pair_cases
