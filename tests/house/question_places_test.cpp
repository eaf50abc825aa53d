// Has every public function that asks contains, first_hit or hits, or first_contact or intersects of what moves, its place
// in the table of the question (query/body/contains_pairs.hpp, hit_pairs.hpp, contact_pairs.hpp), or in the list of what
// no table has a row for (further_pairs.hpp)?
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "house/overloads.hpp"
#include "plumb/query/body/contact_pairs.hpp"
#include "plumb/query/body/contains_pairs.hpp"
#include "plumb/query/body/further_pairs.hpp"
#include "plumb/query/body/hit_pairs.hpp"

namespace plumb::house {
namespace {

const std::vector<std::string> asked{"contains", "first_hit",     "first_hit_parameter", "hits",
                                     "any_hit",  "first_contact", "first_contact_time",  "intersects"};

std::string question_of(const Overload& o) {
  if (o.function == "contains") return "contains";
  return o.function.find("hit") != std::string::npos ? "first_hit" : "first_contact";
}
bool moves(const std::string& type) { return type.starts_with("Translating<") || type.starts_with("Moving<"); }
/// Figures at rest are relate's, and what takes anything answers nothing.
bool is_asked(const Overload& o) {
  if (o.first == "figure::Anything") return false;
  return o.function != "intersects" || moves(o.first) || moves(o.second);
}

struct Kind {
  FigureKind kind;
  int dimension;
};
/// By the names of the types, as query/body/pairs.hpp says them.
const std::map<std::string, Kind>& kinds() {
  static const std::map<std::string, Kind> all = [] {
    std::ifstream in(PLUMB_SOURCE_DIR "/include/plumb/query/body/pairs.hpp");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::map<std::string, std::size_t> numbers;
    const std::size_t from = text.find("enum class FigureKind");
    const std::string listed = text.substr(from, text.find("};", from) - from);
    const std::regex name(R"(\n  (\w+))"), kind(R"(PLUMB_KIND\((\w+), (\w+), (\d)\))");
    for (std::sregex_iterator i(listed.begin(), listed.end(), name), end; i != end; ++i)
      numbers.emplace((*i)[1], numbers.size());
    std::map<std::string, Kind> found;
    for (std::sregex_iterator i(text.begin(), text.end(), kind), end; i != end; ++i)
      found[(*i)[1]] = {static_cast<FigureKind>(numbers.at((*i)[2])), std::stoi((*i)[3])};
    return found;
  }();
  return all;
}

/// The figures that an argument may be, none if it is no figure of the tables.
std::vector<Kind> figures_of(std::string type) {
  if (type == "AnyRay" || type == "AnyRay2") {
    const int dimension = type == "AnyRay" ? 3 : 2;
    return {{FigureKind::line, dimension}, {FigureKind::ray, dimension}, {FigureKind::segment, dimension}};
  }
  if (moves(type)) type = type.substr(type.find('<') + 1, type.size() - type.find('<') - 2);
  const auto found = kinds().find(type);
  return found == kinds().end() ? std::vector<Kind>{} : std::vector<Kind>{found->second};
}

const query::QuestionTable& table_of(const Overload& o) {
  if (o.function == "contains") return query::contains_pairs;
  if (question_of(o) == "first_hit") return query::hit_pairs;
  return o.first.starts_with("Moving<") ? query::moving_pairs : query::translating_pairs;
}

bool is_further(const Overload& o) {
  return std::ranges::any_of(query::further_pairs, [&](const query::FurtherPair& p) {
    return p.question == question_of(o) && p.first == o.first && p.second == o.second && p.header == o.header;
  });
}
bool in_table(const Overload& o) {
  const std::vector<Kind> first = figures_of(o.first), second = figures_of(o.second);
  bool all = !first.empty() && !second.empty();
  for (const Kind& a : first) {
    for (const Kind& b : second) {
      all = all && a.dimension == b.dimension && table_of(o).answers(a.kind, b.kind, a.dimension);
    }
  }
  return all;
}
std::vector<Overload> without_place(const std::vector<Overload>& all) {
  std::vector<Overload> lost;
  for (const Overload& o : all) {
    if (is_asked(o) && !in_table(o) && !is_further(o)) lost.push_back(o);
  }
  return lost;
}
std::string spoken(const Overload& o) { return o.header + ": " + o.function + "(" + o.first + ", " + o.second + ")"; }

const std::vector<Overload>& all_overloads() {
  static const std::vector<Overload> all = overloads_of(PLUMB_SOURCE_DIR, asked);
  return all;
}

TEST(QuestionPlaces, EveryPublicFunctionHasOne) {
  EXPECT_GT(all_overloads().size(), 100U);
  for (const Overload& o : without_place(all_overloads()))
    ADD_FAILURE() << spoken(o) << " has no place: of two figures it is a letter of the table of " << question_of(o)
                  << ", of anything else the row {\"" << question_of(o) << "\", \"" << o.first << "\", \"" << o.second
                  << "\", \"" << o.header << "\"} of include/plumb/query/body/further_pairs.hpp";
}

TEST(QuestionPlaces, NoRowIsOfWhatIsNotDeclared) {
  for (const query::FurtherPair& p : query::further_pairs) {
    const bool declared = std::ranges::any_of(all_overloads(), [&](const Overload& o) {
      return is_asked(o) && question_of(o) == p.question && o.first == p.first && o.second == p.second &&
             o.header == p.header;
    });
    EXPECT_TRUE(declared) << p.header << " declares no " << p.question << " of " << p.first << " and " << p.second;
  }
}

// What first_hit takes, hits takes, of an index any_hit: with the same arguments, or by a template that takes them.
TEST(QuestionPlaces, HitsTakesWhatFirstHitTakes) {
  std::set<std::pair<std::string, std::string>> first_hits, yes_or_no;
  for (const Overload& o : all_overloads()) {
    if (o.function == "first_hit" && is_asked(o)) first_hits.insert({o.first, o.second});
    if (o.function == "hits" || o.function == "any_hit") yes_or_no.insert({o.first, o.second});
  }
  EXPECT_GT(first_hits.size(), 15U);
  for (const auto& [ray, shape] : first_hits) {
    if (ray == "Ray" || ray == "Index") continue;  // templates
    EXPECT_TRUE(yes_or_no.contains({ray, shape})) << "hits(" << ray << ", " << shape << ")";
  }
}

// What first_contact takes, first_contact_time and intersects take: the same two, declared in the same header.  A mesh
// that moves is asked which of its triangles meet (space/moving/).
TEST(QuestionPlaces, WhatTakesFirstContactTakesItsTimeAndIntersects) {
  std::map<std::string, std::set<std::string>> pairs;  // by function
  for (const Overload& o : all_overloads()) {
    if (question_of(o) == "first_contact" && !o.header.starts_with("space/moving/"))
      pairs[o.function].insert(o.header + ": " + o.first + ", " + o.second);
  }
  EXPECT_GT(pairs["first_contact"].size(), 10U);
  for (const std::string& pair : pairs["first_contact"]) {
    EXPECT_TRUE(pairs["first_contact_time"].contains(pair)) << pair;
    EXPECT_TRUE(pairs["intersects"].contains(pair)) << pair;
  }
}

std::string text_of_header(const std::string& header) {
  std::ifstream in(PLUMB_SOURCE_DIR "/include/plumb/" + header);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What is asked of two figures: each question says there what it takes.
std::set<std::string> questions_in(const std::string& text) {
  static const std::regex question(R"(\n(\w+)\(PLUMB_ANYTHING\))");
  std::set<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), question), end; i != end; ++i) names.insert((*i)[1]);
  return names;
}
/// Those that need no overload for an AnyFigure, and why.
const std::map<std::string, std::string>& without_overload() {
  static const std::map<std::string, std::string> why{
      {"closest_parameter", "asked of what is known to be a line"},
      {"closest_point", "told by closest_points"},
      {"compare_distance", "a template over distance and exact_distance"},
      {"first_contact_span", "bounds of the time that first_contact tells"},
      {"gjk_bounds", "a template over support_point"},
      {"maximize", "asked of a direction and halfspaces"}};
  return why;
}

/// Which of these no AnyFigure can be asked: neither query/variant/questions.hpp declares them, nor do they take whatever
/// is a ConvexBody3, as it is.
std::set<std::string> without_any_figure(const std::set<std::string>& questions) {
  const std::string header = "query/variant/questions.hpp", declared = text_of_header(header);
  std::string all;
  for (const auto& file : std::filesystem::recursive_directory_iterator(PLUMB_SOURCE_DIR "/include/plumb/query")) {
    if (file.is_regular_file())
      all += text_of_header(std::filesystem::relative(file, PLUMB_SOURCE_DIR "/include/plumb").string());
  }
  std::set<std::string> lost;
  for (const std::string& q : questions) {
    const std::regex of_bodies(R"(template <ConvexBody3 A, ConvexBody3 B>[^;{}]*[ >])" + q + R"(\()");
    if (without_overload().contains(q) || !overloads_in(declared, header, {q}).empty()) continue;
    if (!std::regex_search(all, of_bodies)) lost.insert(q);
  }
  return lost;
}

TEST(QuestionPlaces, EveryQuestionTakesAnyFigure) {
  std::set<std::string> questions = questions_in(text_of_header("query/body/answered.hpp"));
  questions.insert({"relate", "intersects", "contains", "locate", "fit_aabb", "support_point"});
  EXPECT_GT(questions.size(), 25U);
  for (const std::string& q : without_any_figure(questions))
    ADD_FAILURE() << q << " takes no AnyFigure: declare it in include/plumb/query/variant/questions.hpp, dispatched in "
                  << "src/query/variant/, or let it take any ConvexBody3";
  EXPECT_EQ(without_any_figure({"relate", "new_question"}), std::set<std::string>{"new_question"});
}

TEST(QuestionPlaces, ANewFunctionIsNoticed) {
  const auto lost = [](const std::string& declared) {
    return without_place(overloads_in("namespace plumb {\n" + declared + "\n}", "query/new.hpp", asked));
  };
  EXPECT_EQ(lost("bool contains(const Cone3& outer, const Segment3& inner);").size(), 1U);
  EXPECT_EQ(lost("std::optional<Hit> first_hit(const AnyRay& ray, const SphericalCap3& cap, double most = f(1, 2));"),
            (std::vector<Overload>{{"first_hit", "AnyRay", "SphericalCap3", "query/new.hpp"}}));
  EXPECT_EQ(lost("bool hits(const AnyRay2& ray, const Sphere3& ball);").size(), 1U);  // of two spaces
  EXPECT_EQ(lost("inline bool any_hit(const AnyRay& ray, const Terrain& t) { return hits(ray, t); }").size(), 1U);
  EXPECT_EQ(lost("template <class A>\nrequires Fine<A> std::optional<Contact>\nfirst_contact(const A& a, "
                 "const Translating<Cone3>& b);")
                .size(),
            1U);
  EXPECT_EQ(lost("bool intersects(const Translating<Line3>& a, const Translating<Ray3>& b);").size(), 1U);
  EXPECT_EQ(lost("bool intersects(const Moving<Ray3>& a, const Moving<Ray3>& b);").size(), 1U);
  // What has a place, what is no function of plumb's, and what only calls one.
  EXPECT_EQ(lost("bool contains(const Sphere3& outer, const Aabb3& inner);"), std::vector<Overload>{});
  EXPECT_EQ(lost("bool intersects(const Cone3& a, const Cone3& b);"), std::vector<Overload>{});
  EXPECT_EQ(lost("struct Grid { bool contains(const Cone3& a, const Cone3& b) const; };"), std::vector<Overload>{});
  EXPECT_EQ(lost("namespace query { bool contains(const Cone3& a, const Cone3& b); }"), std::vector<Overload>{});
  EXPECT_EQ(lost("// bool contains(const Cone3& a, const Cone3& b);\nbool f() { return contains(cone, other); }"),
            std::vector<Overload>{});
}

}  // namespace
}  // namespace plumb::house
