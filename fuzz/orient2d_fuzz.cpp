#include <plumb/predicates/orient.hpp>

#include "predicate_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return plumb::fuzz::run<plumb::predicates::Orient2d>({data, size});
}
