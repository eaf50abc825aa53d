// Which pairs of convex bodies are hard?  Hulls that share a vertex, an edge or a face, that are an ulp from it,
// contained, flat against flat, points, of sizes that differ by 2^60, with repeated and inner points; as they stand and
// under poses.
//
// Laws: case `index` of run `start` is the same on every machine; every number is finite.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/degenerate/ulps.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/body/posed_cases.hpp"
#include "query/certificate/certificate_laws.hpp"

namespace plumb::body_pairs {

using pair_cases::Material;

/// A hull of points that lives as long as this does, under a pose or not.
struct OwnedBody {
  std::vector<Point3> points;
  std::optional<Pose> pose = {};

  [[nodiscard]] query::BodyView view() const { return {.vertices = points, .pose = pose ? &*pose : nullptr}; }
};

enum class Lie : unsigned char { any, vertex, edge, face, ulp_apart, contained, flat, points, sizes, repeated };
inline constexpr std::array<std::string_view, 10> lie_names{"any",       "vertex", "edge",   "face",  "ulp apart",
                                                            "contained", "flat",   "points", "sizes", "repeated"};

class PairMaker {
 public:
  PairMaker(std::uint64_t start, std::uint64_t index) : material_(start, index), entropy_(material_.entropy()) {
    lie_ = static_cast<Lie>(index % lie_names.size());
    switch (lie_) {
      case Lie::any:
      case Lie::repeated:
        a_ = drawn(1 + below(9)), b_ = drawn(1 + below(9));
        break;
      case Lie::vertex:
        share(1);
        break;
      case Lie::edge:
        share(2);
        break;
      case Lie::face:
        share(3);
        break;
      case Lie::ulp_apart:
        share(1 + below(3));
        nudge(below(2) == 0 ? a_ : b_);
        break;
      case Lie::contained:
        a_ = whole(3 + below(8));
        b_ = inner(a_, 1 + below(5));
        break;
      case Lie::flat:
        flatten();
        break;
      case Lie::points:
        a_ = below(2) == 0 ? drawn(1) : whole(1);
        b_ = below(2) == 0 ? a_ : below(2) == 0 ? whole(2 + below(8)) : drawn(1 + below(4));
        if (below(3) == 0) b_.push_back(a_[0]);
        break;
      case Lie::sizes:
        share(1 + below(3));
        scale(below(2) == 0 ? a_ : b_, static_cast<int>(below(121)) - 60);
        break;
    }
    if (lie_ == Lie::repeated || below(6) == 0) repeat(a_), repeat(b_);
    shuffle(a_), shuffle(b_);
  }

  [[nodiscard]] Lie lie() const { return lie_; }
  [[nodiscard]] std::string about() const {
    return std::string(lie_names[static_cast<std::size_t>(lie_)]).append(", ").append(material_.about());
  }
  [[nodiscard]] OwnedBody a() const { return {a_}; }
  [[nodiscard]] OwnedBody b() const { return {b_}; }
  Material& material() { return material_; }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(entropy_.below(n)); }

  std::vector<Point3> drawn(std::size_t n) {
    std::vector<Point3> points;
    while (n-- > 0) points.push_back(points.empty() || below(3) != 0 ? material_.point3() : material_.probe3());
    return points;
  }
  Point3 whole_point(std::int64_t most = 8) {
    const auto n = [&] { return static_cast<double>(entropy_.within(most)); };
    const double x = n(), y = n(), z = n();
    return {2 * x, 2 * y, 2 * z};
  }
  std::vector<Point3> whole(std::size_t n) {
    std::vector<Point3> points;
    while (n-- > 0) points.push_back(whole_point());
    return points;
  }
  std::vector<Point3> inner(const std::vector<Point3>& of, std::size_t n) {
    std::vector<Point3> points;
    while (n-- > 0) {
      const Point3 &p = of[below(of.size())], &q = of[below(of.size())];
      points.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
    }
    return points;
  }

  /// Both have the first `n` of three points in a plane, or points between them, and others on either side of it.
  void share(std::size_t n) {
    const Point3 normal = whole_point(3), other = whole_point(3), at = whole_point();
    const auto cross = [](const Point3& u, const Point3& v) {
      return Point3{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    };
    const Point3 e = cross(normal, other), f = cross(normal, e);
    const std::array<Point3, 3> in_plane{
        at, {at.x + e.x, at.y + e.y, at.z + e.z}, {at.x + f.x, at.y + f.y, at.z + f.z}};
    for (std::size_t i = 0; i < n; ++i) a_.push_back(in_plane[i]);
    b_ = below(2) == 0 ? a_ : inner(a_, n);
    for (std::size_t k = below(7); k-- > 0;) {
      for (std::vector<Point3>* of : {&a_, &b_}) {
        const Point3 p = whole_point();
        const double side = p.x * normal.x + p.y * normal.y + p.z * normal.z, sign = (of == &a_) == (side < 0) ? 1 : -1;
        if (side != 0) of->push_back({at.x + sign * p.x, at.y + sign * p.y, at.z + sign * p.z});
      }
    }
  }
  void nudge(std::vector<Point3>& points) {
    Point3& p = points[below(points.size())];
    double& x = below(3) == 0 ? p.x : below(2) == 0 ? p.y : p.z;
    x = moved_by_ulps(x, below(2) == 0 ? 1 : -1);
  }
  static void scale(std::vector<Point3>& points, int by) {  // about the first, which is shared, as far as doubles do
    const Point3 at = points[0];
    for (std::size_t i = 1; i < points.size(); ++i) {
      Point3& p = points[i];
      const auto moved = [by](double from, double to) { return from + std::ldexp(to - from, by); };
      p = {moved(at.x, p.x), moved(at.y, p.y), moved(at.z, p.z)};
    }
  }
  void flatten() {
    const auto m = [&] { return static_cast<double>(entropy_.within(2)); };
    const double s = m(), t = m(), lift = m();
    const bool on_line = below(3) == 0;
    a_ = whole(1 + below(6)), b_ = whole(1 + below(6));
    const auto flat = [&](std::vector<Point3>& points, bool line) {
      for (Point3& p : points) {
        if (line) p.y = 2 * p.x + lift;
        p.z = s * p.x + t * p.y;
      }
    };
    flat(a_, on_line), flat(b_, on_line && below(2) == 0);
    if (below(2) == 0) b_[below(b_.size())] = a_[below(a_.size())];
    if (below(4) == 0) {
      for (Point3& p : b_) p.z += 2;
    }
  }
  void repeat(std::vector<Point3>& points) {
    const std::vector<Point3> some = inner(points, 1 + below(3));
    points.insert(points.end(), some.begin(), some.end());
    points.push_back(points[below(points.size())]);
  }
  void shuffle(std::vector<Point3>& points) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[below(i)]);
  }

  Material material_;
  Entropy& entropy_;
  Lie lie_ = Lie::any;
  std::vector<Point3> a_, b_;
};

}  // namespace plumb::body_pairs
