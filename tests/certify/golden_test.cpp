// The derived constants of every predicate, one line each, against tests/certify/golden.txt.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "certify/battery.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb::battery {
namespace {

template <Formula F>
std::string golden_line() {
  std::ostringstream line;
  line << F::name << ' ' << degree<F>() << ' ' << program<F>().instructions.size() << ' '
       << hexadecimal(filter_constant<F>()) << ' ' << value_bits<F>(integer::short_bits) << ' '
       << value_bits<F>(integer::long_bits) << ' ' << (filter_is_magnitude<F> ? "magnitude" : "largest");
  return line.str();
}

TEST(GoldenTest, DerivedConstantsAreAsRecorded) {
  std::vector<std::string> expected;
#define PLUMB_LINE(formula) expected.push_back(golden_line<predicates::formula>());
  PLUMB_PREDICATES(PLUMB_LINE)
#undef PLUMB_LINE
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
  EXPECT_EQ(find_predicate(predicates::formula::name)->value_bits(61), value_bits<predicates::formula>(61));
  PLUMB_PREDICATES(PLUMB_COMPARE)
#undef PLUMB_COMPARE
}

}  // namespace
}  // namespace plumb::battery
