// An area plus a length has no sign that scaling keeps: a formula must be homogeneous.
// refused: plumb: a formula adds terms of unequal degree
// lines: 12
#include <array>
#include <string_view>

#include "plumb/certify/decide.hpp"

struct Formula {
  static constexpr std::string_view name = "made up";
  static constexpr int points = 1, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
#ifdef MENDED
    return p[0] * p[1] - p[1] * p[2];
#else
    return p[0] * p[1] - p[2];
#endif
  }
};

plumb::Sign sign(const std::array<double, 3>& p) { return plumb::decide<Formula>(p); }
