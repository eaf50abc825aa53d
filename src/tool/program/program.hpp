// How does a program of ours run?  Reads the command line, runs one command, flushes, and answers with the exit code:
// 0 done, 1 a wrong sign was found that --fail-on-wrong asked for or an exact method failed in the laboratory, 2 bad
// input (also an output that cannot be written).
//
// Law: nothing that can go wrong ends in silence or in a crash: every failure is one line `plumb: ...` on standard
// error.
// Source: none.
// Cost: none.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tool/manual/command.hpp"
#include "tool/manual/man_page.hpp"

namespace plumb::tool {

/// What tells one program from another: `plumb`, `plumb-lab`.
struct ProgramFacts {
  std::string name;
  Manual (*manual)();
  /// All its commands but `help` and `completion`, which every program has.
  std::function<std::vector<Command>(CLI::App& program)> commands;
  /// What to take instead of a word that is no command here; nothing where nobody would look for the word.
  std::string (*instead)(const std::string& word);
};

int run_program(const ProgramFacts& facts, int argc, char** argv);

/// `plumb`.
ProgramFacts plumb_facts();

}  // namespace plumb::tool
