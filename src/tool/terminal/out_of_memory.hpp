// How does a run end that finds no memory?  With 2, as any run that cannot do its work, and never by a signal.
//
// Laws: (1) Where memory runs out on whatever thread, in a destructor or in another's code, the run ends at once with a
// line that says so and repeats the command, which names the files.  Nothing is unwound: what would be destroyed may
// need memory itself, as a JSON value does.  No output has taken its place by then (output_files.hpp).  (2) While files
// are put into place (MemoryThrows) it is an exception instead, so that what was written beside them is removed.
// (3) GMP, which would abort, obeys the same.
// Source: std::set_new_handler, std::set_terminate, mp_set_memory_functions.
// Cost: none until then.
#pragma once

#include <new>
#include <string_view>

namespace plumb::tool {

/// From now on, in this process, whose line begins with the program's name.
void end_without_memory(std::string_view program, int argc, char** argv);

/// The line, to standard error, after everything said so far; allocates nothing.
void say_out_of_memory();

/// All of this undone, for code that is not ours.
void obey_memory_no_more();

class MemoryThrows {
 public:
  MemoryThrows() : before_(std::set_new_handler(nullptr)) {}
  MemoryThrows(const MemoryThrows&) = delete;
  MemoryThrows& operator=(const MemoryThrows&) = delete;
  ~MemoryThrows() { std::set_new_handler(before_); }

 private:
  std::new_handler before_;
};

}  // namespace plumb::tool
