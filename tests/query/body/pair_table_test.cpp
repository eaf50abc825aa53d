// Do the tables of pairs (query/body/pairs.hpp and one for each other question), what compiles, and the pages say the
// same?  Is each pair that relate takes held against an oracle?
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "query/body/pair_types.hpp"

namespace plumb {
namespace {

using pair_cases::oracle_of;
using pair_cases::PairOracle;
using pair_cases::Types;

/// What the compiler says, as plain numbers, so that nothing is instantiated for a pair but the concept.
using Answered = std::array<std::array<bool, figure_kinds>, figure_kinds>;

#define PLUMB_ASKS(Name, ...)                    \
  struct Name {                                  \
    template <class A, class B>                  \
    static constexpr bool holds = (__VA_ARGS__); \
  };
PLUMB_ASKS(AskRelatable, Relatable<A, B>)
PLUMB_ASKS(AskContaining, Containing<A, B>)
PLUMB_ASKS(AskMeasurable, Measurable<A, B>)
PLUMB_ASKS(AskHittable, Hittable<A, B>)
PLUMB_ASKS(
    AskHit, requires(const A& a, const B& b) {
      { hits(a, b) } -> std::same_as<bool>;
    })
PLUMB_ASKS(AskIntersectable, Intersectable<A, B>)
PLUMB_ASKS(AskTranslating, Collidable<Translating<A>, Translating<B>>)
PLUMB_ASKS(AskMoving, Collidable<Moving<A>, Moving<B>>)
#undef PLUMB_ASKS

template <class Ask, class A, class... Bs>
constexpr void fill_row(Answered& to, Types<Bs...>) {
  ((to[static_cast<std::size_t>(figure_kind<A>)][static_cast<std::size_t>(figure_kind<Bs>)] =
        Ask::template holds<A, Bs>),
   ...);
}
template <class Ask, class... As>
constexpr Answered answered(Types<As...> all) {
  Answered to{};
  (fill_row<Ask, As>(to, all), ...);
  return to;
}

template <class... Shapes>
std::set<FigureKind> kinds_of(Types<Shapes...>) {
  return {figure_kind<Shapes>...};
}
const std::set<FigureKind>& kinds_of(int dimension) {
  static const std::set<FigureKind> plane = kinds_of(pair_cases::Plane{}), space = kinds_of(pair_cases::Space{});
  return dimension == 2 ? plane : space;
}

std::string of_space(int dimension) { return dimension == 2 ? " of the plane" : " of space"; }

/// `answers` is the table.
template <class Ask, class Answers>
void expect_as_compiled(const std::string& table, Answers answers) {
  constexpr Answered plane = answered<Ask>(pair_cases::Plane{}), space = answered<Ask>(pair_cases::Space{});
  for (const int dimension : {2, 3}) {
    for (const FigureKind a : kinds_of(dimension)) {
      for (const FigureKind b : kinds_of(dimension)) {
        const bool compiles =
            (dimension == 2 ? plane : space)[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
        EXPECT_EQ(answers(a, b, dimension), compiles)
            << table << of_space(dimension) << ": the letter in row " << name_of(a) << ", column " << name_of(b)
            << (compiles ? " is '-' (or that of the other order), but the compiler finds an answer: say which it is"
                         : " promises an answer, but the compiler finds none: it is '-'");
      }
    }
  }
}

struct Question {
  const query::QuestionTable& table;
  const char* file;  // where the letter stands
  const char* page;
};
constexpr Question asked_contains{query::contains_pairs, "query/body/contains_pairs.hpp", "docs/figures.md"},
    asked_closest{query::closest_pairs, "query/body/closest_pairs.hpp", "docs/closest.md"},
    asked_hit{query::hit_pairs, "query/body/hit_pairs.hpp", "docs/rays.md"},
    asked_intersection{query::intersection_pairs, "query/body/intersection_pairs.hpp", "docs/intersection.md"},
    asked_translating{query::translating_pairs, "query/body/contact_pairs.hpp, translating_pairs", "docs/motion.md"},
    asked_moving{query::moving_pairs, "query/body/contact_pairs.hpp, moving_pairs", "docs/motion.md"};

template <class Ask>
void expect_as_compiled(const Question& q) {
  expect_as_compiled<Ask>(q.file,
                          [&q](FigureKind a, FigureKind b, int dimension) { return q.table.answers(a, b, dimension); });
}

TEST(PairTable, SaysWhatCompiles) {
  expect_as_compiled<AskRelatable>("query/body/pairs.hpp", [](FigureKind a, FigureKind b, int dimension) {
    return pair_method(a, b, dimension) != PairMethod::absent;
  });
}
TEST(PairTable, SaysWhatContainsTakes) { expect_as_compiled<AskContaining>(asked_contains); }
TEST(PairTable, SaysWhatClosestPointsTakes) { expect_as_compiled<AskMeasurable>(asked_closest); }
TEST(PairTable, SaysWhatFirstHitTakes) { expect_as_compiled<AskHittable>(asked_hit); }
TEST(PairTable, SaysWhatHitsTakes) { expect_as_compiled<AskHit>(asked_hit); }
TEST(PairTable, SaysWhatIntersectionTakes) { expect_as_compiled<AskIntersectable>(asked_intersection); }
TEST(PairTable, SaysWhatFirstContactTakesAlongLines) { expect_as_compiled<AskTranslating>(asked_translating); }
TEST(PairTable, SaysWhatFirstContactTakesOfMovingVertices) { expect_as_compiled<AskMoving>(asked_moving); }

TEST(PairTable, NoQuestionIsAskedAcrossSpaces) {
  const auto across = []<class Ask>(Ask) {
    return Ask::template holds<Point2, Point3> || Ask::template holds<Segment3, Segment2> ||
           Ask::template holds<Aabb2, Aabb3> || Ask::template holds<Ray2, Sphere3> ||
           Ask::template holds<Triangle3, Point2>;
  };
  EXPECT_FALSE(across(AskRelatable{}) || across(AskContaining{}) || across(AskMeasurable{}) || across(AskHittable{}) ||
               across(AskIntersectable{}) || across(AskTranslating{}) || across(AskMoving{}));
}

TEST(PairTable, RowsAreAsLongAsTheyShallBe) {
  for (const Question& q :
       {asked_contains, asked_closest, asked_hit, asked_intersection, asked_translating, asked_moving}) {
    for (const query::PairRows* rows : {&q.table.space, &q.table.plane}) {
      for (std::size_t i = 0; i < figure_kinds; ++i) {
        const std::string_view row = (*rows)[i];
        if (row.empty()) continue;
        EXPECT_LE(row.size(), figure_kinds) << q.file << ", row " << figure_names[i];
        const std::size_t from = q.table.order == query::PairOrder::either ? i : 0;
        EXPECT_EQ(row.find_first_not_of(' '), from) << q.file << ", row " << figure_names[i];
        EXPECT_EQ(row.find_first_not_of(q.table.letters, from), std::string_view::npos)
            << q.file << ", row " << figure_names[i] << ": the letters are " << q.table.letters;
      }
    }
  }
}

TEST(PairTable, EachPairHasAnOracle) {
  for (const int dimension : {2, 3}) {
    for (const FigureKind a : kinds_of(dimension)) {
      for (const FigureKind b : kinds_of(dimension)) {
        EXPECT_TRUE(pair_method(a, b, dimension) == PairMethod::absent || oracle_of(a, b) != PairOracle::none)
            << name_of(a) << " and " << name_of(b) << of_space(dimension);
      }
    }
  }
}

std::multiset<std::string> lines_of(const std::string& page, const std::string& from) {
  std::multiset<std::string> rows;
  std::ifstream in(PLUMB_SOURCE_DIR "/" + page);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(from)) rows.insert(line);
  }
  return rows;
}
void expect_rows(const std::string& page, const std::string& from, const std::multiset<std::string>& wanted) {
  const auto rows = lines_of(page, from);
  for (const std::string& row : wanted) EXPECT_TRUE(rows.contains(row)) << page << " lacks\n" << row;
  for (const std::string& row : rows) EXPECT_TRUE(wanted.contains(row)) << page << " has\n" << row;
}

/// A row of the page: methods from the diagonal on.
std::string row_of(FigureKind kind, const std::set<FigureKind>& kinds, int dimension) {
  std::string row = "| **" + std::string(name_of(kind)) + "** |";
  for (const FigureKind other : kinds) {
    row += other < kind ? " |" : " " + std::string(name_of(pair_method(kind, other, dimension))) + " |";
  }
  return row;
}

TEST(PairTable, IsThatOfThePage) {
  std::multiset<std::string> wanted;
  for (const int dimension : {2, 3}) {
    for (const FigureKind kind : kinds_of(dimension)) wanted.insert(row_of(kind, kinds_of(dimension), dimension));
  }
  expect_rows("docs/overlap.md", "| **", wanted);
}

/// A row of another question's page: what it is asked with, by method; nothing where there is nothing.
std::string row_of(const query::QuestionTable& table, FigureKind kind, int dimension) {
  std::string row;
  for (std::size_t method = 1; method < table.letters.size(); ++method) {
    std::string others;
    for (const FigureKind other : kinds_of(dimension)) {
      if (table.order == query::PairOrder::either && other < kind) continue;
      if (table.number(kind, other, dimension) != method) continue;
      others += (others.empty() ? "" : ", ") + std::string(name_of(other));
    }
    if (!others.empty()) row += (row.empty() ? "" : "; ") + std::string(table.methods[method]) + ": " + others;
  }
  return row;
}

/// Kinds that are asked with the same are one row.
std::multiset<std::string> rows_of(const query::QuestionTable& table, const std::string& from) {
  std::multiset<std::string> rows;
  for (const int dimension : {2, 3}) {
    std::map<std::string, std::string> kinds_of_row;
    for (const FigureKind kind : kinds_of(dimension)) {
      const std::string row = row_of(table, kind, dimension);
      std::string& kinds = kinds_of_row[row];
      if (!row.empty()) kinds += (kinds.empty() ? "" : ", ") + std::string(name_of(kind));
    }
    for (const auto& [row, kinds] : kinds_of_row) {
      if (!row.empty()) rows.insert(from + std::to_string(dimension) + "D | " + kinds + " | " + row + " |");
    }
  }
  return rows;
}

TEST(PairTable, OfEachQuestionIsThatOfItsPage) {
  for (const Question& q :
       {asked_contains, asked_closest, asked_hit, asked_intersection, asked_translating, asked_moving}) {
    const std::string from = "| " + std::string(q.table.name) + ", ";
    expect_rows(q.page, from, rows_of(q.table, from));
  }
}

template <class Shape>
using Under = Posed<Shape, std::conditional_t<figure_dimension<Shape> == 2, Pose2, Pose>>;

/// What is taken under poses and not as it stands, or the other way round: with the figure posed, and with itself with
/// the other posed, and both.
template <class Ask, class A, class... Bs>
void add_told_apart(std::set<std::string>& to) {
  const auto add = [&to](const std::string& pair, bool as_it_stands, bool posed) {
    if (posed != as_it_stands) to.insert((posed ? "also " : "not ") + pair);
  };
  (add(pair_cases::pair_name<A, Bs>(), Ask::template holds<A, Bs>, Ask::template holds<Under<A>, Bs>), ...);
  add(pair_cases::pair_name<A, A>(), Ask::template holds<A, A>, Ask::template holds<A, Under<A>>);
  add(pair_cases::pair_name<A, A>(), Ask::template holds<A, A>, Ask::template holds<Under<A>, Under<A>>);
}
/// Each figure with itself and a box, in space also with a plane and a triangle.
template <class Ask, class... As, class... Bs>
std::set<std::string> told_apart(Types<As...>, Types<Bs...>) {
  std::set<std::string> pairs;
  (add_told_apart<Ask, As, Bs...>(pairs), ...);
  return pairs;
}

/// A row of the page.
template <class Ask>
std::string row_of_posed(const std::string& question) {
  std::set<std::string> pairs = told_apart<Ask>(pair_cases::Plane{}, Types<Aabb2>{});
  pairs.merge(told_apart<Ask>(pair_cases::Space{}, Types<Aabb3, Plane3, Triangle3>{}));
  std::string row = "| posed, " + question + " | every pair of its table";
  for (const std::string& pair : pairs) row += "; " + pair;
  return row + " |";
}

TEST(PairTable, PosedFiguresAreAskedAsThePageSays) {
  expect_rows("docs/overlap.md", "| posed, ",
              {row_of_posed<AskRelatable>("`relate`, `intersects`"), row_of_posed<AskContaining>("`contains`"),
               row_of_posed<AskMeasurable>("`closest_points`, `distance`"), row_of_posed<AskHittable>("`first_hit`"),
               row_of_posed<AskIntersectable>("`intersection`"),
               row_of_posed<AskTranslating>("`first_contact` of `Translating`"),
               row_of_posed<AskMoving>("`first_contact` of `Moving`")});
}

TEST(PairTable, LeavesOutWhatThePageSays) {
  for (std::size_t i = 0; i < figure_kinds; ++i) {
    const auto kind = static_cast<FigureKind>(i);
    const bool with_axes = !query::is_one_of(kind, {FigureKind::capsule, FigureKind::lozenge, FigureKind::cylinder,
                                                    FigureKind::cone, FigureKind::spherical_cap});
    for (const FigureKind round : {FigureKind::cylinder, FigureKind::cone})
      EXPECT_EQ(pair_method(kind, round, 3) != PairMethod::absent, with_axes) << name_of(kind);
    const bool with_caps = !query::is_one_of(
        kind, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon, FigureKind::capsule,
               FigureKind::lozenge, FigureKind::cylinder, FigureKind::cone, FigureKind::spherical_cap});
    EXPECT_EQ(pair_method(kind, FigureKind::spherical_cap, 3) != PairMethod::absent, with_caps) << name_of(kind);
    for (std::size_t j = 0; j < figure_kinds; ++j) {
      const auto other = static_cast<FigureKind>(j);
      if (kind == FigureKind::spherical_cap || other == FigureKind::spherical_cap) continue;
      if (query::is_one_of(kind, {FigureKind::cylinder, FigureKind::cone}) ||
          query::is_one_of(other, {FigureKind::cylinder, FigureKind::cone}))
        continue;
      EXPECT_NE(pair_method(kind, other, 3), PairMethod::absent) << name_of(kind) << " and " << name_of(other);
    }
  }
}

}  // namespace
}  // namespace plumb
