// The cubic's roots by Newton's method between its turning points, and a test with tolerances at each root.
#include <algorithm>
#include <cmath>

#include "bench/rivals/ccd_rival.hpp"

namespace plumb::bench {
namespace {

constexpr double tolerance = 1e-6;

struct Vec {
  double x, y, z;
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator*(const Vec& a, double t) { return {a.x * t, a.y * t, a.z * t}; }
};
Vec vec(const Point3& p) { return {p.x, p.y, p.z}; }
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

struct Roots {
  std::array<double, 3> t{};
  int count = 0;
};

/// Of a + b t + c t^2 + d t^3, which changes its sign between from and to.
double newton(double a, double b, double c, double d, double from, double to) {
  const auto value = [&](double t) { return a + t * (b + t * (c + t * d)); };
  const bool rises = value(from) < 0;
  double t = 0.5 * (from + to);
  for (int i = 0; i < 50; ++i) {
    const double v = value(t), slope = b + t * (2 * c + t * 3 * d);
    ((v < 0) == rises ? from : to) = t;
    double next = t - v / slope;
    if (!(next > from && next < to)) next = 0.5 * (from + to);
    if (std::abs(next - t) < 1e-14) return next;
    t = next;
  }
  return t;
}

Roots solve_cubic(double a, double b, double c, double d) {
  std::array<double, 4> ends{0, 0, 0, 1};
  int count = 1;
  const double radicand = c * c - 3 * d * b;
  if (radicand > 0) {
    const double root = std::sqrt(radicand), q = -(c + std::copysign(root, c));
    double first = q / (3 * d), second = b / q;
    if (first > second) std::swap(first, second);
    if (first > 0 && first < 1) ends[static_cast<std::size_t>(count++)] = first;
    if (second > 0 && second < 1) ends[static_cast<std::size_t>(count++)] = second;
  }
  ends[static_cast<std::size_t>(count)] = 1;
  const auto value = [&](double t) { return a + t * (b + t * (c + t * d)); };
  Roots roots;
  for (int i = 0; i < count; ++i) {
    const double from = ends[static_cast<std::size_t>(i)], to = ends[static_cast<std::size_t>(i) + 1];
    const double v = value(from), w = value(to);
    if ((v <= 0 && w >= 0) || (v >= 0 && w <= 0))
      roots.t[static_cast<std::size_t>(roots.count++)] = newton(a, b, c, d, from, to);
  }
  return roots;
}

bool touches(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const Vec n = cross(b - a, c - a);
  const double square = dot(n, n);
  if (square == 0) return false;
  const double u = dot(cross(b - p, c - p), n) / square, v = dot(cross(c - p, a - p), n) / square;
  const double distance = std::abs(dot(p - a, n)) / std::sqrt(square);
  return distance < tolerance && u > -tolerance && v > -tolerance && 1 - u - v > -tolerance;
}

bool crosses(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
  const Vec e = b - a, f = d - c, w = c - a, n = cross(e, f);
  const double square = dot(n, n);
  if (square == 0) return false;
  const double u = dot(cross(w, f), n) / square, v = dot(cross(w, e), n) / square;
  const double distance = std::abs(dot(w, n)) / std::sqrt(square);
  const auto within = [](double x) { return x > -tolerance && x < 1 + tolerance; };
  return distance < tolerance && within(u) && within(v);
}

}  // namespace

bool plain_contact(bool vertex_face, const std::array<Point3, 4>& at_0, const std::array<Point3, 4>& at_1) {
  std::array<Vec, 4> p{}, velocity{};
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = vec(at_0[i]);
    velocity[i] = vec(at_1[i]) - p[i];
  }
  const Vec x1 = p[1] - p[0], x2 = p[2] - p[0], x3 = p[3] - p[0];
  const Vec v1 = velocity[1] - velocity[0], v2 = velocity[2] - velocity[0], v3 = velocity[3] - velocity[0];
  const double a = dot(x1, cross(x2, x3));
  const double b = dot(v1, cross(x2, x3)) + dot(x1, cross(v2, x3)) + dot(x1, cross(x2, v3));
  const double c = dot(x1, cross(v2, v3)) + dot(v1, cross(x2, v3)) + dot(v1, cross(v2, x3));
  const double d = dot(v1, cross(v2, v3));
  const Roots roots = solve_cubic(a, b, c, d);
  for (int i = 0; i < roots.count; ++i) {
    const double t = roots.t[static_cast<std::size_t>(i)];
    std::array<Vec, 4> q{};
    for (std::size_t k = 0; k < 4; ++k) q[k] = p[k] + velocity[k] * t;
    if (vertex_face ? touches(q[0], q[1], q[2], q[3]) : crosses(q[0], q[1], q[2], q[3])) return true;
  }
  return false;
}

}  // namespace plumb::bench
