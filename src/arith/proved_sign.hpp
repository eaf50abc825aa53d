// Adaptive precision: which sign has this number, for certain?  A text over number types, asked one sign at a time.
//
//   const Sign s = proved_sign([&]<class T>() { return dot(way<T>(), at<T>(i) - at<T>(j)); });
//
// For walks whose every step takes a few signs, of which most are clear: unlike certainly() no sign is asked again
// because another was not certain.
// Laws: the sign is that of the exact value: over doubles with running errors where these tell, else over integers on
// the stack, where a thousand bits do not hold them over GMP's.  Of numbers that are NaN or infinite it means nothing.
// Source: docs/proof.md.
// Cost: as a rule three times that of plain doubles.
#pragma once

#include "arith/running_error.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/short_dyadic.hpp"

namespace plumb {

/// Without doubles.
template <class Text>
[[gnu::noinline]] Sign sign_by_integers(const Text& text) {
  if (const Unsure<Sign> s = text.template operator()<ShortDyadic>().sign(); s.certain()) return s.value();
  return text.template operator()<BigDyadic>().sign();
}

template <class Text>
Sign proved_sign(const Text& text) {
  const Running near = text.template operator()<Running>();
  if (const Unsure<Sign> s = near.sign(); s.certain()) [[likely]]
    return s.value();
  return sign_by_integers(text);
}

}  // namespace plumb
