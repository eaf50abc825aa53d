#include <cmath>

#include "arith/root_bounds.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/measures/measures.hpp"

namespace plumb {
namespace {

using arith::exact_sum::nearest;
using arith::exact_sum::nearly_nearest;
using figure::signed_sums::cross;
using figure::signed_sums::dot;
using figure::signed_sums::vector;

/// For radicands: the squared length of the segment from a to b.
template <class Point>
auto squared_length(const Point& a, const Point& b) {
  return [&a, &b](const auto& number) {
    const auto x = number(b.x) - number(a.x), y = number(b.y) - number(a.y);
    if constexpr (requires { a.z; }) {
      const auto z = number(b.z) - number(a.z);
      return x * x + y * y + z * z;
    } else {
      return x * x + y * y;
    }
  };
}

auto squared_length(const Vector3& v) {
  return [&v](const auto& number) {
    const auto x = vector(number, v);
    return dot(x, x);
  };
}

auto squared_cross(const Vector3& a, const Vector3& b) {
  return [&a, &b](const auto& number) {
    const auto n = cross(vector(number, a), vector(number, b));
    return dot(n, n);
  };
}

/// What `number` makes of the widths of a box: `from` to `to`, in each axis.
auto widths(const Aabb3& box) {
  return [&box](const auto& number) { return vector(number, box.max) - vector(number, box.min); };
}
auto widths(const AabbWidths3& box) {
  return [&box](const auto& number) {
    return vector(number, Vector3{std::fabs(box.widths.x), std::fabs(box.widths.y), std::fabs(box.widths.z)});
  };
}
auto widths(const AabbCenter3& box) {
  return [&box](const auto& number) {
    return number(2.0) * vector(number, Vector3{std::fabs(box.half.x), std::fabs(box.half.y), std::fabs(box.half.z)});
  };
}

template <class Widths>
double box_volume(const Widths& of) {
  return nearest([&](const auto& number) {
    const auto w = of(number);
    return w.x * w.y * w.z;
  });
}

template <class Widths>
double box_surface(const Widths& of) {
  return nearest([&](const auto& number) {
    const auto w = of(number);
    return number(2.0) * (w.x * w.y + w.y * w.z + w.z * w.x);
  });
}

double ball_volume(double radius) {
  return nearly_nearest(
      [&](const auto& number, const auto& pi) {
        const auto r = number(radius);
        return number(4.0) * (pi * (r * r * r));
      },
      3);
}

double ball_surface(double radius) {
  return nearly_nearest(
      [&](const auto& number, const auto& pi) {
        const auto r = number(radius);
        return number(4.0) * (pi * (r * r));
      },
      1);
}

}  // namespace

double area(const Circle2& c) {
  figure::require_sound("area", c);
  return nearly_nearest(
      [&](const auto& number, const auto& pi) {
        const auto r = number(c.radius);
        return pi * (r * r);
      },
      1);
}

double area(const Capsule2& c) {
  figure::require_sound("area", c);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& length) {
        const auto r = number(c.radius);
        return r * (pi * r + number(2.0) * length);
      },
      1, squared_length(c.a, c.b));
}

double area(const Aabb2& b) {
  figure::require_sound("area", b);
  if (is_empty(b)) return 0;
  return nearest(
      [&](const auto& number) { return (number(b.max.x) - number(b.min.x)) * (number(b.max.y) - number(b.min.y)); });
}

double area(const Obb2& b) {
  figure::require_sound("area", b);
  return std::fabs(nearest([&](const auto& number) {
    const auto [u, v] = b.axes;
    return number(4.0) * (number(b.half.x) * number(b.half.y)) *
           (number(u.x) * number(v.y) - number(u.y) * number(v.x));
  }));
}

double area(const Rectangle3& r) {
  figure::require_sound("area", r);
  return arith::exact_sum::nearest_root([&](const auto& number) {
    const auto n = number(4.0) * (number(r.half.x) * number(r.half.y)) *
                   cross(vector(number, r.axes[0]), vector(number, r.axes[1]));
    return dot(n, n);
  });
}

double volume(const Aabb3& box) {
  figure::require_sound("volume", box);
  return is_empty(box) ? 0 : box_volume(widths(box));
}
double volume(const AabbWidths3& box) {
  figure::require_sound("volume", box);
  return box_volume(widths(box));
}
double volume(const AabbCenter3& box) {
  figure::require_sound("volume", box);
  return box_volume(widths(box));
}

double surface_area(const Aabb3& box) {
  figure::require_sound("surface_area", box);
  return is_empty(box) ? 0 : box_surface(widths(box));
}
double surface_area(const AabbWidths3& box) {
  figure::require_sound("surface_area", box);
  return box_surface(widths(box));
}
double surface_area(const AabbCenter3& box) {
  figure::require_sound("surface_area", box);
  return box_surface(widths(box));
}

double volume(const Sphere3& sphere) {
  figure::require_sound("volume", sphere);
  return ball_volume(sphere.radius);
}

double surface_area(const Sphere3& sphere) {
  figure::require_sound("surface_area", sphere);
  return ball_surface(sphere.radius);
}

double volume(const Capsule3& c) {
  figure::require_sound("volume", c);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& length) {
        const auto r = number(c.radius);
        return pi * (r * r) * (number(3.0) * length + number(4.0) * r);
      },
      3, squared_length(c.a, c.b));
}

double surface_area(const Capsule3& c) {
  figure::require_sound("surface_area", c);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& length) {
        const auto r = number(c.radius);
        return number(2.0) * (pi * r) * (length + number(2.0) * r);
      },
      1, squared_length(c.a, c.b));
}

// What is within r of a flat convex set of area A and perimeter P: 2 A r + pi P r^2 / 2 + 4 pi r^3 / 3; its surface is
// the derivative.
double volume(const Lozenge3& l) {
  figure::require_sound("volume", l);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& u, const auto& v, const auto& flat) {
        const auto r = number(l.radius);
        return r * (number(6.0) * flat + pi * r * (number(3.0) * (u + v) + number(4.0) * r));
      },
      3, squared_length(l.edges[0]), squared_length(l.edges[1]), squared_cross(l.edges[0], l.edges[1]));
}

double surface_area(const Lozenge3& l) {
  figure::require_sound("surface_area", l);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& u, const auto& v, const auto& flat) {
        const auto r = number(l.radius);
        return number(2.0) * flat + pi * r * (number(2.0) * (u + v) + number(4.0) * r);
      },
      1, squared_length(l.edges[0]), squared_length(l.edges[1]), squared_cross(l.edges[0], l.edges[1]));
}

double volume(const Cylinder3& c) {
  figure::require_sound("volume", c);
  if (c.a == c.b) return ball_volume(c.radius);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& length) {
        const auto r = number(c.radius);
        return pi * (r * r) * length;
      },
      1, squared_length(c.a, c.b));
}

double surface_area(const Cylinder3& c) {
  figure::require_sound("surface_area", c);
  if (c.a == c.b) return ball_surface(c.radius);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& length) {
        const auto r = number(c.radius);
        return number(2.0) * (pi * r) * (length + r);
      },
      1, squared_length(c.a, c.b));
}

double volume(const Cone3& c) {
  figure::require_sound("volume", c);
  if (c.apex == c.base) return ball_volume(c.radius);
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& length) {
        const auto r = number(c.radius);
        return pi * (r * r) * length;
      },
      3, squared_length(c.apex, c.base));
}

double surface_area(const Cone3& c) {
  figure::require_sound("surface_area", c);
  if (c.apex == c.base) return ball_surface(c.radius);
  const auto squared_slant = [&c](const auto& number) {
    return squared_length(c.apex, c.base)(number) + number(c.radius) * number(c.radius);
  };
  return nearly_nearest(
      [&](const auto& number, const auto& pi, const auto& slant) {
        const auto r = number(c.radius);
        return pi * r * (r + slant);
      },
      1, squared_slant);
}

double volume(const Ellipsoid3& e) {
  figure::require_sound("volume", e);
  const auto parallelepiped = [&e](const auto& number) {
    const auto spanned = dot(vector(number, e.axes[0]), cross(vector(number, e.axes[1]), vector(number, e.axes[2])));
    return number(e.half.x) * number(e.half.y) * number(e.half.z) * spanned;
  };
  const Sign sign = arith::exact_sum::sign(parallelepiped);
  return nearly_nearest(
      [&](const auto& number, const auto& pi) {
        return number(sign == Sign::negative ? -4.0 : 4.0) * (pi * parallelepiped(number));
      },
      3);
}

}  // namespace plumb
