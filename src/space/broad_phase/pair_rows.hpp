// Pairs by their lesser number, in rows: which are in one set of pairs, and not in another?
//
// Laws: what is told ascends, by the lesser number and then by the other.
// Source: RTCD 7.5.1.
// Cost: some ns a pair to make rows; rows that are equal as they stand are compared and no more, in others each number is
// looked up.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plumb::space {

class PairRows {
 public:
  /// Pairs of these numbers: each is counted by its lesser one, and when all are, put where it belongs.
  void count_anew(std::size_t numbers) { begin_.assign(numbers + 2, 0); }
  void count(std::uint32_t a) { ++begin_[a + 2]; }
  void allot() {
    for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    partner_.resize(begin_.back());
  }
  void put(std::uint32_t a, std::uint32_t b) { partner_[begin_[a + 1]++] = b; }
  void all_are_put() { begin_.pop_back(); }

  void clear() { begin_.clear(), partner_.clear(); }

  [[nodiscard]] std::size_t rows() const { return begin_.empty() ? 0 : begin_.size() - 1; }
  [[nodiscard]] std::size_t size() const { return partner_.size(); }
  /// The greater numbers of the pairs whose lesser one it is, in no order.
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t number) const {
    if (number >= rows()) return {};
    return {partner_.data() + begin_[number], begin_[number + 1] - begin_[number]};
  }

  /// The same pairs but for those of which is_out(a, b).
  template <class Out>
  void erase(const Out& is_out) {
    std::uint32_t kept = 0;
    for (std::size_t a = 0; a < rows(); ++a) {
      const std::uint32_t from = std::exchange(begin_[a], kept);
      for (std::uint32_t i = from; i < begin_[a + 1]; ++i) {
        if (!is_out(static_cast<std::uint32_t>(a), partner_[i])) partner_[kept++] = partner_[i];
      }
    }
    if (!begin_.empty()) begin_.back() = kept;
    partner_.resize(kept);
  }

 private:
  std::vector<std::uint32_t> begin_, partner_;
};

/// lost(a, b) of the pairs that are in the first alone, added(a, b) of those in the second.
template <class Lost, class Added>
void compare_rows(const PairRows& before, const PairRows& now, const Lost& lost, const Added& added) {
  constexpr std::uint32_t none = 0xffffffff;
  const std::size_t rows = std::max(before.rows(), now.rows());
  std::vector<std::uint32_t> row_of(rows, none);  // the row before in which a number was seen last, and not since
  std::vector<std::uint32_t> differing;
  const auto tell = [&](std::uint32_t a, const auto& to) {
    if (differing.size() > 1) std::sort(differing.begin(), differing.end());
    for (const std::uint32_t b : differing) to(a, b);
    differing.clear();
  };
  for (std::size_t i = 0; i < rows; ++i) {
    const auto was = before[i], is = now[i];
    if (std::equal(was.begin(), was.end(), is.begin(), is.end())) continue;
    const auto a = static_cast<std::uint32_t>(i);
    for (const std::uint32_t b : was) row_of[b] = a;
    for (const std::uint32_t b : is) {
      if (row_of[b] != a) differing.push_back(b);
      row_of[b] = none;
    }
    tell(a, added);
    for (const std::uint32_t b : was) {
      if (row_of[b] == a) differing.push_back(b);
    }
    tell(a, lost);
  }
}

}  // namespace plumb::space
