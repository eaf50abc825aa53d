// Are these swept spheres?  Their checks.
#pragma once

#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::swept {

/// Throws InvalidShape for a negative radius.
inline void check_radius(std::string_view function, std::string_view name, double radius) {
  if (radius < 0)
    throw InvalidShape(
        std::string(function).append(": ").append(name).append(".radius is negative; give zero or more"));
}

inline void check(std::string_view function, std::string_view name, const Capsule3& c) {
  const std::string a = std::string(name).append(".a"), b = std::string(name).append(".b"),
                    radius = std::string(name).append(".radius");
  figure::require_finite_parts(function, {a, b, radius}, c.a, c.b, c.radius);
  check_radius(function, name, c.radius);
}

inline void check(std::string_view function, std::string_view name, const Lozenge3& l) {
  const std::string corner = std::string(name).append(".corner"), e = std::string(name).append(".edges[0]"),
                    f = std::string(name).append(".edges[1]"), radius = std::string(name).append(".radius");
  figure::require_finite_parts(function, {corner, e, f, radius}, l.corner, l.edges[0], l.edges[1], l.radius);
  check_radius(function, name, l.radius);
}

}  // namespace plumb::figure::swept
