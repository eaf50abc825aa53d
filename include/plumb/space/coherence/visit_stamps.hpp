// Has this query been here before?  Time stamps of a byte, cleared once in 255 queries ("mailboxes").
//
//   VisitStamps seen(n);
//   seen.begin();                          // a query begins: it has been nowhere
//   if (seen.visit(i)) test(i);            // true the first time alone
//
// Laws: (1) visit(i) is true exactly once between two calls of begin, for each i.  (2) visited(i) says whether it has
// been called since then.  (3) Of any number of queries: when the stamps come round, all are cleared.
// An i that is not below size() is a mistake of the caller.
// Source: RTCD 7.7, 7.7.2, 7.7.3.
// Cost: a byte each; begin clears them once in 255 calls, which is size() / 255 bytes a query.  It pays where a test
// costs more than the miss of a cache that a stamp may cost: measure, or test again.  Nothing is searched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

class VisitStamps {
 public:
  explicit VisitStamps(std::size_t n = 0) : stamps_(n, 0) {}

  [[nodiscard]] std::size_t size() const { return stamps_.size(); }
  /// Of another number of things, as if new.
  void reset(std::size_t n) {
    stamps_.assign(n, 0);
    now_ = 1;
  }

  void begin() {
    if (now_ == most) {
      stamps_.assign(stamps_.size(), 0);
      now_ = 0;
    }
    ++now_;
  }
  bool visit(std::size_t i) {
    const bool first = stamps_[i] != now_;
    stamps_[i] = now_;
    return first;
  }
  [[nodiscard]] bool visited(std::size_t i) const { return stamps_[i] == now_; }

 private:
  static constexpr std::uint8_t most = 255;
  std::vector<std::uint8_t> stamps_;  // 0: not since they were cleared
  std::uint8_t now_ = 1;
};

}  // namespace plumb
