// How often did this thread ask for memory?  Every operator new of the program, and every allocation of GMP, is
// counted.
//
// Law: counts never change what is allocated.  Memory that a rival's library takes by malloc is not seen.
// Source: none.
// Cost: an increment of a thread's counter an allocation.
#pragma once

#include <cstdint>

namespace plumb::lab::trial {

std::uint64_t allocations();

/// GMP's allocations count from here on.
void count_gmp_allocations();

}  // namespace plumb::lab::trial
