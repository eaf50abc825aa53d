// Can a machine check a filter's error bound?  Writes the bound of a formula as a claim for Gappa, from its tape.
//
// Two claims, in both of which c is the very constant that the code compares with, and every difference or sum of two
// coordinates is any real number, of which the formula sees a rounded one:
//
// ProofScale::unit, what IEEE doubles do.  Every operation but x + x rounds to the nearest double, ties to even,
// subnormals included.  Rounded differences, and coordinates that the formula takes by themselves, are at most 1 in
// magnitude, so that the magnitude of its m terms is m.  Then, before its last rounding, the computed value differs
// from the exact one by at most c m; and where the exact value is not positive (negative), the computed one is at most
// c m (at least -c m).
//
// ProofScale::every, what no change of scale can change.  Every operation but x + x errs by a factor of 1 + e,
// |e| <= 2^-53, which is all that is known of it.  Term by term (the products of differences that the formula adds up)
// the computed value differs from the exact one by at most c (1 - (n + 2) 2^-51) times the term's magnitude, with n
// operations: what c leaves over pays for a magnitude and a threshold that are rounded as well.
//
// Laws: a script says nothing of how its claim is proved, so that a proof made from it rests on no axiom of ours;
// `gappa FILE` exits with 0 exactly when it found the proof.  What the claims mean for the filters: docs/proof.md.
// Source: Daumas, Melquiond, "Certification of bounds on expressions involving rounded operators", 2010.
// Cost: microseconds for a script; Gappa takes about a second for a formula of 80 operations.
#pragma once

#include <string>
#include <string_view>

#include "plumb/certify/detail/tape.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb {

enum class ProofScale { unit, every };

/// The script that claims the bound of a formula whose filter uses this constant.  Throws Error for a tape without
/// operations, a constant that is not positive and finite, or 2^32 terms and more (for ProofScale::every 2^16).
std::string proof_script(std::string_view name, const certify::tape::Program& program, double constant,
                         ProofScale scale = ProofScale::unit);

template <Formula F>
std::string proof_script(ProofScale scale = ProofScale::unit) {
  return proof_script(F::name, certify::tape::program<F>(), filter_constant<F>(), scale);
}

/// The sum of the magnitudes of a formula's terms when every difference, and every coordinate taken by itself, has the
/// magnitude 1: the number of its terms, each counted as often as it occurs.  Throws Error from 2^32 on.
double count_terms(const certify::tape::Program& program);

}  // namespace plumb
