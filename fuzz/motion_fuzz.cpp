// Is the answer of the quick stages that of the exact one, whatever moves, and does it keep its laws?
//
// A separation of zero goes through every stage; first_contact_time and a reversed, permuted motion go other ways.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>

#include "lab/trial/moving_cases.hpp"

namespace plumb::fuzz {
namespace {

using lab::moving_cases::Case;

/// From the bytes: a kind of hard motion, or coordinates as they stand.
Case case_from(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  const std::size_t form = bytes[0] % (lab::moving_cases::kinds.size() + 1);
  bytes = bytes.subspan(1);
  Entropy entropy = Entropy::from_bytes(bytes);
  if (form < lab::moving_cases::kinds.size()) return lab::moving_cases::make(lab::moving_cases::kinds[form], entropy);
  Case c;
  c.vertex_face = !bytes.empty() && bytes[0] % 2 == 0;
  std::array<double, 24> x{};
  if (bytes.size() > 1) std::memcpy(x.data(), bytes.data() + 1, std::min(bytes.size() - 1, sizeof x));
  for (double& y : x) y = y - y == 0 ? y : 0;
  for (std::size_t i = 0; i < 8; ++i) (i < 4 ? c.at_0 : c.at_1)[i % 4] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  return c;
}

bool meets(const Case& c) {
  return lab::moving_cases::of_figures(c, [](const auto& a, const auto& b) { return intersects(a, b); });
}

[[noreturn]] void fail(const char* what, const Case& c) {
  std::cerr << what << (c.vertex_face ? ", vertex and triangle" : ", two edges") << std::hexfloat;
  for (const auto& points : {c.at_0, c.at_1}) {
    for (const Point3& p : points) std::cerr << "\n  " << p.x << ' ' << p.y << ' ' << p.z;
  }
  std::cerr << std::endl;
  std::abort();
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  const fuzz::Case c = fuzz::case_from({data, size});
  const bool answer = fuzz::meets(c);
  fuzz::Case reversed = c, permuted = c;
  std::swap(reversed.at_0, reversed.at_1);
  for (auto* points : {&permuted.at_0, &permuted.at_1}) std::swap((*points)[2], (*points)[3]);
  if (fuzz::meets(reversed) != answer) fuzz::fail("reversed in time, it differs", c);
  if (fuzz::meets(permuted) != answer) fuzz::fail("with two vertices swapped, it differs", c);
  lab::moving_cases::of_figures(c, [&](const auto& a, const auto& b) {
    const auto contact = first_contact(a, b);
    const auto time = first_contact_time(a, b);
    if (contact.has_value() != answer || time.has_value() != answer) fuzz::fail("whether and when differ", c);
    if (time && time->rounded(Rounding::down) != contact->time) fuzz::fail("the times differ", c);
  });
  return 0;
}
