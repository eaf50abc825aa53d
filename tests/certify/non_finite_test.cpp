// Law 8 of the contract: what stands for no real number is refused by name, whatever the other coordinates are.
#include <gtest/gtest.h>

#include <limits>

#include "certify/battery.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/predicates.hpp"

namespace plumb::battery {
namespace {

std::string thrown(const CatalogEntry& e, std::span<const double> p) {
  try {
    e.decide(p);
  } catch (const NonFinite& error) {
    return error.what();
  }
  return "nothing";
}

// "b.y"; "b" where the argument has one coordinate; counted where it has more of them than letters.
std::string place_of(const CatalogEntry& e, std::size_t coordinate) {
  std::vector<std::string> places;
  for (const int& count : e.arguments) {
    const std::string letter(1, static_cast<char>('a' + (&count - e.arguments.data())));
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      places.push_back(count == 1                                        ? letter
                       : static_cast<std::size_t>(count) > e.axes.size() ? "coordinate " + std::to_string(places.size())
                                                                         : letter + '.' + e.axes[k]);
    }
  }
  return places.at(coordinate);
}

struct Bad {
  double value;
  std::string name;
};

const std::vector<Bad> all_bad{{std::numeric_limits<double>::quiet_NaN(), "nan"},
                               {-std::numeric_limits<double>::quiet_NaN(), "nan"},
                               {std::numeric_limits<double>::signaling_NaN(), "nan"},
                               {std::numeric_limits<double>::infinity(), "inf"},
                               {-std::numeric_limits<double>::infinity(), "-inf"}};

TEST(NonFiniteTest, IsRefusedByNameAtEveryPlaceAndBesideAnything) {
  for (const CatalogEntry& e : catalog()) {
    // All equal points make every formula zero by structure, zeros and extremes by value; the rest are ordinary.
    std::vector<std::vector<double>> surroundings{std::vector<double>(e.arity(), 0.0),
                                                  std::vector<double>(e.arity(), 1.5),
                                                  std::vector<double>(e.arity(), std::numeric_limits<double>::max())};
    for (const FamilyInfo& f : families) {
      for (std::uint64_t i = 0; i < fitting(20u); ++i) surroundings.push_back(coordinates_of(e, f.family, i));
    }
    for (std::vector<double> p : surroundings) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double kept = p[i];
        for (const Bad& bad : all_bad) {
          p[i] = bad.value;
          std::string text(e.name);
          text.append(": ")
              .append(place_of(e, i))
              .append(" is ")
              .append(bad.name)
              .append(", not a real number; give a finite double");
          ASSERT_EQ(thrown(e, p), text);
        }
        p[i] = kept;
      }
    }
  }
}

TEST(NonFiniteTest, TheFirstOfSeveralIsNamed) {
  const CatalogEntry& e = *find_predicate("orient2d");
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(thrown(e, std::array{0.0, 1.0, 2.0, -inf, nan, 4.0}),
            "orient2d: b.y is -inf, not a real number; give a finite double");
  EXPECT_EQ(thrown(e, std::array{inf, inf, inf, inf, inf, inf}),
            "orient2d: a.x is inf, not a real number; give a finite double");
}

TEST(NonFiniteTest, ReachesUsersOfTheFace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(orient2d({0, 0}, {1, 0}, {0, nan}), NonFinite);
  EXPECT_THROW(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, nan}), NonFinite);
  EXPECT_THROW(incircle({nan, 0}, {1, 0}, {0, 1}, {0, 0}), NonFinite);
  EXPECT_THROW(insphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {nan, 0, 0}), Error);
}

}  // namespace
}  // namespace plumb::battery
