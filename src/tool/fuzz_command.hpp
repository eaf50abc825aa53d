// `plumb fuzz`: on which inputs does a function of a foreign library go wrong, and what is the simplest of them?
//
// Laws: (1) exit code 0 where nothing was found, 1 where something was, 2 for bad input, which is refused before
// anything is asked; (2) the same seed, cases, corpus and library give the same text, unless time cut the run short;
// (3) each finding has a line that asks it again; (4) reports and corpus are written whole or not at all.
// Source: RTCD 11.
// Cost: the budget's, and what shrinking takes.
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

int run_fuzz(const FuzzOptions& options);

}  // namespace plumb::tool
