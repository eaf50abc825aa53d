// What the package for JavaScript calls: the classic functions, by numbers instead of arrays, for numbers are all that
// passes into WebAssembly without a copy.
#include "plumb/classic.h"

namespace {

template <int dimension, auto function, class... Numbers>
double asked(Numbers... numbers) {
  const double p[] = {numbers...};
  if constexpr (sizeof...(numbers) == 3 * dimension) {
    return function(p, p + dimension, p + 2 * dimension);
  } else if constexpr (sizeof...(numbers) == 4 * dimension) {
    return function(p, p + dimension, p + 2 * dimension, p + 3 * dimension);
  } else {
    static_assert(sizeof...(numbers) == 5 * dimension);
    return function(p, p + dimension, p + 2 * dimension, p + 3 * dimension, p + 4 * dimension);
  }
}

}  // namespace

// Each as it is, as near as a double can be, and in plain floating point.
#define PLUMB_JS(name, dimension, parameters, numbers)                                                             \
  extern "C" [[gnu::visibility("default")]] double js_##name parameters { return asked<dimension, name> numbers; } \
  extern "C" [[gnu::visibility("default")]] double js_##name##exact parameters {                                   \
    return asked<dimension, name##exact> numbers;                                                                  \
  }                                                                                                                \
  extern "C" [[gnu::visibility("default")]] double js_##name##fast parameters {                                    \
    return asked<dimension, name##fast> numbers;                                                                   \
  }

PLUMB_JS(orient2d, 2, (double ax, double ay, double bx, double by, double cx, double cy), (ax, ay, bx, by, cx, cy))
PLUMB_JS(incircle, 2, (double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy),
         (ax, ay, bx, by, cx, cy, dx, dy))
PLUMB_JS(orient3d, 3,
         (double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz, double dx,
          double dy, double dz),
         (ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz))
PLUMB_JS(insphere, 3,
         (double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz, double dx,
          double dy, double dz, double ex, double ey, double ez),
         (ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez))
#undef PLUMB_JS
