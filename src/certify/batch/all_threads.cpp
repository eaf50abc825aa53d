#include "certify/batch/all_threads.hpp"

#include <tbb/parallel_for.h>

namespace plumb::certify::batch {

void for_each_part(Execution execution, std::size_t n, void (*call)(const void* work, std::size_t part),
                   const void* work) {
  if (execution == Execution::parallel && n > 1) {
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t part) { call(work, part); });
  } else {
    for (std::size_t part = 0; part < n; ++part) call(work, part);
  }
}

}  // namespace plumb::certify::batch
