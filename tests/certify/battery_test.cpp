// Does the battery notice a stage that lies, and does it say so in a line that replays?
#include "certify/battery.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace plumb::battery {
namespace {

const CatalogEntry& honest() { return *find_predicate("orient3d"); }

// What the battery first objects to in a predicate that is honest but for one thing.
std::string objection(const CatalogEntry& e) {
  for (const FamilyInfo& f : families) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const std::vector<double> p = coordinates_of(e, f.family, i);
      if (!disagreement(e, p).empty()) return report(e, p);
    }
  }
  return "";
}

void expect_objection(const CatalogEntry& e, std::string_view complaint) {
  std::istringstream text(objection(e));
  std::string said, line;
  std::getline(text, said);
  std::getline(text, line);
  EXPECT_NE(said.find(complaint), said.npos) << said;
  const auto c = parse_case_line(line);
  ASSERT_TRUE(c.has_value()) << text.str();
  EXPECT_EQ(c->expected, Unsure{honest().decide(c->coordinates).sign});
  EXPECT_NE(disagreement(e, c->coordinates), "");
}

TEST(BatteryTest, HasNothingAgainstAnHonestPredicate) { EXPECT_EQ(objection(honest()), ""); }

TEST(BatteryTest, NoticesAChainThatLies) {
  CatalogEntry e = honest();
  e.decide = [](std::span<const double> p) {
    const Decision d = honest().decide(p);
    return Decision{d.stage == Stage::wide_integer && d.sign == Sign::zero ? Sign::positive : d.sign, d.stage};
  };
  expect_objection(e, "decide says +, rationals say 0");
}

TEST(BatteryTest, NoticesAStageThatLies) {
  CatalogEntry e = honest();
  e.ask = [](Stage s, std::span<const double> p) {
    return s == Stage::big_integer ? Unsure{Sign::negative} : honest().ask(s, p);
  };
  expect_objection(e, "big-integer says -, rationals say ");
}

TEST(BatteryTest, NoticesAStageThatIsPassedOver) {
  CatalogEntry e = honest();
  e.ask = [](Stage s, std::span<const double> p) {
    return s == Stage::structural_zero ? Unsure{oracle::rational_sign("orient3d", p)} : honest().ask(s, p);
  };
  expect_objection(e, "structural-zero was certain, but wide-integer decided");
}

TEST(BatteryTest, NoticesAnotherFilterThatLies) {
  CatalogEntry e = honest();
  e.ask_other_filter = [](std::span<const double>) { return Unsure{Sign::zero}; };
  expect_objection(e, "the other filter says 0");
}

TEST(BatteryTest, CasesAreTheSameEachTimeAndDiffer) {
  for (const FamilyInfo& f : families) {
    EXPECT_EQ(coordinates_of(honest(), f.family, 5), coordinates_of(honest(), f.family, 5));
    EXPECT_NE(coordinates_of(honest(), f.family, 5), coordinates_of(honest(), f.family, 6)) << f.name;
  }
}

}  // namespace
}  // namespace plumb::battery
