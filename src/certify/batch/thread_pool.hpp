// Thread pool: who takes part in work that is cut into parts?  The thread that asks, and threads that help where there
// are any.
//
// Laws: (1) All parts are done when share_out() returns, or one has thrown: then what the lowest part that threw has
// thrown is thrown on, as where the parts are done one after the other, and higher ones may be left out.  (2) Nothing
// waits for a helper to come: where no thread can be made (of memory, of a limit, of a rule), the thread that asks does
// all.  (3) Nothing is allocated but the helpers' stacks, and no exception passes code that is not ours.  (4) A helper
// rounds to nearest and keeps subnormals whatever the thread that asked does, and takes no signals but those of its own
// faults.  (5) A child made by fork() while nothing is shared out makes helpers of its own.
// Source: none; oneTBB ends the program where a thread cannot be made, or where an exception finds no memory.
// Cost: a lock and a wake-up a call; helpers sleep until the process ends.
#pragma once

#include <cstddef>

namespace plumb::certify::batch {

/// Calls call(work, part) for each part of n, on at most as many threads as the limit says.
void share_out(std::size_t n, void (*call)(const void* work, std::size_t part), const void* work);

/// How many threads there may be, the one that asks included; set_limit returns what was before.  0: as the system says.
unsigned thread_limit();
unsigned set_thread_limit(unsigned most);

}  // namespace plumb::certify::batch
