// Does a number know whether code that asks it branches rightly?  What a question's numbers could not tell.
//
// Law: who answers a question clears the mark before, and is unsure where it is set after.
// Source: none.
// Cost: a thread's own variable.
#pragma once

namespace plumb::lab::trial {

/// Has a number of this thread's question been asked what it does not know?
inline constinit thread_local bool in_doubt = false;

/// What is known of a comparison: yes, no, or neither.  Without a branch, which nobody could foresee.
inline bool told(bool yes, bool no) {
  const bool open = static_cast<int>(yes) + static_cast<int>(no) == 0;
  in_doubt = (static_cast<int>(in_doubt) | static_cast<int>(open)) != 0;
  return yes;
}

}  // namespace plumb::lab::trial
