// Work in parts, of which whoever asked is told, and which stop where they are told to.
#pragma once

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>

#include "plumb/certify/batch.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb::space {

/// Calls work(part) for each of n; in their order where execution is serial.  Work that returns Descent::stop has found
/// enough: no further part is begun.  Throws Cancelled in the function's name where progress says so.
template <class Work>
void for_parts(const char* function, Execution execution, const Progress& progress, std::size_t n, const Work& work) {
  std::atomic<bool> stopped = false, cancelled = false;
  std::mutex one_at_a_time;
  std::size_t done = 0;
  const auto one = [&](std::size_t part) {
    if (stopped) return;
    if (visited(work, part) == Descent::stop) stopped = true;
    if (!progress) return;
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (!cancelled && !progress(static_cast<double>(done) / static_cast<double>(n))) stopped = cancelled = true;
  };
  if (execution == Execution::parallel && n > 1) {
    tbb::parallel_for(std::size_t{0}, n, one);
  } else {
    for (std::size_t part = 0; part < n; ++part) one(part);
  }
  if (cancelled) throw Cancelled(std::string(function) + ": cancelled by its progress function");
}

}  // namespace plumb::space
