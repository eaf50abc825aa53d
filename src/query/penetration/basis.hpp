// Affine basis: how many dimensions has the difference of two bodies, and which of its points span it?
//
// Laws: 1 to 4 points, which are affinely independent, exactly; every difference of corners is in their affine hull.
// Those that are named are taken before others.
// Cost: a few signs a corner, until there are four.
#pragma once

#include <span>

#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

/// Up to four.
class Basis {
 public:
  void add(const Ends& e) { of_[size_++] = e; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Ends& operator[](std::size_t i) const { return of_[i]; }
  [[nodiscard]] const std::array<Ends, 4>& all() const { return of_; }

 private:
  std::array<Ends, 4> of_{};
  std::size_t size_ = 0;
};

Basis affine_basis(const Difference& d, std::span<const Ends> named);

/// Of those that are named alone.
Basis affine_basis_among(const Difference& d, std::span<const Ends> named);
/// With one more, where it is independent of them.
void extend(Basis& of, const Difference& d, const Ends& e);

}  // namespace plumb::query::parting
