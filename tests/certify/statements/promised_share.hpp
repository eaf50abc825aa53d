// How many decisions of a family does the first world tell?  Shares, held against what is promised.
//
// The promises stand in tests/certify/statements/promised_shares.txt: a line a statement, percents by family.
// Laws: no less is told than is promised, nor 10 of 100 more, so that what is promised is what is so; a family of which
// something is promised is asked a hundred times.  The sanitized build, which asks less, asks for no shares.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "certify/sanitized.hpp"
#include "plumb/certify/certainly.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb {

/// Counts, which are held against what is promised when they go.
class PromisedShare {
 public:
  explicit PromisedShare(std::string_view name) : name_(name) {}
  PromisedShare(const PromisedShare&) = delete;
  PromisedShare& operator=(const PromisedShare&) = delete;
  ~PromisedShare() {
    if (!battery::sanitized) hold();
  }

  void add(Family family, bool told) { add(family, told ? 1 : 0, 1); }
  void add(Family family, int told, int asked) {
    Count& count = of_[static_cast<std::size_t>(family)];
    count.told += told, count.asked += asked;
  }

 private:
  struct Count {
    int told = 0, asked = 0;
  };

  /// The line of this name, without it; '-' stands for a family that is not asked.
  [[nodiscard]] std::string promised() const {
    std::ifstream file(PLUMB_SOURCE_DIR "/tests/certify/statements/promised_shares.txt");
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with(name_ + ' ')) return line.substr(name_.size());
    }
    return {};
  }
  void hold() const {
    std::istringstream promises(promised());
    std::string should = name_;
    for (const FamilyInfo& info : families) {
      const Count count = of_[static_cast<std::size_t>(info.family)];
      std::string promise;
      promises >> promise;
      if (count.asked == 0) {
        EXPECT_EQ(promise, "-") << name_ << " is not asked of " << info.name;
        should += " -";
        continue;
      }
      const int told = 100 * count.told / count.asked;
      should += ' ' + std::to_string(told == 100 ? 99 : told > 2 ? told - 2 : 0);
      EXPECT_GE(count.asked, 100) << name_ << ", " << info.name;
      const bool is_number = !promise.empty() && promise.find_first_not_of("0123456789") == std::string::npos;
      EXPECT_TRUE(is_number) << name_ << " promises nothing of " << info.name;
      if (!is_number) continue;
      EXPECT_GE(told, std::stoi(promise)) << name_ << ", " << info.name;
      EXPECT_LT(told, std::stoi(promise) + 10) << name_ << ", " << info.name << ": more might be promised";
    }
    if (testing::Test::HasFailure()) ADD_FAILURE() << "promised_shares.txt might hold\n" << should;
  }

  std::string name_;
  std::array<Count, families.size()> of_{};
};

/// Asks doubles, integers on the stack and rational numbers: draw(ask, x) calls ask with what it makes of so many
/// coordinates, which points of this dimension have; what either are certain of is so.  Of the integers the share is
/// promised to the name that ends with _integers.
template <std::size_t coordinates, class Statement, class Draw>
void expect_share(const char* name, const Statement& statement, const Draw& draw, int dimension = 3) {
  PromisedShare share(name), by_integers(std::string(name).append("_integers"));
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(200); ++i) {
      Entropy entropy(91, i);
      std::array<double, coordinates> x{};
      fill_points(info.family, Degeneracy::coplanar, dimension, x, entropy);
      const auto ask = [&](const auto&... input) {
        RationalWorld exact;
        const auto of_rationals = statement(exact, input...);
        const auto hold = [&](auto world, PromisedShare& of) {
          const auto told = statement(world, input...);
          of.add(info.family, world.certain());
          if (!world.certain()) return;
          EXPECT_EQ(told, of_rationals) << name << ", " << info.name << ", Entropy(91, " << i << ")";
        };
        hold(FloatWorld<Statement>(), share);
        hold(IntegerWorld(), by_integers);
      };
      draw(ask, x);
    }
  }
}

}  // namespace plumb
