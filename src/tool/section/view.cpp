#include "tool/section/view.hpp"

#include <cmath>

namespace plumb::tool {
namespace {

using Vector = std::array<Rational, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector normal_of(const AnyPlane3& plane) {
  if (const auto* const given = std::get_if<Plane3>(&plane))
    return {Rational(given->normal.x), Rational(given->normal.y), Rational(given->normal.z)};
  const auto& [a, b, c] = std::get<ThreePointPlane3>(plane);
  const auto from_a = [&p = a](const Point3& q) {
    return Vector{Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y), Rational(q.z) - Rational(p.z)};
  };
  return cross(from_a(b), from_a(c));
}

}  // namespace

SectionView::SectionView(const AnyPlane3& plane) : SectionView(plane, normal_of(plane)) {}

SectionView::SectionView(const AnyPlane3& plane, const Vector& normal) : plane_(plane) {
  const Rational zero, one(1.0);
  const bool level = normal[0] == zero && normal[1] == zero;
  const Vector horizontal = level ? Vector{one, zero, zero} : Vector{-normal[1], normal[0], zero};
  std::size_t k = 0;
  for (const Vector& along : {horizontal, cross(normal, horizontal)}) {
    Axis& axis = axes_[k++];
    axis = {along, dot(along, along)};
    int others = 0;
    for (int i = 0; i < 3; ++i) {
      if (along[static_cast<std::size_t>(i)] == zero) continue;
      ++others;
      axis.only = others == 1 ? i : -1;
    }
  }
}

Point2 SectionView::at(const TriangleMesh& mesh, const SectionCorner& corner) const {
  const std::array<double, 3> nearest{corner.nearest.x, corner.nearest.y, corner.nearest.z};
  std::optional<Vector> exact;
  std::array<double, 2> uv{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& [along, squared_length, only] = axes_[k];
    if (only >= 0) {
      const auto i = static_cast<std::size_t>(only);
      uv[k] = along[i].sign() == Sign::negative ? 0 - nearest[i] : nearest[i];
      continue;
    }
    if (!exact) {
      const RationalPoint3 p = rational_point(exact_corner(mesh, plane_, corner));
      exact = Vector{p.x, p.y, p.z};
    }
    const Rational x = dot(along, *exact);
    const double magnitude = rounded_root(Rounding::nearest, x * x / squared_length);
    uv[k] = x.sign() == Sign::negative ? -magnitude : magnitude;
  }
  return {uv[0], uv[1]};
}

ContourMeasures measures(const std::vector<Point2>& corners, bool closed) {
  ContourMeasures m;
  const Point2& origin = corners.front();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
    const Point2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    m.length += std::hypot(q.x - p.x, q.y - p.y);
    if (closed) m.area += ((p.x - origin.x) * (q.y - origin.y) - (q.x - origin.x) * (p.y - origin.y)) / 2;
  }
  return m;
}

}  // namespace plumb::tool
