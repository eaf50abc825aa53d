// Is what is told of two shapes in straight motion true?  The first time and the features that meet then, of any kinds,
// against the oracle in rationals.
//
// Law: of the features that meet at the first time those that are told are the lowest.
// Cost: that of the oracle for each pair of features, of at most 90 pairs.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "plumb/arith/big.hpp"
#include "plumb/arith/root.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "query/time_of_impact/translating_oracle.hpp"

namespace plumb::translating_oracle {

/// Is the root this number?
inline bool is(const Root& root, const Surd& t) {
  Surd value{0, 0, t.c};  // of the root's polynomial at the number
  const std::vector<Rational> coefficients = root.polynomial();
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    const Number a = value.a * t.a + value.b * t.b * t.c + coefficients[i].value().value;
    value.b = value.a * t.b + value.b * t.a;
    value.a = a;
  }
  const auto beyond = [&](const Rational& x) { return sign(Surd{t.a - x.value().value, t.b, t.c}); };
  const auto [lower, upper] = root.interval();
  return sign(value) == 0 && beyond(lower) >= 0 && beyond(upper) <= 0;
}

struct Told {
  int never = 0, at_start = 0, later = 0, irrational = 0;
};

/// The pairs of features that meet no later than the bodies do, of those no higher than the ones told.
inline void check_features(const std::string& about, const Body& a, const Body& b, const Vector& velocity,
                           const Surd& time, const Contact& contact) {
  const auto rank = [](const Feature& p, const Feature& q) {
    return std::tuple(static_cast<int>(p.kind) + static_cast<int>(q.kind), p.kind, p.index, q.kind, q.index);
  };
  const auto told = rank(contact.feature_a, contact.feature_b);
  constexpr std::size_t most = 90;  // pairs to ask; of more the one that is told
  const bool all = a.parts.size() * b.parts.size() <= most;
  bool found = false;
  for (const Part& p : a.parts) {
    for (const Part& q : b.parts) {
      const auto of_pair = rank(p.feature, q.feature);
      if (of_pair > told || (!all && of_pair != told)) continue;
      const auto when = first_time(a.part(p), b.part(q), velocity);
      const bool meets = when && compare(*when, time) == 0;
      found |= meets && of_pair == told;
      ASSERT_EQ(meets, of_pair == told) << about << " feature " << p.feature.index << " of a, " << q.feature.index
                                        << " of b";
    }
  }
  ASSERT_TRUE(found) << about;
}

struct Mover {
  Body body;
  Vector by;
};
struct Answers {
  std::optional<Root> time;
  std::optional<Contact> contact, of_swapped;
  bool meet, meet_swapped;
};

inline void check_truth(const std::string& about, const Mover& a, const Mover& b, const Answers& says, Told& told) {
  const Vector velocity = a.by - b.by;
  const std::optional<Surd> truth = first_time(a.body, b.body, velocity);
  ASSERT_EQ(says.meet, truth.has_value()) << about;
  ASSERT_EQ(says.meet_swapped, truth.has_value()) << about;
  ASSERT_EQ(says.time.has_value(), truth.has_value()) << about;
  ASSERT_EQ(says.contact.has_value(), truth.has_value()) << about;
  if (!truth) {
    ++told.never;
    return;
  }
  const Contact& contact = *says.contact;
  ASSERT_TRUE(is(*says.time, *truth)) << about;
  // Rounded down: not late, and the double after it is.
  ASSERT_GE(compare(*truth, contact.time), 0) << about;
  ASSERT_LT(compare(*truth, std::nextafter(contact.time, 2.0)), 0) << about;
  ASSERT_TRUE(says.of_swapped && says.of_swapped->time == contact.time) << about;
  const bool at_start = compare(*truth, 0.0) == 0;
  ++(at_start ? told.at_start : told.later);
  told.irrational += sgn(truth->b) != 0 ? 1 : 0;
  if (contact.feature_a.kind == FeatureKind::interior) {
    ASSERT_TRUE(at_start && contact.feature_b.kind == FeatureKind::interior) << about;
    return;
  }
  check_features(about, a.body, b.body, velocity, *truth, contact);
}

}  // namespace plumb::translating_oracle
