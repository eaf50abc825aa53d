// Determinants of small matrices by cofactor expansion, over any number type with + - *.
//
// Laws: swapping two rows or columns flips the sign; homogeneous of degree n in the entries.
// Rows are given one after another.  Source: RTCD 3.1.3.
// Cost: det2 2 products, det3 9 products.
#pragma once

namespace plumb::predicates {

template <class T>
constexpr auto det2(const T& a, const T& b,  //
                    const T& c, const T& d) {
  return a * d - b * c;
}

template <class T>
constexpr auto det3(const T& a, const T& b, const T& c,  //
                    const T& d, const T& e, const T& f,  //
                    const T& g, const T& h, const T& i) {
  return a * det2(e, f, h, i) - b * det2(d, f, g, i) + c * det2(d, e, g, h);
}

}  // namespace plumb::predicates
