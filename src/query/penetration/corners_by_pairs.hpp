// What are the corners of a core, in pairs of doubles whose products' errors are one instruction?
//
// Of every other number type they are those of query/separation/corners.hpp.  Of these they are compiled once, for
// processors that multiply and add at once, and called: their text is long, for it knows every pose.
// Laws: those of arith/twofold.hpp.
// Source: RTCD 4.4.
// Cost: that of the corners.
#pragma once

#include "arith/twofold.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query::parting {

using arith::Vec;

using FusedPair = Twofold<true>;

Vec<FusedPair> corner_by_pairs(const CoreCorners& c, std::size_t i);
Vec<FusedPair> edge_by_pairs(const CoreCorners& c, std::size_t k);
Vec<FusedPair> twice_middle_by_pairs(const CoreCorners& c);

template <class T>
Vec<T> corner_of(const CoreCorners& c, std::size_t i) {
  if constexpr (std::is_same_v<T, FusedPair>) {
    return corner_by_pairs(c, i);
  } else {
    return c.at<T>(i);
  }
}
template <class T>
Vec<T> edge_of(const CoreCorners& c, std::size_t k) {
  if constexpr (std::is_same_v<T, FusedPair>) {
    return edge_by_pairs(c, k);
  } else {
    return c.edge<T>(k);
  }
}
template <class T>
Vec<T> twice_middle_of(const CoreCorners& c) {
  if constexpr (std::is_same_v<T, FusedPair>) {
    return twice_middle_by_pairs(c);
  } else {
    return c.twice_middle<T>();
  }
}

}  // namespace plumb::query::parting
