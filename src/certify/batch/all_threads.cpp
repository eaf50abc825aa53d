#include "certify/batch/all_threads.hpp"

#include "certify/batch/thread_pool.hpp"

namespace plumb::certify::batch {

void for_each_part(Execution execution, std::size_t n, void (*call)(const void* work, std::size_t part),
                   const void* work) {
  if (execution == Execution::parallel) return share_out(n, call, work);
  for (std::size_t part = 0; part < n; ++part) call(work, part);
}

}  // namespace plumb::certify::batch
