// Every form says, for each axis, two ends that are sums of two doubles; each is made from these.
#include "plumb/figure/aabb/box_forms.hpp"

#include <array>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

using figure::within_doubles;

/// From low + below to high + above.
struct AxisDoubles {
  double low, below, high, above;
};
using BoxDoubles = std::array<AxisDoubles, 3>;

constexpr std::string_view axis_names = "xyz";

BoxDoubles ends_of(std::string_view function, const Aabb3& box) {
  figure::require_sound(function, box);
  const auto min = coordinates(box.min), max = coordinates(box.max);
  BoxDoubles ends{};
  for (std::size_t i = 0; i < 3; ++i) ends[i] = {min[i], 0, max[i], 0};
  return ends;
}
BoxDoubles ends_of(std::string_view function, const AabbWidths3& box) {
  figure::require_sound(function, box);
  const auto min = coordinates(box.min), widths = coordinates(box.widths);
  BoxDoubles ends{};
  for (std::size_t i = 0; i < 3; ++i) ends[i] = {min[i], 0, min[i], magnitude_of(widths[i])};
  return ends;
}
BoxDoubles ends_of(std::string_view function, const AabbCenter3& box) {
  figure::require_sound(function, box);
  const auto center = coordinates(box.center), half = coordinates(box.half);
  BoxDoubles ends{};
  for (std::size_t i = 0; i < 3; ++i) ends[i] = {center[i], -magnitude_of(half[i]), center[i], magnitude_of(half[i])};
  return ends;
}

void require_not_empty(std::string_view function, const Aabb3& box) {
  const auto min = coordinates(box.min), max = coordinates(box.max);
  for (std::size_t i = 0; i < 3; ++i) {
    if (min[i] <= max[i]) continue;
    throw InvalidShape(std::string(function)
                           .append(": box.min.")
                           .append(1, axis_names[i])
                           .append(" is above box.max; an empty box has no such form, give one that is not empty"));
  }
}

std::string part(std::string_view name, std::size_t axis) { return std::string(name).append(1, axis_names[axis]); }

double rounded_sum(Rounding rounding, double a, double b, double c) {
  return rounded_value(
      rounding, [](auto x, auto y, auto z) { return (x + y) + z; }, a, b, c);
}

Aabb3 min_max(std::string_view function, const BoxDoubles& ends) {
  std::array<double, 3> min{}, max{};
  for (std::size_t i = 0; i < 3; ++i) {
    min[i] = within_doubles(rounded_sum(Rounding::down, ends[i].low, ends[i].below, 0), function, part("min.", i));
    max[i] = within_doubles(rounded_sum(Rounding::up, ends[i].high, ends[i].above, 0), function, part("max.", i));
  }
  return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}};
}

AabbWidths3 min_widths(std::string_view function, const BoxDoubles& ends) {
  std::array<double, 3> min{}, widths{};
  for (std::size_t i = 0; i < 3; ++i) {
    min[i] = within_doubles(rounded_sum(Rounding::down, ends[i].low, ends[i].below, 0), function, part("min.", i));
    widths[i] =
        within_doubles(rounded_sum(Rounding::up, ends[i].high, ends[i].above, -min[i]), function, part("widths.", i));
  }
  return {{min[0], min[1], min[2]}, {widths[0], widths[1], widths[2]}};
}

AabbCenter3 center_half(std::string_view function, const BoxDoubles& ends) {
  std::array<double, 3> center{}, half{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [low, below, high, above] = ends[i];
    center[i] = within_doubles(
        rounded_value(
            Rounding::nearest, [](auto a, auto b, auto c, auto d, auto by) { return ((a + b) + (c + d)) * by; }, low,
            below, high, above, 0.5),
        function, part("center.", i));
    const double down = rounded_sum(Rounding::up, center[i], -low, -below),
                 up = rounded_sum(Rounding::up, high, above, -center[i]);
    half[i] = within_doubles(down > up ? down : up, function, part("half.", i));
  }
  return {{center[0], center[1], center[2]}, {half[0], half[1], half[2]}};
}

}  // namespace

Aabb3 to_aabb(const Aabb3& box) {
  static_cast<void>(ends_of("to_aabb", box));  // its numbers are looked at
  return box;
}
Aabb3 to_aabb(const AabbWidths3& box) { return min_max("to_aabb", ends_of("to_aabb", box)); }
Aabb3 to_aabb(const AabbCenter3& box) { return min_max("to_aabb", ends_of("to_aabb", box)); }

AabbWidths3 to_aabb_widths(const Aabb3& box) {
  const BoxDoubles ends = ends_of("to_aabb_widths", box);
  require_not_empty("to_aabb_widths", box);
  return min_widths("to_aabb_widths", ends);
}
AabbWidths3 to_aabb_widths(const AabbWidths3& box) {
  return min_widths("to_aabb_widths", ends_of("to_aabb_widths", box));
}
AabbWidths3 to_aabb_widths(const AabbCenter3& box) {
  return min_widths("to_aabb_widths", ends_of("to_aabb_widths", box));
}

AabbCenter3 to_aabb_center(const Aabb3& box) {
  const BoxDoubles ends = ends_of("to_aabb_center", box);
  require_not_empty("to_aabb_center", box);
  return center_half("to_aabb_center", ends);
}
AabbCenter3 to_aabb_center(const AabbWidths3& box) {
  return center_half("to_aabb_center", ends_of("to_aabb_center", box));
}
AabbCenter3 to_aabb_center(const AabbCenter3& box) {
  return center_half("to_aabb_center", ends_of("to_aabb_center", box));
}

}  // namespace plumb
