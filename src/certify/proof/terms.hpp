// Which terms does a formula add up, and how is each of them computed?
//
// Expanded, a formula is a sum of terms, each a product of leaves: differences or sums of two coordinates, and
// coordinates by themselves.  Every number of its tape is kept as the parts that go to different terms.  A rounding
// multiplies all parts of a number by the same 1 + e; here each part has an e of its own, which supposes less.
// Laws: (1) the signed sum of the terms is the formula, over any numbers; (2) terms of one shape are computed alike,
// and differ in nothing but the names of leaves and roundings.
// Source: docs/proof.md, "What a machine has checked".
// Cost: grows with the number of terms times that of operations.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumb/certify/detail/tape.hpp"

namespace plumb::certify::terms {

/// A difference or sum of two coordinates: where a formula's error begins.  Twice a coordinate has none.
inline bool is_leaf(const certify::tape::Program& program, const certify::tape::Instruction& i) {
  return i.operation != '*' && i.left < program.arity && i.right < program.arity && !i.doubles();
}

enum class Step { coordinate, leaf, product, sum, difference, rounded };

/// Operands are nodes.  A coordinate has its number on the left, a leaf that of its instruction; what is rounded stands
/// on the left.
struct Node {
  Step step;
  std::size_t left, right;
};

struct Term {
  std::size_t node;  // before the formula's last rounding
  double count;      // how many equal products it adds up
  bool negative;
};

struct Expanded {
  std::vector<Node> nodes;  // operands before results
  std::vector<Term> terms;
};

/// Throws Error when there are 2^16 different terms or more, on the way or at the end.
Expanded expand(const certify::tape::Program& program);

/// One text for all nodes that differ in names only.
std::string shape(const Expanded& expanded, std::size_t node);

}  // namespace plumb::certify::terms
