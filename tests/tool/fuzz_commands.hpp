// How is `plumb fuzz` tried?  Its command lines on the libraries of tests/tool/foreign, and what is read from its
// report.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {

/// Shrinking takes its time for each.
inline const std::string kFewGenerators = " --generator uniform --generator near_half --generator degenerate_long ";

inline std::string module(const std::string& name) { return PLUMB_FOREIGN "/" + name + ".so"; }

inline std::string command(const std::string& name, const std::string& symbol, const std::string& kind = "orient3d") {
  return "$PLUMB fuzz --kind " + kind + " --library " + module(name) + " --symbol " + symbol + " ";
}

/// Lines that ask a finding again, in the order of the findings.
inline std::vector<std::string> replay_lines(const std::string& out) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; (at = out.find("\nplumb fuzz ", at)) != std::string::npos; ++at)
    lines.push_back("$PLUMB" + out.substr(at + 6, out.find('\n', at + 1) - at - 6));
  return lines;
}

/// The line that begins with this.
inline std::string line_of(const std::string& out, const std::string& begin) {
  const std::size_t at = out.find("\n" + begin);
  return at == std::string::npos ? "" : out.substr(at + 1, out.find('\n', at + 1) - at - 1);
}

inline void expect_refusal(const Outcome& o, const std::string& words) {
  EXPECT_EQ(o.code, 2) << o.out;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words)));
  EXPECT_EQ(std::ranges::count(o.err, '\n'), 1) << o.err;
}

}  // namespace plumb::tool
