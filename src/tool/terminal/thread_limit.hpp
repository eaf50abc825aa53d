// On how many threads does the program work?  On as many as the machine has, or as it was told.
//
// Law: the limit holds for what oneTBB runs as long as the object lives.
// Source: none.
// Cost: none.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>

namespace plumb::tool {

class ThreadLimit {
 public:
  /// 0: as many as the machine has.
  explicit ThreadLimit(unsigned asked)
      : threads_(asked != 0 ? asked : static_cast<unsigned>(tbb::info::default_concurrency())),
        limit_(tbb::global_control::max_allowed_parallelism, threads_) {}

  [[nodiscard]] unsigned threads() const { return threads_; }

 private:
  unsigned threads_;
  tbb::global_control limit_;
};

}  // namespace plumb::tool
