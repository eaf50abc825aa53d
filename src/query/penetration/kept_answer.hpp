// Was the same asked last time, bit by bit?  Then what was answered is the answer.
//
// A cache keeps the numbers of both bodies, of their poses and of the options, and behind them what was answered.
// Bodies that did not move are told by a comparison of memory, and nothing of them is computed.
// Laws: (1) an answer is told again only where each bit that it depends on is as it was: zeros of other signs are other
// bits.  (2) Bodies whose numbers are more than `most_kept` bytes are not kept.
// Source: none.
// Cost: some 50 ns for two boxes, and a nanosecond for each further 30 bytes; memory is taken where a cache has too
// little.
#pragma once

#include <array>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/query/penetration/penetration.hpp"

namespace plumb::query {

constexpr std::size_t most_kept = 16384;

enum class KeptQuestion : std::uint32_t { none, penetration, contact };

/// All that an answer depends on.
struct AskedContact {
  KeptQuestion question;
  const BodyView &a, &b;
  std::array<double, 2> options{};
};

/// What a cache holds; it alone sees it.
struct KeptBytes {
  /// The bytes of the answer to the same question; empty where another one was asked.
  static std::span<const unsigned char> answer(const ContactCache& cache, const AskedContact& asked);
  /// Keeps the question, and behind it what `put_answer` puts; nothing where the question is too long.
  template <class Put>
  static void keep(ContactCache& cache, const AskedContact& asked, const Put& put_answer) {
    std::vector<unsigned char> kept = std::move(cache.last.bytes_);  // so that nothing is kept where memory runs out
    if (!put_question(kept, asked)) return;
    put_answer(kept);
    cache.last.bytes_ = std::move(kept);
  }

 private:
  static bool put_question(std::vector<unsigned char>& to, const AskedContact& asked);
};

/// Puts values behind one another, and takes them in the same order.
template <class T>
void put(std::vector<unsigned char>& to, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t at = to.size();
  to.resize(at + count * sizeof(T));
  if (count != 0) std::memcpy(to.data() + at, values, count * sizeof(T));
}
template <class T>
T taken(std::span<const unsigned char>& from) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  std::memcpy(static_cast<void*>(&value), from.data(), sizeof(T));
  from = from.subspan(sizeof(T));
  return value;
}

}  // namespace plumb::query
