#include "query/penetration/way.hpp"

namespace plumb::query::parting {

Sign compare_directions(const Difference& d, const Way& v, const Way& w) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto part = [axis]<class T>(const Vec<T>& x) { return along_axis(x, axis); };
    const Sign of_v = sign_of([&]<class T>() -> T { return part(v.along<T>(d)); }),
               of_w = sign_of([&]<class T>() -> T { return part(w.along<T>(d)); });
    if (of_v != of_w) return of_v < of_w ? Sign::negative : Sign::positive;
    const Sign of_sizes = sign_of([&]<class T>() -> T {
      const Vec<T> x = v.along<T>(d), y = w.along<T>(d);
      const T p = part(x), q = part(y);
      return p * p * dot(y, y) - q * q * dot(x, x);
    });
    if (of_v != Sign::zero && of_sizes != Sign::zero) return of_v * of_sizes;
  }
  return Sign::zero;
}

}  // namespace plumb::query::parting
