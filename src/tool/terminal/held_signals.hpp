// How is a run stopped that just puts files into place?  After what it must not leave behind is gone.
//
// Law: while one lives, SIGINT, SIGTERM and SIGHUP are noted; at its end the first of them is obeyed as if it came
// then.  Memory that runs out is an exception meanwhile (out_of_memory.hpp).
// Source: sigaction(2).
// Cost: six system calls. One at a time.
#pragma once

#include <array>
#include <csignal>

#include "tool/terminal/out_of_memory.hpp"

namespace plumb::tool {

class HeldSignals {
 public:
  HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals();

  [[nodiscard]] static bool arrived();

 private:
  static constexpr std::array held_{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, held_.size()> before_{};
  MemoryThrows memory_;
};

}  // namespace plumb::tool
