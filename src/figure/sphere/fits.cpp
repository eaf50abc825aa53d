#include "plumb/figure/sphere/fits.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "arith/splitmix.hpp"
#include "figure/sphere/point_scan.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

/// The points seen from the middle of their box, in its half widths: no sum or square of theirs leaves the doubles.
class LocalPoints {
 public:
  LocalPoints(std::string_view function, std::span<const Point3> points) : function_(function), points_(points) {
    if (points.empty()) throw InvalidShape(std::string(function).append(": no points; give at least one"));
    extent_ = extent(function, points);
    middle_ = middle_of(extent_);
    const double width = half_width(extent_);
    exponent_ = width == 0 ? 0 : std::clamp(std::ilogb(width), -1022, 1022);
    scale_ = std::ldexp(1.0, -exponent_);
  }

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Point3 operator[](std::size_t i) const {
    const Point3& p = points_[i];
    return {(p.x - middle_.x) * scale_, (p.y - middle_.y) * scale_, (p.z - middle_.z) * scale_};
  }

  /// Around this local center, which is moved into the box.
  [[nodiscard]] Sphere3 around(const Point3& local) const {
    const auto at = [&](double middle, double x, double low, double high) {
      return std::clamp(middle + std::ldexp(x, exponent_), low, high) + 0.0;
    };
    const Point3 center{at(middle_.x, local.x, extent_.min.x, extent_.max.x),
                        at(middle_.y, local.y, extent_.min.y, extent_.max.y),
                        at(middle_.z, local.z, extent_.min.z, extent_.max.z)};
    PointScan<Point3> scan(points_, scale_for(half_width(extent_)));
    RestScan<SpannedSphere3> rests(points_, extent_);
    return {center, figure::within_doubles(enclosing_radius(scan, rests, points_, center), function_, "radius")};
  }

  [[nodiscard]] Sphere3 unrounded(const Sphere3& s) const {
    const auto at = [&](double middle, double x) { return middle + std::ldexp(x, exponent_); };
    return {{at(middle_.x, s.center.x), at(middle_.y, s.center.y), at(middle_.z, s.center.z)},
            std::ldexp(s.radius, exponent_)};
  }

 private:
  std::string_view function_;
  std::span<const Point3> points_;
  Extent<Point3> extent_;
  Point3 middle_{};
  int exponent_ = 0;
  double scale_ = 1;
};

double squared_distance(const Point3& a, const Point3& b) {
  const double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return x * x + y * y + z * z;
}

Sphere3 of_diameter(const Point3& a, const Point3& b) {
  return {{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, std::sqrt(squared_distance(a, b)) / 2};
}

/// The two ends of the points along some direction.
struct FarthestPair {
  std::size_t first = 0, last = 0;
  double low = HUGE_VAL, high = -HUGE_VAL;
  void take(std::size_t i, double x) {
    if (x < low) low = x, first = i;
    if (x > high) high = x, last = i;
  }
};

Sphere3 of_axes(const LocalPoints& points) {
  std::array<FarthestPair, 3> ends;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y, z] = points[i];
    ends[0].take(i, x), ends[1].take(i, y), ends[2].take(i, z);
  }
  const auto length = [&](const FarthestPair& e) { return squared_distance(points[e.first], points[e.last]); };
  const FarthestPair& e = *std::ranges::max_element(ends, {}, length);
  return of_diameter(points[e.first], points[e.last]);
}

Sphere3 of_largest_spread(const LocalPoints& points) {
  const auto n = static_cast<double>(points.size());
  double x = 0, y = 0, z = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3 p = points[i];
    x += p.x, y += p.y, z += p.z;
  }
  x /= n, y /= n, z /= n;
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3 p{points[i].x - x, points[i].y - y, points[i].z - z};
    xx += p.x * p.x, yy += p.y * p.y, zz += p.z * p.z, xy += p.x * p.y, yz += p.y * p.z, zx += p.z * p.x;
  }
  Eigen::Matrix3d covariance;
  covariance << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / n);
  const Eigen::Vector3d way = solver.eigenvectors().col(2);
  FarthestPair ends;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3 p = points[i];
    ends.take(i, p.x * way(0) + p.y * way(1) + p.z * way(2));
  }
  return of_diameter(points[ends.first], points[ends.last]);
}

/// The smallest sphere around the sphere and the point, if it is outside.
void grow(Sphere3& s, const Point3& p) {
  const double square = squared_distance(s.center, p);
  if (!(square > s.radius * s.radius)) return;
  const double distance = std::sqrt(square), radius = (s.radius + distance) / 2;
  const double way = (radius - s.radius) / distance;
  s.radius = radius;
  s.center.x += way * (p.x - s.center.x);
  s.center.y += way * (p.y - s.center.y);
  s.center.z += way * (p.z - s.center.z);
}

Sphere3 grown(Sphere3 s, const LocalPoints& points) {
  for (std::size_t i = 0; i < points.size(); ++i) grow(s, points[i]);
  return s;
}

}  // namespace
}  // namespace figure::sphere

using figure::sphere::LocalPoints;

Sphere3 fit_sphere_box(std::span<const Point3> points) {
  return LocalPoints("fit_sphere_box", points).around({0, 0, 0});
}

Sphere3 fit_sphere_ritter(std::span<const Point3> points) {
  const LocalPoints local("fit_sphere_ritter", points);
  return local.around(figure::sphere::grown(figure::sphere::of_axes(local), local).center);
}

Sphere3 fit_sphere_principal(std::span<const Point3> points) {
  const LocalPoints local("fit_sphere_principal", points);
  return local.around(figure::sphere::grown(figure::sphere::of_largest_spread(local), local).center);
}

Sphere3 fit_sphere_iterated_ritter(std::span<const Point3> points, const IteratedRitterOptions& options) {
  const LocalPoints local("fit_sphere_iterated_ritter", points);
  if (!(options.shrink >= 0 && options.shrink <= 1))
    throw InvalidShape("fit_sphere_iterated_ritter: options.shrink is not between 0 and 1; give a share of the radius");
  Sphere3 best = figure::sphere::grown(figure::sphere::of_axes(local), local), s = best;
  if (options.history != nullptr) options.history->push_back(local.unrounded(best));
  std::vector<Point3> moved(local.size());
  for (std::size_t i = 0; i < local.size(); ++i) moved[i] = local[i];
  std::uint64_t state = 1;
  for (int k = 0; k < options.iterations; ++k) {
    s.radius *= options.shrink;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      std::swap(moved[i], moved[i + splitmix64(state) % (moved.size() - i)]);
      figure::sphere::grow(s, moved[i]);
    }
    if (s.radius < best.radius) best = s;
    if (options.history != nullptr) options.history->push_back(local.unrounded(s));
  }
  return local.around(best.center);
}

}  // namespace plumb
