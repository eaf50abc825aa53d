// Which of the compiled filters does this processor take?  The best that it has, or the one that is asked for.
//
// PLUMB_DISPATCH(ask)(...) is Highway's dispatch with a choice of its own, so that what is forced upon Plumb is forced
// upon no other user of Highway in the process.  Included after HWY_DISABLED_TARGETS is set.
// Cost: a load; the environment is read once.
#pragma once

#include <hwy/targets.h>

#include <cstdint>

namespace plumb::certify::batch {

/// Throws Error where the environment names no set of this machine.
const hwy::ChosenTarget& chosen_target();

/// Where the environment names none, all that the processor has.
std::int64_t targets_or_all() noexcept;

}  // namespace plumb::certify::batch

#define PLUMB_DISPATCH(ask) (*(HWY_DISPATCH_TABLE(ask)[plumb::certify::batch::chosen_target().GetIndex()]))
