// How does the program run?  Reads the command line, runs one command, flushes, and answers with the exit code:
// 0 done, 1 a wrong sign was found that --fail-on-wrong asked for or an exact method failed in the laboratory, 2 bad
// input (also an output that cannot be written).
//
// Law: nothing that can go wrong ends in silence or in a crash: every failure is one line `plumb: ...` on standard
// error.
#pragma once

#include <span>

#include "tool/trial/task.hpp"

namespace plumb::tool {

/// `plumb chart` tries these rivals as well; the installed program has none.
int run_program(int argc, char** argv, std::span<const trial::Rival> rivals = {});

}  // namespace plumb::tool
