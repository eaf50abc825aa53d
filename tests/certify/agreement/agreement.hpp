// Does every stage of every predicate agree with the oracles on every family, and is the filter as sure as promised?
//
// One parametrized test a classic predicate and family; the families are dealt to programs (agreement_*_test),
// so that a machine with few cores can run them side by side.
#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <tuple>

#include "certify/battery.hpp"
#include "certify/tally.hpp"

namespace plumb::battery {

enum class Shard { plain, aligned, spread, far };

/// Which program tests a family; a new family does not compile until it is dealt to one.
constexpr Shard shard_of(Family family) {
  switch (family) {
    case Family::grid:
    case Family::uniform:
    case Family::float32:
    case Family::near_half:
    case Family::repeated:
      return Shard::plain;
    case Family::degenerate_short:
    case Family::degenerate_long:
    case Family::off_by_ulps:
      return Shard::aligned;
    case Family::wide:
    case Family::mixture:
      return Shard::spread;
    case Family::extreme:
      break;
  }
  return Shard::far;
}

/// What a family must be like for its cases to mean something, and which stages may be left to decide them.
struct Promise {
  double most_unsure;            // share of cases that the filter may leave undecided
  double least_zero, most_zero;  // share of exact zeros; the other two signs are balanced
  double most_allocating;        // share that may need the last stage
};

constexpr Promise promise_of(Family family) {
  switch (family) {
    case Family::grid:
      return {0.05, 0.01, 0.06, 0};
    case Family::uniform:
    case Family::float32:
      return {0.001, 0, 0.001, 0};
    case Family::near_half:
      return {0.85, 0.01, 0.10, 0};
    case Family::degenerate_short:
    case Family::degenerate_long:
      return {1, 1, 1, 0};
    case Family::off_by_ulps:
      return {1, 0.005, 0.20, 0.02};
    case Family::repeated:
      return {1, 1, 1, 0.20};
    case Family::wide:
      return {0.6, 0.45, 0.55, 0.00001};  // a few insphere in ten million span more than 189 bits
    case Family::extreme:
      return {1, 0.45, 0.60, 0.53};
    case Family::mixture:
      break;
  }
  return {0.8, 0.10, 0.25, 0.40};
}

using PredicateAndFamily = std::tuple<std::size_t, Family>;

class Agreement : public testing::TestWithParam<PredicateAndFamily> {};

inline std::string name_of_test(const testing::TestParamInfo<PredicateAndFamily>& info) {
  return std::string(classics()[std::get<0>(info.param)].name) + "_" + std::string(name_of(std::get<1>(info.param)));
}

TEST_P(Agreement, EveryStageTellsTheTrueSign) {
  const CatalogEntry& e = classics()[std::get<0>(GetParam())];
  const Family family = std::get<1>(GetParam());
  Tally tally;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const std::vector<double> p = coordinates_of(e, family, i);
    if (!disagreement(e, p, {i % rationals_every == 0, i % cgal_every == 0}).empty())
      FAIL() << "case " << i << ": " << report(e, p);
    tally.add(e.decide(p));
  }
  std::cout << e.name << ' ' << name_of(family) << " decided by" << tally << '\n';
  const Promise promise = promise_of(family);
  EXPECT_LE(1 - tally.decided(Stage::filter), promise.most_unsure);
  EXPECT_GE(tally.share(Sign::zero), promise.least_zero);
  EXPECT_LE(tally.share(Sign::zero), promise.most_zero);
  EXPECT_GE(tally.share(Sign::negative), 0.4 * (1 - promise.most_zero));
  EXPECT_GE(tally.share(Sign::positive), 0.4 * (1 - promise.most_zero));
  EXPECT_LE(tally.decided(Stage::big_integer), promise.most_allocating);
  if (family != Family::repeated) return;
  EXPECT_EQ(tally.decided(Stage::filter), 0);
  EXPECT_GE(tally.decided(Stage::structural_zero), 0.1);  // the integers come first
}

inline std::vector<PredicateAndFamily> parameters_of(Shard shard) {
  std::vector<PredicateAndFamily> all;
  for (std::size_t i = 0; i < classics().size(); ++i) {
    for (const FamilyInfo& f : families) {
      if (shard_of(f.family) == shard) all.emplace_back(i, f.family);
    }
  }
  return all;
}

}  // namespace plumb::battery
