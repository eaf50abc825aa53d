// Is this run watched, that is, are the libraries the sanitized ones?  Such a run takes fewer cases of long tests.
//
// Law: the only place that knows.  It is known when a test runs, not when it is compiled: the objects of the ordinary
// build are linked with sanitized libraries as well (PLUMB_TESTS_FROM of tests/CMakeLists.txt).  A processor that is
// emulated (tests/elsewhere) is as slow, and counts as watched.
#pragma once

extern "C" void __asan_init() __attribute__((weak));

namespace plumb::battery {

/// As a bool: asked anew each time, so that no order of what is made before main matters.
struct IsSanitized {
#ifdef PLUMB_EMULATED
  operator bool() const { return true; }
#else
  operator bool() const { return &__asan_init != nullptr; }
#endif
};
inline constexpr IsSanitized sanitized;

/// May a test demand what only many random cases reach?
struct ReachesRare {
  operator bool() const { return !sanitized; }
};
inline constexpr ReachesRare reaches_rare;

/// So many of a long test's cases as fit the sanitized build, where each takes ten times as long: a tenth of them.
template <class Number>
Number fitting(Number cases) {
  return sanitized ? cases / 10 : cases;
}

}  // namespace plumb::battery
