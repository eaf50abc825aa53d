// Work in parts that do not depend on each other, on all threads where asked: who takes part says thread_pool.hpp.
//
// Cost: a call by a pointer a part.  As a template of the work each loop would be compiled as often as it is asked.
#pragma once

#include <cstddef>

#include "plumb/certify/batch.hpp"

namespace plumb::certify::batch {

/// Calls call(work, part) for each part of n; in their order where execution is serial.
void for_each_part(Execution execution, std::size_t n, void (*call)(const void* work, std::size_t part),
                   const void* work);

/// Calls work(part), likewise.
template <class Work>
void for_each_part(Execution execution, std::size_t n, const Work& work) {
  for_each_part(
      execution, n, [](const void* called, std::size_t part) { (*static_cast<const Work*>(called))(part); }, &work);
}

}  // namespace plumb::certify::batch
