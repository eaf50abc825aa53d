// On how many threads does Execution::parallel work?  On as many as this process may run at once, or on fewer.
//
//   const plumb::ThreadLimit one(1);   // until it goes: no thread is made, none that there is takes part
//
// Laws: (1) The limit holds for the whole process while the object lives; then the one before it holds again, so that
// limits are nested, or are one thread's affair.  (2) No answer depends on it.  (3) It counts the thread that asks: it
// takes part in its own work, and does all of it where no thread can be made (docs/environment.md).
// Source: none.
// Cost: none.  In the library plumb::batch.
#pragma once

#include <cstddef>

#include "plumb/predicates/standard.hpp"

namespace plumb {

class ThreadLimit {
 public:
  /// 0: as many as this process may run at once.
  explicit ThreadLimit(std::size_t most);
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  ~ThreadLimit();

  [[nodiscard]] unsigned threads() const { return threads_; }

 private:
  unsigned threads_, before_;
};

}  // namespace plumb
