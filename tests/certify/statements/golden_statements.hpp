// The derived bounds of a statement: are they those of tests/certify/statements/golden_statements.txt?
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "plumb/certify/judged_bounds.hpp"

namespace plumb {

/// Against the lines that begin with this name.
inline void expect_golden(const std::string& name, const std::vector<std::string>& lines) {
  std::vector<std::string> derived, recorded;
  std::string should;
  for (const std::string& line : lines) {
    derived.push_back(name + ' ' + line);
    should += derived.back() + '\n';
  }
  std::ifstream file(PLUMB_SOURCE_DIR "/tests/certify/statements/golden_statements.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(name + ' ')) recorded.push_back(line);
  }
  EXPECT_EQ(recorded, derived) << "golden_statements.txt should hold\n" << should;
}
/// What was judged since the listener was asked last.
inline void expect_golden(const std::string& name) { expect_golden(name, BoundListener::taken()); }

}  // namespace plumb
