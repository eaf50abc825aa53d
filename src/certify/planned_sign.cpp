// Compiles the widest integers of the classic predicates over lattice words once.
#include "plumb/certify/detail/planned_sign.hpp"

namespace plumb::certify::planned {

template Sign long_word_sign<predicates::Orient2d>(const LatticeWords<predicates::Orient2d>&);
template Sign long_word_sign<predicates::Orient3d>(const LatticeWords<predicates::Orient3d>&);
template Sign long_word_sign<predicates::InCircle>(const LatticeWords<predicates::InCircle>&);
template Sign long_word_sign<predicates::InSphere>(const LatticeWords<predicates::InSphere>&);

}  // namespace plumb::certify::planned
