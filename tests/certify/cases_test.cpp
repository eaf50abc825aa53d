// The signs in tests/cases/ come from determinants of fractions outside of this project's code.
#include <gtest/gtest.h>

#include <map>

#include "certify/battery.hpp"
#include "certify/case_files.hpp"

namespace plumb::battery {
namespace {

TEST(CasesTest, EveryLineHoldsAtEveryStage) {
  std::map<std::string, int> seen;
  for_each_case_line([&](const std::string& place, const std::string& line) {
    SCOPED_TRACE(testing::Message() << place << ": " << line);
    const auto c = parse_case_line(line);
    if (!c) return;
    ASSERT_TRUE(c->expected.certain()) << "the line states no sign";
    const CatalogEntry& e = *find_predicate(c->predicate);
    EXPECT_EQ(e.decide(c->coordinates).sign, c->expected.value());
    EXPECT_EQ(oracle::rational_sign(e.name, c->coordinates), c->expected.value());
    EXPECT_EQ(disagreement(e, c->coordinates), "");
    ++seen[c->predicate + to_char(c->expected.value())];
  });
  for (const char* predicate : {"orient2d", "orient3d", "incircle", "insphere"}) {
    for (const char* sign : {"+", "0", "-"}) EXPECT_GE(seen[std::string(predicate) + sign], 1) << predicate << sign;
  }
}

}  // namespace
}  // namespace plumb::battery
