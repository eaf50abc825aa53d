// A formula says what it is called and what it takes.
// refused: plumb: a formula has a `name`
// lines: 12
#include <array>
#include <string_view>

#include "plumb/certify/decide.hpp"

struct Determinant {
#ifdef MENDED
  static constexpr std::string_view name = "determinant";
#endif
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return p[0] * p[3] - p[1] * p[2];
  }
};

plumb::Sign sign(const std::array<double, 4>& p) { return plumb::decide<Determinant>(p); }
