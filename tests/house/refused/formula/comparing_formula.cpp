// A formula that branches on its values is no polynomial: the numbers that it runs over do not compare.
// refused: plumb: a formula does not compare
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
    return p[0] - p[1];
#else
    if (p[0] < p[1]) return p[0] - p[1];
    return p[1] - p[0];
#endif
  }
};

plumb::Sign sign(const std::array<double, 2>& p) { return plumb::decide<Formula>(p); }
