// Any text is a case, no case, or refused with an Error that says why; a case comes back unchanged when written.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "plumb/arith/error.hpp"

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "does not hold: " << what << std::endl;
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto c = plumb::parse_case_line(text);
    if (!c) return 0;
    const plumb::CatalogEntry* e = plumb::find_predicate(c->predicate);
    require(e != nullptr && e->arity() == c->coordinates.size(), "a case fits its predicate");
    for (const double x : c->coordinates) require(std::isfinite(x), "coordinates are finite");
    const auto back = plumb::parse_case_line(plumb::to_string(*c));
    require(back == c, "a case comes back");
    for (std::size_t i = 0; i < c->coordinates.size(); ++i) {
      require(std::signbit(back->coordinates[i]) == std::signbit(c->coordinates[i]), "zeros keep their sign");
    }
  } catch (const plumb::Error& error) {
    require(std::string_view(error.what()).size() > 10, "a refusal says why");
  }
  return 0;
}
