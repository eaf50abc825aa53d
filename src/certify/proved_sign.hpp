// Adaptive precision: which sign has this number, for certain?  A text over number types, asked one sign at a time.
//
//   const Sign s = proved_sign([&]<class T>() { return dot(way<T>(), at<T>(i) - at<T>(j)); });
//
// For walks whose every step takes a few signs, of which most are clear: each is a question by itself, so that none is
// asked again because another was not certain.
// Laws: the sign is that of the exact value: over doubles with running errors where these tell, else over integers on
// the stack, where a thousand bits do not hold them over GMP's.  Of numbers that are NaN or infinite it means nothing.
// Source: docs/proof.md.
// Cost: as a rule three times that of plain doubles.
#pragma once

#include "arith/running_error.hpp"
#include "certify/carried_errors.hpp"
#include "plumb/arith/short_dyadic.hpp"

namespace plumb {

template <class... T>
using SignWorlds = Worlds<Carrying<T>...>;

template <class List, class Text>
Sign sign_in(const Text& text) {
  return certainly<List>([&]<class T>(Carrying<T>& ask) { return ask(text.template operator()<T>()); });
}
/// Without doubles.
template <class Text>
[[gnu::noinline]] Sign sign_by_integers(const Text& text) {
  return sign_in<SignWorlds<ShortDyadic, BigDyadic>>(text);
}

template <class Text>
Sign proved_sign(const Text& text) {
  return sign_in<SignWorlds<Running, ShortDyadic, BigDyadic>>(text);
}

}  // namespace plumb
