// Is this the sanitized build, which is watched rather than counted, and takes fewer cases of long tests?
#pragma once

namespace plumb::battery {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace plumb::battery
