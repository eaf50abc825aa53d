// Orders the infinitesimals by the indices, then asks for the sign: by moved coordinates, and where that does not do,
// by expansion.
#include "plumb/certify/perturbed.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "certify/moved_signs.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::certify::perturbation {
namespace {

// "b", or "argument 30" where letters have run out.
std::string argument_name(std::size_t i) {
  return i < 26 ? std::string(1, static_cast<char>('a' + i)) : std::string("argument ").append(std::to_string(i));
}

[[noreturn]] void throw_repeated(const Subject& subject, std::size_t i, std::size_t k, std::uint64_t index) {
  if (i > k) std::swap(i, k);
  throw RepeatedIndex(std::string(subject.name)
                          .append(": ")
                          .append(argument_name(i))
                          .append(" and ")
                          .append(argument_name(k))
                          .append(" both have the index ")
                          .append(std::to_string(index))
                          .append("; give each point an index of its own"));
}

// Space for n values, on the stack where they are few.
template <class T>
class Space {
 public:
  explicit Space(std::size_t n) : many_(n > few_.size() ? n : 0) {
    values_ = {many_.empty() ? few_.data() : many_.data(), n};
  }
  Space(const Space&) = delete;
  Space& operator=(const Space&) = delete;
  T& operator[](std::size_t i) { return values_[i]; }
  [[nodiscard]] std::span<T> all() const { return values_; }

 private:
  std::array<T, 32> few_;  // NOLINT: left uninitialized
  std::vector<T> many_;
  std::span<T> values_;
};

// Fills `order` with the arguments by index; the sign of that permutation.
Sign sort_by_index(const Subject& subject, std::span<const std::uint64_t> indices, std::span<std::uint16_t> order) {
  Sign parity = Sign::positive;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::size_t at = i;
    for (; at > 0 && indices[order[at - 1]] >= indices[i]; --at) {
      if (indices[order[at - 1]] == indices[i]) throw_repeated(subject, order[at - 1], i, indices[i]);
      order[at] = order[at - 1];
      parity = -parity;
    }
    order[at] = static_cast<std::uint16_t>(i);
  }
  return parity;
}

}  // namespace

Sign sign_of_zero(const Subject& subject, std::span<const double> coordinates, std::span<const std::uint64_t> indices) {
  Space<std::uint16_t> arguments(indices.size()), order(coordinates.size());
  Sign parity = sort_by_index(subject, indices, arguments.all());
  Space<std::size_t> first(indices.size());
  std::size_t sum = 0;
  for (std::size_t a = 0; a < indices.size(); ++a) {
    first[a] = sum;
    sum += static_cast<std::size_t>(subject.arguments[a]);
  }
  Space<double> p(coordinates.size());
  std::size_t j = 0;
  for (const std::uint16_t a : arguments.all()) {
    for (std::size_t i = first[a]; i < first[a] + static_cast<std::size_t>(subject.arguments[a]); ++i, ++j) {
      order[j] = static_cast<std::uint16_t>(subject.alternating ? j : i);
      p[subject.alternating ? j : i] = coordinates[i];
    }
  }
  if (!subject.alternating) parity = Sign::positive;

  MovedSigns moves(subject, p.all(), order.all());
  if (const auto s = moves.sign(); s.certain()) return s.value() * parity;
  const Sign s = expanded_sign(subject.program, subject.homogeneous, p.all(), order.all(), moves.known_zero());
  if (s == Sign::zero) {
    throw Error(std::string(subject.name).append(": is zero wherever it is evaluated; no perturbation changes that"));
  }
  return s * parity;
}

#define PLUMB_INSTANTIATE(formula)                                                         \
  template Sign sign_of_zero<predicates::formula>(const Coordinates<predicates::formula>&, \
                                                  const Indices<predicates::formula>&);
PLUMB_INSTANTIATE(Orient2d)
PLUMB_INSTANTIATE(Orient3d)
PLUMB_INSTANTIATE(InCircle)
PLUMB_INSTANTIATE(InSphere)
#undef PLUMB_INSTANTIATE

}  // namespace plumb::certify::perturbation
