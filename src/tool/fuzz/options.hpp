// What is `plumb fuzz` asked for?  The command line, as its parser fills it and as its reports repeat it.
//
// Source: none; cost: none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/degenerate/domain.hpp"

namespace plumb::tool {

struct FuzzOptions {
  std::string kind, library, symbol;
  bool list = false;                     // what kinds and generators there are
  std::optional<std::string> case_line;  // only this one
  std::optional<std::uint64_t> cases;    // of each generator
  std::optional<double> seconds;
  std::uint64_t seed = 2026;
  std::vector<std::string> generators;  // none: all
  std::vector<std::string> formats;     // what findings are also printed as
  std::optional<std::uint64_t> ulps;    // allowed of numbers
  std::optional<double> relative;       // the same, of the case's largest magnitude
  double timeout = 1;                   // seconds a call
  std::uint64_t memory_mib = 1024;
  std::optional<std::string> corpus, out;  // folders
  // What the function promises, and which numbers it is made for.
  std::string boundary = "in", ends = "closed";
  degenerate::Domain domain;
  // A question of the user's own, and who knows its answer.
  std::vector<std::string> arguments;  // own_arguments.hpp
  std::string answer = "sign";
  std::optional<std::string> judge;  // FILE:SYMBOL
};

}  // namespace plumb::tool
