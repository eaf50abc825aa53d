// Does this thread round as the proofs assume?  Looked at before each decision, where PLUMB_CHECKED is defined.
//
// Off unless asked for: -DPLUMB_CHECKED for files of one's own, CMake's -DPLUMB_CHECKED=ON for what is compiled into
// the library.  No decision hangs on NDEBUG, nor on a build type.
// Laws: (1) A decision of a thread that rounds otherwise, or flushes subnormals, ends the program with a line that says
// so.  (2) Files with and without it may be linked together.  The functions that look have names of their own for the
// linker there (abi_tag), so that none stands in for one that does not look.  Of an inline function above them, which
// has one name, the linker keeps either copy: it may or may not look, and answers the same.
// Source: RTCD 11.2.3.
// Cost: tens of ns a decision where it is on, nothing where it is off.
#pragma once

#include <type_traits>

#include "plumb/predicates/standard.hpp"

#ifdef PLUMB_CHECKED
#define PLUMB_CHECKABLE [[gnu::abi_tag("checked")]]
#else
#define PLUMB_CHECKABLE
#endif

namespace plumb {

namespace certify::environment {

/// Ends the program where the thread does not round to nearest, or flushes subnormals.
void require_sound_thread();

}  // namespace certify::environment

/// Where PLUMB_CHECKED is defined: the thread rounds as the proofs assume.  Who calls it is PLUMB_CHECKABLE.
PLUMB_CHECKABLE constexpr void assert_sound_thread() {
#ifdef PLUMB_CHECKED
  if (!std::is_constant_evaluated()) certify::environment::require_sound_thread();
#endif
}

}  // namespace plumb
