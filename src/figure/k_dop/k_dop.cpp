#include "plumb/figure/k_dop/k_dop.hpp"

#include <algorithm>

#include "certify/rounded.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "figure/k_dop/sets.hpp"

namespace plumb {
namespace {

using figure::check, figure::require_sound;
using figure::require_finite_parts;
using figure::require_finite_points;
using figure::within_doubles;

constexpr auto product2 = [](auto x, auto y, auto u, auto v) { return x * u + y * v; };
constexpr auto product3 = [](auto x, auto y, auto z, auto u, auto v, auto w) { return x * u + y * v + z * w; };

// A point's place along a direction, which of two is farther, and where a moved point is.
double along(Rounding r, const Point2& p, const Vector2& d) { return rounded_value(r, product2, p, d); }
double along(Rounding r, const Point3& p, const Vector3& d) { return rounded_value(r, product3, p, d); }

Sign farther(const Point2& p, const Point2& q, const Vector2& d) {
  return sign_of(predicates::OrderAlongDirection2d{}, p, q, d);
}
Sign farther(const Point3& p, const Point3& q, const Vector3& d) {
  return sign_of(predicates::OrderAlongDirection3d{}, p, q, d);
}

// Of p against q; the translation is in neither.
struct FartherAlongImage {
  static constexpr std::string_view name = "fit_k_dop";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    const auto column = [&](std::size_t c) {
      return p[6] * p[9 + 3 * c] + p[7] * p[10 + 3 * c] + p[8] * p[11 + 3 * c];
    };
    return (p[0] - p[3]) * column(0) + (p[1] - p[4]) * column(1) + (p[2] - p[5]) * column(2);
  }
};

template <class Point, class Vector, class Farther, class Along>
KDop<Vector> fit(std::span<const Point> points, const Directions<Vector>& directions, Farther is_farther, Along place) {
  if (points.empty()) throw InvalidShape("fit_k_dop: no points; give at least one");
  require_finite_points("fit_k_dop", "points", points);
  KDop<Vector> k_dop{directions, {}, {}};
  for (const Vector& d : directions.all()) {
    const Point *least = points.data(), *greatest = least;
    for (const Point& p : points) {
      if (is_farther(p, *greatest, d) == Sign::positive) {
        greatest = &p;
      } else if (is_farther(p, *least, d) == Sign::negative) {
        least = &p;
      }
    }
    const std::string which = std::to_string(k_dop.min.size()).append("]");
    k_dop.min.push_back(within_doubles(place(Rounding::down, *least, d), "fit_k_dop", "min[" + which));
    k_dop.max.push_back(within_doubles(place(Rounding::up, *greatest, d), "fit_k_dop", "max[" + which));
  }
  return k_dop;
}

template <class Point, class Vector>
KDop<Vector> fit(std::span<const Point> points, const Directions<Vector>& directions) {
  return fit(
      points, directions, [](const Point& p, const Point& q, const Vector& d) { return farther(p, q, d); },
      [](Rounding r, const Point& p, const Vector& d) { return along(r, p, d); });
}

template <class Vector>
KDop<Vector> merged(const KDop<Vector>& a, const KDop<Vector>& b) {
  check("merge", a, b);
  if (figure::has_empty_interval(a)) return b;
  KDop<Vector> both = a;
  if (figure::has_empty_interval(b)) return both;
  for (std::size_t i = 0; i < both.min.size(); ++i) {
    both.min[i] = std::min(a.min[i], b.min[i]);
    both.max[i] = std::max(a.max[i], b.max[i]);
  }
  return both;
}

// The sides of a slab as they are seen from p: zero on one, negative outside.
Sign least_side(const Vector2& d, double min, double max, const Point2& p) {
  return std::min(sign_of(predicates::SideOfLine{}, d, min, p), -sign_of(predicates::SideOfLine{}, d, max, p));
}
Sign least_side(const Vector3& d, double min, double max, const Point3& p) {
  return std::min(sign_of(predicates::SideOfPlane{}, d, min, p), -sign_of(predicates::SideOfPlane{}, d, max, p));
}

template <class Vector, class Point>
Location location(std::string_view function, const KDop<Vector>& k_dop, const Point& p) {
  require_sound(function, k_dop);
  require_finite_parts(function, {"p"}, p);
  Sign least = Sign::positive;
  for (std::size_t i = 0; i < k_dop.min.size() && least != Sign::negative; ++i)
    least = std::min(least, least_side(k_dop.directions.all()[i], k_dop.min[i], k_dop.max[i], p));
  return static_cast<Location>(least);
}

std::vector<Vector3> standard(std::span<const int> kinds) {
  // By the number of axes that take part; of a direction and its opposite the one whose first number is positive.
  std::vector<Vector3> all;
  for (const int kind : kinds) {
    for (const double x : {1.0, 0.0}) {
      for (const double y : {1.0, 0.0, -1.0}) {
        for (const double z : {1.0, 0.0, -1.0}) {
          const bool leads = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
          if (leads && (x != 0) + (y != 0) + (z != 0) == kind) all.push_back({x, y, z});
        }
      }
    }
  }
  return all;
}

}  // namespace

template <class Vector>
Directions<Vector>::Directions(std::vector<Vector> directions) {
  if (directions.empty()) throw InvalidShape("Directions: none; give at least one");
  require_finite_points("Directions", "directions", std::span<const Vector>(directions));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i] == Vector{})
      throw InvalidShape(
          std::string("Directions: directions[").append(std::to_string(i)).append("] is zero; leave it out"));
  }
  all_ = std::make_shared<const std::vector<Vector>>(std::move(directions));
}
template class Directions<Vector2>;
template class Directions<Vector3>;

Directions3 k_dop_directions(int k) {
  static const Directions3 axes(standard(std::array{1})), corners(standard(std::array{3})),
      axes_corners(standard(std::array{1, 3})), axes_edges(standard(std::array{1, 2})),
      all(standard(std::array{1, 3, 2}));
  switch (k) {
    case 6:
      return axes;
    case 8:
      return corners;
    case 14:
      return axes_corners;
    case 18:
      return axes_edges;
    case 26:
      return all;
    default:
      throw InvalidShape(std::string("k_dop_directions: k is ")
                             .append(std::to_string(k))
                             .append("; give 6, 8, 14, 18 or 26, or Directions3 of your own"));
  }
}

Directions2 k_dop_directions2(int k) {
  static const Directions2 axes({{1, 0}, {0, 1}}), diagonals({{1, 0}, {0, 1}, {1, 1}, {1, -1}});
  if (k == 4) return axes;
  if (k == 8) return diagonals;
  throw InvalidShape(std::string("k_dop_directions2: k is ")
                         .append(std::to_string(k))
                         .append("; give 4 or 8, or Directions2 of your own"));
}

KDop2 fit_k_dop(std::span<const Point2> points, const Directions2& directions) { return fit(points, directions); }
KDop3 fit_k_dop(std::span<const Point3> points, const Directions3& directions) { return fit(points, directions); }
KDop3 fit_k_dop(std::span<const Point3> points, int k) { return fit(points, k_dop_directions(k)); }

KDop3 fit_k_dop(std::span<const Point3> points, const Directions3& directions, PoseView pose) {
  figure::require_sound("fit_k_dop", pose);
  const figure::CertainPose moved(pose);
  const auto columns = moved.columns();
  return fit(
      points, directions,
      [&](const Point3& p, const Point3& q, const Vector3& d) {
        if (columns) return sign_of(FartherAlongImage{}, p, q, d, (*columns)[0], (*columns)[1], (*columns)[2]);
        return moved.sign([&]<class T>(const figure::PoseNumbers<T>& n) {
          return dot(arith::vec<T>(d), n.turned(arith::vec<T>(p) - arith::vec<T>(q)));
        });
      },
      [&](Rounding r, const Point3& p, const Vector3& d) {
        return moved.rounded(r, [&]<class T>(const figure::PoseNumbers<T>& n) {
          return dot(arith::vec<T>(d), n.image(arith::vec<T>(p)));
        });
      });
}

KDop2 merge(const KDop2& a, const KDop2& b) { return merged(a, b); }
KDop3 merge(const KDop3& a, const KDop3& b) { return merged(a, b); }

Location locate(const KDop2& k_dop, const Point2& p) { return location("locate", k_dop, p); }
Location locate(const KDop3& k_dop, const Point3& p) { return location("locate", k_dop, p); }
bool contains(const KDop2& k_dop, const Point2& p) { return location("contains", k_dop, p) != Location::outside; }
bool contains(const KDop3& k_dop, const Point3& p) { return location("contains", k_dop, p) != Location::outside; }

}  // namespace plumb
