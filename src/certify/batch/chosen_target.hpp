// Which of the compiled filters does this processor take?  The best that it has, or the one that is asked for.
//
// PLUMB_EXPORT(ask); and PLUMB_DISPATCH(ask)(...) are Highway's HWY_EXPORT and HWY_DYNAMIC_DISPATCH with a choice of our
// own: what is forced upon Plumb is forced upon no other user of Highway in the process, and nothing of Highway's library
// is linked, which measures its clock before main() and fails there under valgrind.  Included after HWY_DISABLED_TARGETS
// is set.
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

// The first entry is Highway's for what has not chosen yet, which chosen_target() always has.
#define PLUMB_EXPORT(ask)                                                               \
  [[maybe_unused]] static decltype(&HWY_STATIC_DISPATCH(ask)) const HWY_DISPATCH_TABLE( \
      ask)[HWY_MAX_DYNAMIC_TARGETS + 2] = {nullptr, HWY_CHOOSE_TARGET_LIST(ask), HWY_CHOOSE_FALLBACK(ask)}
#define PLUMB_DISPATCH(ask) (*(HWY_DISPATCH_TABLE(ask)[plumb::certify::batch::chosen_target().GetIndex()]))
