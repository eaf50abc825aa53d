// The derived constants of every predicate, one line each, against tests/certify/golden.txt.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "certify/battery.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb::battery {
namespace {

std::string golden_line(const CatalogEntry& e) {
  std::ostringstream line;
  line << e.name << ' ' << e.degree << ' ' << e.program.instructions.size() << ' ' << hexadecimal(e.filter_constant);
  if (e.homogeneous) {
    line << ' ' << e.value_bits(certify::integer::short_bits) << ' ' << e.value_bits(certify::integer::long_bits);
  } else {
    line << " - -";
  }
  line << ' ' << (e.filter_is_magnitude ? "magnitude" : "largest");
  return line.str();
}

TEST(GoldenTest, DerivedConstantsAreAsRecorded) {
  std::vector<std::string> expected;
  for (const CatalogEntry& e : catalog()) expected.push_back(golden_line(e));
  std::ifstream file(PLUMB_SOURCE_DIR "/tests/certify/golden.txt");
  std::vector<std::string> recorded;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#') recorded.push_back(line);
  }
  std::string should;
  for (const std::string& line : expected) should += line + '\n';
  EXPECT_EQ(recorded, expected) << "golden.txt should hold\n" << should;
}

TEST(GoldenTest, TheCatalogTellsTheSameConstants) {
#define PLUMB_COMPARE(formula)                                                                                   \
  EXPECT_EQ(find_predicate(predicates::formula::name)->filter_constant, filter_constant<predicates::formula>()); \
  EXPECT_EQ(find_predicate(predicates::formula::name)->value_bits(61), value_bits<predicates::formula>(61));     \
  EXPECT_EQ(find_predicate(predicates::formula::name)->degree, degree<predicates::formula>());
  PLUMB_CLASSICS(PLUMB_COMPARE)
#undef PLUMB_COMPARE
}

}  // namespace
}  // namespace plumb::battery
