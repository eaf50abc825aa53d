// Do the Bernstein signs stand up to continuous-collision queries whose true answers are known?
//
// Generated ones, and those of ../shared/ccd (its README.md says what a row is): eight rows each, four points at time 0
// and at time 1.  Where that folder is missing a line says so.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "certify/space_cases.hpp"
#include "plumb/certify/moving_points.hpp"
#include "query/time_of_impact/generated_queries.hpp"

namespace plumb::space_cases {
namespace {

namespace fs = std::filesystem;

struct Query {
  std::vector<Point3> points;  // at time 0, then at time 1
  bool touch = false;
};

// Exactly: numerators and denominators of any length whose quotient is a double.
double quotient(const std::string& numerator, const std::string& denominator) {
  mpq_class q(numerator + "/" + denominator);
  q.canonicalize();
  const double x = q.get_d();
  if (mpq_class(x) != q) throw std::runtime_error(numerator + "/" + denominator + " is no double");
  return x;
}

std::vector<Query> read_queries(const fs::path& file) {
  std::ifstream in(file);
  std::vector<Query> queries;
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    std::array<std::string, 7> word;
    for (std::string& w : word) std::getline(row, w, ',');
    if (queries.empty() || queries.back().points.size() == 8) queries.emplace_back();
    Query& q = queries.back();
    q.points.push_back({quotient(word[0], word[1]), quotient(word[2], word[3]), quotient(word[4], word[5])});
    q.touch = std::stoi(word[6]) != 0;
  }
  return queries;
}

struct Tally {
  std::size_t queries = 0, touch = 0, ruled_out = 0;
  Shares signs;
};

void check(const Query& q, Tally& tally) {
  ASSERT_EQ(q.points.size(), 8u);
  const std::span<const Point3> all(q.points);
  const auto signs = coplanarity_signs(all.first<4>(), all.subspan<4, 4>());
  const auto& p = q.points;
  using predicates::CoplanarityMiddle;
  const auto forth = gathered<CoplanarityMiddle>(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
  ASSERT_EQ(signs[1], in_rationals<CoplanarityMiddle>(forth)) << shown(p);
  const bool ruled_out = signs[0] != Sign::zero && std::ranges::all_of(signs, [&](Sign s) { return s == signs[0]; });
  ASSERT_FALSE(ruled_out && q.touch) << "never in one plane, and yet they touch:" << shown(p);
  ++tally.queries;
  tally.touch += q.touch ? 1 : 0;
  tally.ruled_out += ruled_out ? 1 : 0;
  for (const Sign s : signs) tally.signs(s);
}

void expect_no_contact_ruled_out(const fs::path& folder) {
  Tally tally;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    for (const Query& q : read_queries(entry.path())) {
      ASSERT_NO_FATAL_FAILURE(check(q, tally)) << entry.path();
    }
  }
  std::cout << tally.queries << " queries, " << tally.touch << " touch, " << tally.ruled_out
            << " ruled out; signs: zero " << tally.signs.of(Sign::zero) << ", negative "
            << tally.signs.of(Sign::negative) << '\n';
  EXPECT_GT(tally.touch, tally.queries / 50);
  EXPECT_GT(tally.ruled_out, (tally.queries - tally.touch) / 10);
  EXPECT_GT(tally.signs.least(), 0.01);
}

TEST(MovingQueriesTest, NoGeneratedContactIsRuledOut) {
  const lab::moving_cases::GeneratedQueries generated;
  expect_no_contact_ruled_out(generated.path());
}

TEST(MovingQueriesTest, NoContactIsRuledOut) {
  const fs::path folder = fs::path(PLUMB_SHARED_DIR) / "ccd";
  if (!fs::is_directory(folder)) {
    std::cout << "skipped: there is no " << folder << '\n';
    return;
  }
  expect_no_contact_ruled_out(folder);
}

}  // namespace
}  // namespace plumb::space_cases
