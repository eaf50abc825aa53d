// What must hold of every pair of the table?  The answer of brute force, and the laws.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

#include "plumb/query/overlap.hpp"
#include "query/pair_oracle.hpp"
#include "query/pair_shapes.hpp"

namespace plumb::pair_cases {

template <class... Shapes>
struct Types {};

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
std::string pair_name() {
  return std::string(name_of(figure_kind<A>)) + " and " + std::string(name_of(figure_kind<B>));
}

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

/// Of each kind with all others.
using AnswersByKind = std::array<Answers, figure_kinds>;

template <class A, class B>
void expect_pair_as_oracle(AnswersByKind& answers, std::uint64_t start, std::uint64_t cases) {
  const Answers one = expect_as_oracle<A, B>(start, is_costly<A> || is_costly<B> ? cases / 4 : cases);
  answers[static_cast<std::size_t>(figure_kind<A>)].add(one);
  answers[static_cast<std::size_t>(figure_kind<B>)].add(one);
}

template <class A, class... Bs>
void expect_row_as_oracle(Types<A, Bs...>, AnswersByKind& answers, std::uint64_t start, std::uint64_t cases) {
  expect_pair_as_oracle<A, A>(answers, start, cases);
  (expect_pair_as_oracle<A, Bs>(answers, start, cases), ...);
  if constexpr (sizeof...(Bs) > 0) expect_row_as_oracle(Types<Bs...>{}, answers, start + 1, cases);
}

/// Each answer in at least one case of fifty of every kind.
template <class... Shapes>
void expect_all_as_oracle(Types<Shapes...> types, std::uint64_t start, std::uint64_t cases) {
  AnswersByKind answers{};
  expect_row_as_oracle(types, answers, start, cases);
  for (const FigureKind kind : {figure_kind<Shapes>...}) {
    const Answers& of_kind = answers[static_cast<std::size_t>(kind)];
    std::printf("%s: disjoint %d, touching %d, overlapping %d\n", std::string(name_of(kind)).c_str(),
                of_kind.of(Relation::disjoint), of_kind.of(Relation::touching), of_kind.of(Relation::overlapping));
    for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
      EXPECT_GE(of_kind.of(r) * 50, of_kind.all()) << name_of(kind);
  }
}

}  // namespace plumb::pair_cases
