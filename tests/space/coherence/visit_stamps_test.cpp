// Is each thing visited once a query, also when the stamps come round?
#include "plumb/space/coherence/visit_stamps.hpp"

#include <gtest/gtest.h>

#include <set>

#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

TEST(VisitStamps, TellTheFirstVisitOfEachQuery) {
  VisitStamps stamps(3);
  EXPECT_EQ(stamps.size(), 3u);
  EXPECT_FALSE(stamps.visited(1));
  EXPECT_TRUE(stamps.visit(1));
  EXPECT_FALSE(stamps.visit(1));
  EXPECT_TRUE(stamps.visited(1));
  EXPECT_FALSE(stamps.visited(0));
  stamps.begin();
  EXPECT_FALSE(stamps.visited(1));
  EXPECT_TRUE(stamps.visit(1));
}

/// What was visited 254, 255, 256 and 257 queries ago has not been now, whichever stamp is whose.
TEST(VisitStamps, ComeRoundWithoutAnOldVisit) {
  for (int before = 0; before < 300; ++before) {
    VisitStamps stamps(1);
    for (int i = 0; i < before; ++i) stamps.begin();
    ASSERT_TRUE(stamps.visit(0));
    for (int later = 1; later < 600; ++later) {
      stamps.begin();
      ASSERT_FALSE(stamps.visited(0)) << before << " " << later;
    }
  }
}

TEST(VisitStamps, AreASetThatIsEmptiedByEachQuery) {
  Entropy entropy(1771, 0);
  VisitStamps stamps(7);
  for (int query = 0; query < 3000; ++query) {
    std::set<std::size_t> visited;
    for (auto n = entropy.below(6); n-- > 0;) {
      const auto i = static_cast<std::size_t>(entropy.below(7));
      ASSERT_EQ(stamps.visited(i), visited.contains(i)) << query;
      ASSERT_EQ(stamps.visit(i), visited.insert(i).second) << query;
    }
    if (entropy.below(900) == 0) {
      stamps.reset(7);
      for (std::size_t i = 0; i < 7; ++i) ASSERT_FALSE(stamps.visited(i));
    } else {
      stamps.begin();
    }
  }
}

TEST(VisitStamps, OfNothing) {
  VisitStamps stamps;
  for (int i = 0; i < 1000; ++i) stamps.begin();
  EXPECT_EQ(stamps.size(), 0u);
}

}  // namespace
}  // namespace plumb
