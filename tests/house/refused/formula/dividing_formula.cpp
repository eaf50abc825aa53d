// A quotient is no polynomial: the numbers that a formula runs over do not divide.
// refused: plumb: a formula does not divide
// lines: 12
#include <array>
#include <string_view>

#include "plumb/certify/decide.hpp"

struct Formula {
  static constexpr std::string_view name = "made up";
  static constexpr int points = 2, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 2>& p) const {
#ifdef MENDED
    return p[0] * p[1];
#else
    return p[0] / p[1];
#endif
  }
};

plumb::Sign sign(const std::array<double, 2>& p) { return plumb::decide<Formula>(p); }
