// Are all queries of a public benchmark answered as they were proved to be?  No contact missed, none invented.
//
// Queries of ../shared/ccd, all of them (some 3300, below a second), and generated ones in files like them.  Where that
// folder is missing a line says so.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "lab/stability/ccd_queries.hpp"
#include "query/time_of_impact/generated_queries.hpp"

namespace plumb::lab::ccd {
namespace {

enum class Source { generated, shared };

class CcdModels : public testing::TestWithParam<Source> {
 protected:
  static const std::vector<Query>& queries() {
    if (GetParam() == Source::generated) {
      static const std::vector<Query> all = all_queries(lab::moving_cases::GeneratedQueries().path());
      EXPECT_EQ(all.size(), lab::moving_cases::GeneratedQueries::queries);
      return all;
    }
    static const std::vector<Query> all = all_queries(PLUMB_SHARED_DIR "/ccd");
    if (all.empty()) {
      std::cout << "skipped: there are no queries in ../shared/ccd\n";
    } else {
      EXPECT_GT(all.size(), 3000U);
    }
    return all;
  }
};
INSTANTIATE_TEST_SUITE_P(Queries, CcdModels, testing::Values(Source::generated, Source::shared),
                         [](const auto& source) { return source.param == Source::shared ? "Shared" : "Generated"; });

std::string shown(const Query& q) {
  std::string text = q.scene + (q.vertex_face ? " vertex-face" : " edge-edge");
  for (const auto& points : {q.at_0, q.at_1}) {
    for (const Point3& p : points) {
      std::array<char, 96> line{};
      std::snprintf(line.data(), line.size(), "\n  %a %a %a", p.x, p.y, p.z);
      text += line.data();
    }
  }
  return text;
}

Query reversed(Query q) {
  std::swap(q.at_0, q.at_1);
  return q;
}
/// The same figures with their vertices in another order, and edges with one another.
Query permuted(Query q) {
  for (auto* points : {&q.at_0, &q.at_1}) {
    auto& p = *points;
    if (q.vertex_face) {
      std::rotate(p.begin() + 1, p.begin() + 2, p.end());
    } else {
      std::rotate(p.begin(), p.begin() + 2, p.end());
      std::swap(p[0], p[1]);
    }
  }
  return q;
}

TEST_P(CcdModels, EveryAnswerIsTrue) {
  struct Tally {
    int queries = 0, meet = 0, false_positives = 0, false_negatives = 0;
  };
  std::map<std::string, Tally> tallies;
  for (const Query& q : queries()) {
    Tally& tally = tallies[q.scene + (q.vertex_face ? " vertex-face" : " edge-edge")];
    ++tally.queries;
    tally.meet += q.meets ? 1 : 0;
    const bool answer = intersects(q);
    tally.false_positives += answer && !q.meets ? 1 : 0;
    tally.false_negatives += !answer && q.meets ? 1 : 0;
    EXPECT_EQ(answer, q.meets) << shown(q);
  }
  int all = 0, meet = 0;
  for (const auto& [scene, tally] : tallies) {
    std::cout << scene << ": " << tally.queries << " queries, " << tally.meet << " meet, " << tally.false_positives
              << " false positives, " << tally.false_negatives << " false negatives\n";
    all += tally.queries;
    meet += tally.meet;
  }
  if (all > 0) {
    EXPECT_GT(meet, all / 20);
  }
}

TEST_P(CcdModels, OrdersOfVerticesAndOfTimeDoNotMatter) {
  for (const Query& q : queries()) {
    EXPECT_EQ(intersects(reversed(q)), q.meets) << shown(q);
    EXPECT_EQ(intersects(permuted(q)), q.meets) << shown(q);
  }
}

TEST_P(CcdModels, FirstContactsAreWhereTheAnswerIsYes) {
  int at_start = 0, later = 0;
  for (const Query& q : queries()) {
    const std::optional<Contact> contact = first_contact(q), other = first_contact(permuted(q));
    ASSERT_EQ(contact.has_value(), q.meets) << shown(q);
    ASSERT_EQ(other.has_value(), q.meets) << shown(q);
    if (!contact) continue;
    EXPECT_EQ(contact->time, other->time) << shown(q);
    EXPECT_TRUE(contact->time >= 0 && contact->time <= 1) << shown(q);
    (contact->time == 0 ? at_start : later) += 1;
  }
  std::cout << at_start << " contacts at time 0, " << later << " later\n";
  if (at_start + later > 0) {
    EXPECT_GT(later, GetParam() == Source::shared ? at_start : 50);
  }
}

}  // namespace
}  // namespace plumb::lab::ccd
