// Are the searches bounded whatever the exponents are, and do they grow with the points as their headers say?
// Instructions are counted, since times differ from run to run: for nine points of ordinary exponents, for nine whose
// exponents span all that doubles have, and for more of both.
//
// The processor's counter is asked where there is one, else callgrind runs this program again.  Each row of the tables
// (cost_rows_of_figures.hpp, cost_rows_of_indexes.hpp) says what its question may take, and which header says so.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "space/cost_rows_of_figures.hpp"
#include "space/cost_rows_of_indexes.hpp"
#include "space/instruction_counter.hpp"

namespace plumb::cost {
namespace {

std::vector<CostRow> all_rows() {
  std::vector<CostRow> rows(std::begin(rows_of_figures), std::end(rows_of_figures));
  rows.insert(rows.end(), std::begin(rows_of_indexes), std::end(rows_of_indexes));
  return rows;
}

struct Measured {
  Exponents exponents;
  std::size_t points;
  std::uint64_t clouds;
};
std::array<Measured, 5> measured(const CostRow& row) {
  return {{{Exponents::ordinary, 9, row.asked()},
           {Exponents::of_points, 9, row.asked()},
           {Exponents::of_coordinates, 9, row.asked()},
           {Exponents::ordinary, row.many, row.asked()},
           {Exponents::of_coordinates, row.more, 1}}};
}

/// Made once for all rows: their hulls take longer than most of what is asked of them.
const Cloud& kept_cloud(Exponents exponents, std::size_t size, std::uint64_t index) {
  static std::map<std::tuple<Exponents, std::size_t, std::uint64_t>, Cloud> kept;
  const auto [at, is_new] = kept.try_emplace({exponents, size, index});
  if (is_new) at->second = cloud(exponents, size, index);
  return at->second;
}

/// Asks every question of every cloud, between calls of `before` and `after`.
template <class Before, class After>
void ask_all(const Before& before, const After& after) {
  const ThreadLimit alone(1);
  const char* const only = std::getenv("PLUMB_COST_OF");
  for (const CostRow& row : all_rows()) {
    const bool is_asked = only == nullptr || std::string_view(row.name).find(only) != std::string_view::npos;
    for (const auto& [exponents, points, clouds] : measured(row)) {
      std::vector<const Cloud*> asked;
      for (std::uint64_t i = 0; is_asked && i < clouds; ++i) asked.push_back(&kept_cloud(exponents, points, i));
      before();
      for (const Cloud* c : asked) {
        try {
          row.ask(*c);
        } catch (const Error&) {  // what doubles do not hold
        }
      }
      after();
    }
  }
}

std::vector<double> by_processor(const InstructionCounter& counter) {
  std::vector<double> counts;
  double start = 0;
  ask_all([&] { start = counter.now(); }, [&] { counts.push_back(counter.now() - start); });
  return counts;
}

void run_under_callgrind() {
#if PLUMB_HAS_CALLGRIND
  ask_all([] { CALLGRIND_ZERO_STATS; }, [] { CALLGRIND_DUMP_STATS_AT("counted"); });
#endif
}

TEST(Cost, IsBoundedWhateverTheExponentsAre) {
  if (is_counted_by_callgrind()) return run_under_callgrind();
  const InstructionCounter counter;
  const std::vector<double> counts =
      counter.counts() ? by_processor(counter) : counts_by_callgrind("Cost.IsBoundedWhateverTheExponentsAre");
  if (counts.empty())
    GTEST_SKIP() << "instructions cannot be counted here: the processor's counter is not to be had; install valgrind "
                    "(with its headers) and build again";
  const std::vector<CostRow> rows = all_rows();
  const std::size_t times = measured(rows.front()).size();
  ASSERT_EQ(counts.size(), times * rows.size());
  constexpr double million = 1e6;
  constexpr double slack = 2;  // of what grows: nine points are asked of which more than nine are no multiple
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto count = [&](std::size_t k) { return counts[times * i + k] / million; };
    const CostRow& row = rows[i];
    const double most = row.most_of(row.asked());
    const auto may_grow = [&](double n) { return slack * row.growth.of(n) / row.growth.of(9); };
    const double most_of_more = row.most_of(1) * may_grow(static_cast<double>(row.more)), grown = count(3) / count(0);
    std::cout << std::setw(36) << row.name << std::fixed << std::setprecision(2) << std::setw(9) << count(0)
              << std::setw(9) << count(1) << std::setw(9) << count(2) << "  of " << most << "; grows " << grown
              << " of " << may_grow(static_cast<double>(row.many)) << "; " << count(4) << " of " << most_of_more
              << "\n";
    EXPECT_GT(count(0), 0) << row.name;
    EXPECT_LE(std::max({count(0), count(1), count(2)}), most) << row.name;
    EXPECT_LE(count(4), most_of_more) << row.name << " of " << row.more << " points";
    if (row.growth.power == 0 && !row.growth.has_log) continue;
    EXPECT_LE(grown, may_grow(static_cast<double>(row.many))) << row.name;
  }
}

/// The paragraph behind "Cost:", without line ends.
std::string cost_line(const std::string& header) {
  std::ifstream in(PLUMB_SOURCE_DIR "/include/plumb/" + header);
  std::string all;
  for (std::string line; std::getline(in, line) && line.starts_with("//");) {
    if (line.starts_with("// Cost:"))
      all = line.substr(3);
    else if (!all.empty())
      all += line.substr(2);
  }
  return all;
}

TEST(Cost, IsSaidByTheHeaderOfEachQuestion) {
  for (const CostRow& row : all_rows()) {
    const std::string line = cost_line(row.header);
    const std::size_t bound = line.find("ounded by ");
    EXPECT_NE(bound, std::string::npos) << row.header << " says no bound of " << row.name << ": " << line;
    if (bound == std::string::npos) continue;
    EXPECT_NE(line.find(row.growth.says, bound), std::string::npos)
        << row.header << " does not say " << row.growth.says << "of " << row.name << ": " << line;
  }
}

/// A header that searches nothing says so, or that it costs nothing at all.
bool says_that_nothing_is_searched(const std::string& cost) {
  return cost.starts_with("Cost: none") || cost.starts_with("Cost: compile time only") ||
         cost.find("Nothing is searched") != std::string::npos;
}

TEST(Cost, IsAskedOfEachHeaderThatSearches) {
  std::set<std::string> asked;
  for (const CostRow& row : all_rows()) asked.insert(row.header);
  for (const std::string folder : {"figure", "query", "space", "surface", "world"}) {
    const std::filesystem::path include(PLUMB_SOURCE_DIR "/include/plumb");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(include / folder)) {
      if (entry.path().extension() != ".hpp" || entry.path().parent_path().filename() == "detail") continue;
      const std::string header = std::filesystem::relative(entry.path(), include).string();
      EXPECT_NE(asked.contains(header), says_that_nothing_is_searched(cost_line(header)))
          << header << ": a header that searches says what by ('Bounded by ...') and has a row in "
          << "tests/space/cost_rows_*.hpp; any other says: 'Nothing is searched.'";
    }
  }
}

}  // namespace
}  // namespace plumb::cost
