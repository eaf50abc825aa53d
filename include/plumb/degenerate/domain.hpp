// Which numbers is a function made for?  Bounds on the coordinates of the cases that it is asked.
//
// A case that a generator makes is brought into the domain: scaled by a power of two as a whole, which changes nothing
// that figures are to one another, then each number to the grid and to its bits where it still is not of them.  So what
// is exactly degenerate stays so where the domain has room for it, and is off by a unit of the grid where it has not.
// Bounds are on coordinates, components of directions and lengths; axes of frames, counts and indices have none.
// Laws: (1) what `fitted` returns is in the domain, and a case without a flaw; (2) a case that is in the domain stays
// as it is.
// Source: RTCD 11, 11.2.1.
// Cost: linear in the numbers, and the exact answer where degenerate cases are not wanted.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

struct Domain {
  double largest = std::numeric_limits<double>::max();  // magnitude
  double smallest = 0;                                  // magnitude of what is not 0
  double grid = 0;                                      // a power of two that all are multiples of; 0: none
  int bits = std::numeric_limits<double>::digits;       // of a mantissa, at most; 24: those of a float
  bool degenerate = true;  // false: neither cases with degenerate figures nor those that are special to the kind
  friend bool operator==(const Domain&, const Domain&) = default;
};

/// What makes no sense of a domain: one of its members, by name, and why.
struct DomainFlaw {
  std::string_view member;
  std::string why;
};
/// Bounds that are none, a grid that is no power of two, and where no number but 0 is in the domain.
std::optional<DomainFlaw> flaw_of(const Domain& domain);
/// Throws Error where there is one.
void require_sense(const Domain& domain);

bool is_in(const Domain& domain, const Kind& kind, std::span<const double> numbers);

/// The case, brought into the domain; nothing where that spoils it.
std::optional<Numbers> fitted(const Domain& domain, const Kind& kind, Numbers numbers);

}  // namespace plumb::degenerate
