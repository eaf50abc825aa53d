// Is this the sanitized build, which is watched rather than counted, and takes fewer cases of long tests?
//
// Law: the only place that knows which build it is.
#pragma once

namespace plumb::battery {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

/// May a test demand what only many random cases reach?
inline constexpr bool reaches_rare = !sanitized;

/// So many of a long test's cases as fit the sanitized build, where each takes ten times as long: a tenth of them.
template <class Number>
constexpr Number fitting(Number cases) {
  return sanitized ? cases / 10 : cases;
}

}  // namespace plumb::battery
