// Does Gappa confirm the bounds that were derived from a statement?
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "certify/gappa.hpp"
#include "certify/sanitized.hpp"

namespace plumb {

/// Is this the claim of a bound's constant, whatever the axes of its scales?
inline bool claims(const std::string& script, const std::string& bound) {
  return script.find("\n# " + bound.substr(0, bound.find(' ') + 1)) != std::string::npos;
}

/// Each bound that is not zero has its claim among the scripts; one for each constant is proved.
inline void expect_proved(const std::vector<std::string>& bounds, const std::vector<std::string>& scripts) {
  for (const std::string& bound : bounds) {
    if (bound.starts_with("0x0p+0 ")) continue;
    const auto script = std::ranges::find_if(scripts, [&](const std::string& s) { return claims(s, bound); });
    ASSERT_NE(script, scripts.end()) << "nothing is claimed of " << bound;
    if (!gappa::is_installed() || battery::sanitized) continue;  // what Gappa computes, our sanitizers have no part in
    const gappa::Answer answer = gappa::prove(*script);
    EXPECT_EQ(answer.code, 0) << *script << answer.text;
  }
}

}  // namespace plumb
