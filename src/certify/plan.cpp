#include "plumb/certify/plan.hpp"

#include "plumb/certify/lattice_point.hpp"

namespace plumb {

Plan::Plan(const Lattice& lattice) : lattice_(LatticeIntake(lattice).lattice()) {}

std::string_view to_string(Arithmetic a) {
  switch (a) {
    case Arithmetic::plain_double:
      return "plain double";
    case Arithmetic::one_word_factors:
      return "integers to 128 bits";
    case Arithmetic::modulo_word:
      return "bounded double, then integers modulo 2^64";
    case Arithmetic::two_words:
      return "bounded double, then integers to 128 bits";
    case Arithmetic::bounded_chain:
      return "bounded double, then the chain of stages";
    case Arithmetic::chain:
      break;
  }
  return "the chain of stages";
}

}  // namespace plumb
