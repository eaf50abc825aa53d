// Whose is an array: one's own, or a part of a file that is mapped into memory?
//
// Laws: a copy of an array of one's own is another array; copies of a mapped one share the mapping, which lives as long
// as one of them.
// Cost: a comparison more than a span; take view() once before a loop.  Nothing is searched.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

template <class T>
class KeptArray {
 public:
  KeptArray() = default;
  KeptArray(std::vector<T> own) : own_(std::move(own)) {}  // NOLINT: a vector is one
  /// `keeps` owns the memory of `part`.
  KeptArray(std::span<const T> part, std::shared_ptr<const void> keeps) : part_(part), keeps_(std::move(keeps)) {}

  [[nodiscard]] std::span<const T> view() const { return keeps_ ? part_ : std::span<const T>(own_); }
  [[nodiscard]] std::size_t size() const { return view().size(); }
  [[nodiscard]] bool empty() const { return view().empty(); }
  [[nodiscard]] const T* data() const { return view().data(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return view()[i]; }
  [[nodiscard]] auto begin() const { return view().begin(); }
  [[nodiscard]] auto end() const { return view().end(); }

  /// To be written to: what was mapped is copied first.
  [[nodiscard]] std::vector<T>& writable() {
    if (keeps_) {
      own_.assign(part_.begin(), part_.end());
      part_ = {};
      keeps_.reset();
    }
    return own_;
  }

 private:
  std::vector<T> own_;
  std::span<const T> part_;
  std::shared_ptr<const void> keeps_;
};

}  // namespace plumb
