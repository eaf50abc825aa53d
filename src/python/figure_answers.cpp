#include "python/figure_answers.hpp"

namespace plumb::python {
namespace {

constexpr std::array feature_names{"vertex", "edge", "face", "interior"};
constexpr std::array intersection_names{"nothing", "point", "segment", "ray", "line", "polygon", "solid"};
constexpr std::array flat_names{"nothing", "point", "line", "plane", "space"};

py::tuple features_of(const ContactId& id) { return py::make_tuple(python::answer_of(id.a), python::answer_of(id.b)); }

template <class Points>
py::object corners_of(const Points& points, bool exact) {
  if (exact) {
    py::list all;
    for (const auto& p : points) all.append(fractions_of(rational_point(p)));
    return all;
  }
  std::vector<decltype(approximate(points[0]))> nearest;
  nearest.reserve(points.size());
  for (const auto& p : points) nearest.push_back(approximate(p));
  return array_of<double>(std::span<const decltype(approximate(points[0]))>(nearest));
}

template <class Vectors>
py::list directions_of(const Vectors& vectors) {
  py::list all;
  for (const auto& v : vectors) all.append(fractions_of(v));
  return all;
}

py::list faces_of(const SolidIntersection3& solid) {
  py::list faces;
  for (std::size_t f = 0; f < solid.faces(); ++f) {
    py::list corners;
    for (const std::uint32_t c : solid.corners_of(f)) corners.append(c);
    faces.append(corners);
  }
  return faces;
}

}  // namespace

py::array_t<double> row_of(const Point3& p, int dimension) {
  py::array_t<double> row(dimension);
  std::copy_n(&p.x, dimension, row.mutable_data());
  return row;
}
py::array_t<double> row_of(const Vector3& v, int dimension) { return row_of(Point3{v.x, v.y, v.z}, dimension); }

py::object answer_of(const Feature& feature) {
  return answer("Feature", feature_names[static_cast<std::size_t>(feature.kind)], feature.index);
}

py::object answer_of(const Closest& closest, int dimension) {
  return answer("ClosestPoints", row_of(closest.on_a, dimension), row_of(closest.on_b, dimension), closest.distance,
                answer_of(closest.feature_a), answer_of(closest.feature_b));
}

py::object answer_of(const Support3& support, int dimension) {
  return answer("Support", row_of(support.point, dimension), support.feature, support.unique);
}

py::object answer_of(const Penetration& penetration) {
  return answer("Penetration", penetration.depth, row_of(penetration.direction, 3), row_of(penetration.translation, 3),
                answer_of(penetration.feature_a), answer_of(penetration.feature_b), penetration.is_unique);
}

py::object answer_of(const ExactPenetration& penetration) {
  return answer("ExactPenetration", fractions_of(penetration.direction), fractions_of(penetration.core_translation),
                fraction_of(penetration.core_square), penetration.cores_are_apart, fraction_of(penetration.radii),
                answer_of(penetration.feature_a), answer_of(penetration.feature_b), penetration.is_unique);
}

py::object answer_of(const ContactManifold& contact) {
  py::list corners;
  for (const ContactCorner& c : contact.corners)
    corners.append(answer("ContactCorner", row_of(c.on_a, 3), row_of(c.on_b, 3), c.distance, features_of(c.id)));
  return answer("Contact", py::cast(contact.relation), row_of(contact.normal, 3), contact.distance, corners);
}

py::object answer_of(const ExactContact& contact) {
  py::list corners;
  for (const ExactContactCorner& c : contact.corners) {
    corners.append(answer("ExactContactCorner", fractions_of(c.on_a), fractions_of(c.on_b), fraction_of(c.along),
                          features_of(c.id)));
  }
  return answer("ExactContact", py::cast(contact.relation), fractions_of(contact.direction), fraction_of(contact.along),
                fraction_of(contact.radius_a), fraction_of(contact.radius_b), corners);
}

py::object answer_of(const AnyIntersection& common, bool exact) {
  return std::visit(
      [exact]<class Common>(const Common& c) {
        if constexpr (std::is_same_v<Common, FlatIntersection>) {
          std::vector<ExactPoint3> points;
          if (c.point) points.push_back(*c.point);
          return answer("Intersection", flat_names[static_cast<std::size_t>(static_cast<int>(c.kind) + 1)],
                        corners_of(points, exact), directions_of(c.directions), py::list());
        } else if constexpr (std::is_same_v<Common, SolidIntersection3>) {
          return answer("Intersection", intersection_names[static_cast<std::size_t>(c.kind)],
                        corners_of(c.vertices, exact), directions_of(c.directions), faces_of(c));
        } else {
          return answer("Intersection", intersection_names[static_cast<std::size_t>(c.kind)],
                        corners_of(c.vertices, exact), py::list(), py::list());
        }
      },
      common);
}

}  // namespace plumb::python
