// Has this query been here before?  Bit flags, of which only those that were set are cleared.
//
//   VisitBits seen(n);
//   seen.begin();                          // a query begins: it has been nowhere
//   if (seen.visit(i)) test(i);            // true the first time alone
//
// Laws: those of VisitStamps (visit_stamps.hpp): visit(i) is true exactly once between two calls of begin, for each i.
// An i that is not below size() is a mistake of the caller.
// Source: RTCD 7.7.1.
// Cost: a bit each, an eighth of what stamps take: they pay where stamps of all things would not stay in the cache.
// begin clears the words that have been written to, so a query that visits little costs little; each visit of a word
// that was empty is noted, which stamps need not.  Nothing is searched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

class VisitBits {
 public:
  explicit VisitBits(std::size_t n = 0) : size_(n), words_((n + 63) / 64, 0) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Of another number of things, as if new.
  void reset(std::size_t n) {
    size_ = n;
    words_.assign((n + 63) / 64, 0);
    written_.clear();
  }

  void begin() {
    for (const std::size_t w : written_) words_[w] = 0;
    written_.clear();
  }
  bool visit(std::size_t i) {
    std::uint64_t& word = words_[i / 64];
    const std::uint64_t bit = std::uint64_t{1} << i % 64;
    if ((word & bit) != 0) return false;
    if (word == 0) written_.push_back(i / 64);
    word |= bit;
    return true;
  }
  [[nodiscard]] bool visited(std::size_t i) const { return (words_[i / 64] >> i % 64 & 1) != 0; }

 private:
  std::size_t size_;
  std::vector<std::uint64_t> words_;
  std::vector<std::size_t> written_;  // words that are not zero
};

}  // namespace plumb
