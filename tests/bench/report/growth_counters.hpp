// What do benchmarks of growth count?  Time for each of many things, and memory.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace plumb::bench {

/// The most memory that was resident since forget_peak, in bytes; 0 where Linux does not tell.
inline void forget_peak() {
  if (std::FILE* const f = std::fopen("/proc/self/clear_refs", "w")) {
    std::fputs("5", f);
    std::fclose(f);
  }
}
inline double peak_bytes() {
  double kib = 0;
  if (std::FILE* const f = std::fopen("/proc/self/status", "r")) {
    for (char line[256]; std::fgets(line, sizeof line, f) != nullptr;) {
      if (std::strncmp(line, "VmHWM:", 6) == 0) kib = std::strtod(line + 6, nullptr);
    }
    std::fclose(f);
  }
  return kib * 1024;
}

inline benchmark::Counter ns_for_each(std::size_t n) {
  return benchmark::Counter(static_cast<double>(n) * 1e-9,
                            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace plumb::bench
