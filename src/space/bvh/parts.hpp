// Work in parts, of which whoever asked is told, and which stop where they are told to; or cut into blocks whose number
// depends on the work alone, so that what is put together from them does as well.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>

#include "certify/batch/all_threads.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb::space {

inline std::size_t blocks_of(std::size_t n, std::size_t size) { return (n + size - 1) / size; }

/// Calls work(block, from, to) for each block of `size` of n.
template <class Work>
void for_blocks(Execution execution, std::size_t n, std::size_t size, const Work& work) {
  certify::batch::for_each_part(execution, blocks_of(n, size),
                                [&](std::size_t b) { work(b, b * size, std::min(n, (b + 1) * size)); });
}

/// Calls call(work, part) for each of n; in their order where execution is serial.  A part that returns Descent::stop has
/// found enough: no further part is begun.  Throws Cancelled in the function's name where progress says so.
inline void for_parts(const char* function, Execution execution, const Progress& progress, std::size_t n,
                      Descent (*call)(const void* work, std::size_t part), const void* work) {
  std::atomic<bool> stopped = false, cancelled = false;
  std::mutex one_at_a_time;
  std::size_t done = 0;
  certify::batch::for_each_part(execution, n, [&](std::size_t part) {
    if (stopped) return;
    if (call(work, part) == Descent::stop) stopped = true;
    if (!progress) return;
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (!cancelled && !progress(static_cast<double>(done) / static_cast<double>(n))) stopped = cancelled = true;
  });
  if (cancelled) throw Cancelled(std::string(function) + ": cancelled by its progress function");
}

/// Calls work(part), likewise; it need not return whether to go on.
template <class Work>
void for_parts(const char* function, Execution execution, const Progress& progress, std::size_t n, const Work& work) {
  for_parts(
      function, execution, progress, n,
      [](const void* called, std::size_t part) { return visited(*static_cast<const Work*>(called), part); }, &work);
}

}  // namespace plumb::space
