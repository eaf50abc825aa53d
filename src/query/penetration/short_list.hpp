// A list without allocation, as long as it is short.
//
// Laws: those of a vector, as far as it has them; more than N take memory.
// Cost: none; beyond N that of a vector.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace plumb::query::parting {

template <class T, std::size_t N>
class ShortList {
 public:
  void push_back(const T& x) {
    if (size_ < N) {
      few_[size_] = x;
    } else {
      if (size_ == N) many_.assign(few_.begin(), few_.end());
      many_.push_back(x);
    }
    ++size_;
  }
  void clear() { size_ = 0, many_.clear(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T* begin() { return size_ <= N ? few_.data() : many_.data(); }
  [[nodiscard]] T* end() { return begin() + size_; }
  [[nodiscard]] const T* begin() const { return size_ <= N ? few_.data() : many_.data(); }
  [[nodiscard]] const T* end() const { return begin() + size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return begin()[i]; }

 private:
  std::array<T, N> few_{};
  std::vector<T> many_;
  std::size_t size_ = 0;
};

}  // namespace plumb::query::parting
