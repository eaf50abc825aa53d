// What does this work find, if it may take so long and so much memory, and may crash?  Done by a process of its own,
// which tells a text or how it ended.
//
// Laws: (1) whatever the work does, this process goes on.  (2) The work ends when its time is over, and when this
// process ends, however that ends.  (3) Memory is address space beyond that which this process has.  (4) What the work
// says on standard error is kept where it ended before it was done, and else lost; its standard output is nobody's.
// (5) No thread runs in this process when it is called: fork() would leave it behind.
// Source: fork(2), setrlimit(2), prctl(2).
// Cost: some 1 ms a process.  Nothing is searched.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace plumb::tool {

struct ProcessLimits {
  std::optional<double> seconds;     // by the clock
  std::optional<std::uint64_t> mib;  // of address space
};

enum class HowEnded : unsigned char { done, timeout, out_of_memory, crashed };

struct ProcessEnd {
  HowEnded how = HowEnded::crashed;
  std::string text;  // of the work that is done
  std::string why;   // of work that is not
  double seconds = 0, peak_mib = 0;
};

/// Throws Error where no process can be made.
ProcessEnd run_limited(const ProcessLimits& limits, const std::function<std::string()>& work);

}  // namespace plumb::tool
