// How is foreign code called so that it can do no harm?  The child's side: load, find, call case by case.
//
// Laws: (1) what the code prints goes nowhere; (2) it has so much memory and no more, lets no file grow and leaves no
// core; (3) each argument ends where readable memory ends, so reading beyond it is a crash and no luck; (4) an
// exception ends a call, not the child; (5) the child dies with the program; (6) a process that the code forks cannot
// answer for it.
// Source: none.
// Cost: copying a case and storing two numbers, about a millisecond to begin.
#pragma once

#include <cstdint>
#include <string>

#include "plumb/degenerate/kind.hpp"
#include "tool/fuzz/foreign_board.hpp"

namespace plumb::tool {

struct ForeignCode {
  std::string library, symbol;
  const degenerate::Kind& kind;
  std::uint64_t memory_mib = 1024;  // beyond what the program itself has
};

/// Never returns.  Reads a byte from `requests` for each batch on the board, writes one to `replies` when it is done,
/// as well as when the function has been found, or was not (ForeignBoard::state).
[[noreturn]] void serve_foreign(const ForeignCode& code, ForeignBoard& board, int requests, int replies);

}  // namespace plumb::tool
