// All pairs of straight edges and flat faces against brute force in rationals, and all that CGAL has against CGAL.
//
// Cost: brute force is instantiated once a kind.
#pragma once

#include "oracle/meetings.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_oracle.hpp"
#include "query/body/pair_questions.hpp"

namespace plumb::pair_cases {

/// Both questions, both ways round.
inline void expect_relation(const PairRow& pair, const AnyFigure& a, const AnyFigure& b, Relation expected,
                            const Material& m) {
  const auto name = [&] { return pair.name() + about(m, a, b); };
  EXPECT_EQ(relate(pair, a, b), expected) << name();
  EXPECT_EQ(relate_back(pair, b, a), expected) << "swapped: " << name();
  EXPECT_EQ(intersects(pair, a, b), expected != Relation::disjoint) << name();
  EXPECT_EQ(intersects_back(pair, b, a), expected != Relation::disjoint) << "swapped: " << name();
}

/// Of a figure with straight edges and flat faces.
template <class All>
oracle::Cells cells_of(All all, const AnyFigure& s) {
  return on_kind<oracle::Cells>(all, s, []<class Shape>(const Shape& shape) -> oracle::Cells {
    if constexpr (query::FlatFigure<Shape>) {
      return oracle::cells(shape);
    } else {
      throw std::logic_error("brute force has no cells of a round figure");
    }
  });
}

template <class All>
void expect_all_as_oracle(All all, std::uint64_t start) {
  AnswersByKind answers{};
  for (const PairRow& pair : pairs_of(all)) {
    const FigureKind of_a = pair.a->kind, of_b = pair.b->kind;
    if (oracle_of(of_a, of_b) != PairOracle::cells) continue;
    Answers one;
    shape_cases::on_shapes(start++, cases_by_brute_force(of_a, of_b), [&](Material& m) {
      const auto [a, b] = pair_of(pair, m);
      const Relation expected = oracle::relation(cells_of(all, a), cells_of(all, b));
      one.add(expected);
      expect_relation(pair, a, b, expected, m);
    });
    add_to_kinds(answers, of_a, of_b, one);
  }
  expect_every_answer(answers);
}

/// Those that CGAL has.
template <class All,
          class CgalFigure = std::conditional_t<std::is_same_v<All, Plane>, oracle::CgalFigure2, oracle::CgalFigure3>>
std::optional<CgalFigure> cgal_figure(All all, const AnyFigure& s) {
  return on_kind<std::optional<CgalFigure>>(all, s, []<class Shape>(const Shape& shape) -> std::optional<CgalFigure> {
    if constexpr (std::is_constructible_v<CgalFigure, Shape>) {
      return CgalFigure(shape);
    } else {
      return {};
    }
  });
}

/// All pairs that CGAL has, where it accepts both shapes.
template <class All>
void expect_all_as_cgal(All all, std::uint64_t start) {
  int asked = 0, meet = 0, pairs = 0;
  for (const PairRow& pair : pairs_of(all)) {
    Material any(start, 0);
    if (const auto [a, b] = pair_of(pair, any); !cgal_figure(all, a) || !cgal_figure(all, b)) continue;
    int of_pair = 0;
    shape_cases::on_shapes(start++, cases_of_pair, [&](Material& m) {
      const AnyPair drawn = pair_of(pair, m);
      const AnyFigure &a = drawn.a, &b = drawn.b;
      const std::optional<bool> expected = oracle::meet_by_cgal(*cgal_figure(all, a), *cgal_figure(all, b));
      if (!expected) return;
      ++of_pair;
      meet += *expected;
      const auto name = [&] { return pair.name() + about(m, a, b); };
      EXPECT_EQ(intersects(pair, a, b), *expected) << name();
      EXPECT_EQ(intersects_back(pair, b, a), *expected) << "swapped: " << name();
    });
    EXPECT_GE(static_cast<std::uint64_t>(of_pair) * 4, cases_of_pair * shape_cases::more) << pair.name();
    asked += of_pair;
    ++pairs;
  }
  std::printf("CGAL answered %d of %d pairs, of which %d meet\n", asked, pairs, meet);
  EXPECT_GE(meet * 5, asked);
  EXPECT_GE((asked - meet) * 5, asked);
}

}  // namespace plumb::pair_cases
