// A coordinate as it is given is no formula: there is no operation whose result the last stage could give.
// refused: returns a coordinate as it is given
#include <array>
#include <string_view>

#include "plumb/certify/decide.hpp"

struct Formula {
  static constexpr std::string_view name = "made up";
  static constexpr int points = 1, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
#ifdef MENDED
    return p[0] - p[1];
#else
    return p[0];
#endif
  }
};

plumb::Sign sign(const std::array<double, 3>& p) { return plumb::decide<Formula>(p); }
