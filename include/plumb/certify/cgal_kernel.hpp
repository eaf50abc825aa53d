// May CGAL's algorithms take their decisions by our signs?  A CGAL kernel: Epick's points and constructions, our
// predicates.
//
//   CGAL::Delaunay_triangulation_3<plumb::CgalKernel> triangulation(points.begin(), points.end());
//
// Ours are Orientation, Coplanar, Coplanar_orientation, Side_of_oriented_circle and _sphere, Side_of_bounded_circle and
// _sphere, Coplanar_side_of_bounded_circle, Less_signed_distance_to_plane, Compare_distance, Left_turn and
// Compare_y_at_x, where they take points; whatever else a kernel offers is Epick's, exact as well.
// Laws: every predicate answers as Epick's does, and so the output of an algorithm is the same; a coordinate that is
// NaN or infinite throws NonFinite.  CGAL's 3D orientation is the opposite of ours, as is its side of a sphere.
// Needs CGAL 5 (Debian: libcgal-dev), which nothing else of the library does; nothing else includes this header.
// Source: CGAL 5.5's manual, "2D and 3D Linear Geometry Kernel".
// Cost: that of the signs (docs/measurements.md).
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "plumb/certify/cgal_signs.hpp"

// Of CGAL's hulls, which need not be included.
namespace CGAL {
template <class R, class Mesh, class Filtered>
class Convex_hull_traits_3;
namespace Convex_hull_3::internal {
template <class Traits, class IsCartesian>
class Is_on_positive_side_of_plane_3;
}
}  // namespace CGAL

namespace plumb {

namespace cgal {

/// Kernel with its predicates on points replaced by ours.
template <class Kernel>
struct WithOurSigns : Kernel {
  using Orientation_2 = cgal::Orientation2<Kernel>;
  using Orientation_3 = cgal::Orientation3<Kernel>;
  using Coplanar_3 = cgal::Coplanar3<Kernel>;
  using Coplanar_orientation_3 = cgal::CoplanarOrientation3<Kernel>;
  using Side_of_oriented_circle_2 = cgal::SideOfOrientedCircle2<Kernel>;
  using Side_of_bounded_circle_2 = cgal::SideOfBoundedCircle2<Kernel>;
  using Side_of_oriented_sphere_3 = cgal::SideOfOrientedSphere3<Kernel>;
  using Side_of_bounded_sphere_3 = cgal::SideOfBoundedSphere3<Kernel>;
  using Coplanar_side_of_bounded_circle_3 = cgal::CoplanarSideOfBoundedCircle3<Kernel>;
  using Less_signed_distance_to_plane_3 = cgal::LessSignedDistanceToPlane3<Kernel>;
  using Compare_distance_2 = cgal::CompareDistance2<Kernel>;
  using Compare_distance_3 = cgal::CompareDistance3<Kernel>;
  // CGAL's own, of our orientation.
  using Left_turn_2 = CGAL::CommonKernelFunctors::Left_turn_2<WithOurSigns>;
  using Compare_y_at_x_2 = CGAL::internal::Static_filters_predicates::Compare_y_at_x_2<Kernel, WithOurSigns>;

  Orientation_2 orientation_2_object() const { return {}; }
  Orientation_3 orientation_3_object() const { return {}; }
  Coplanar_3 coplanar_3_object() const { return {}; }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
  Side_of_bounded_circle_2 side_of_bounded_circle_2_object() const { return {}; }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
  Side_of_bounded_sphere_3 side_of_bounded_sphere_3_object() const { return {}; }
  Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const { return {}; }
  Less_signed_distance_to_plane_3 less_signed_distance_to_plane_3_object() const { return {}; }
  Compare_distance_2 compare_distance_2_object() const { return {}; }
  Compare_distance_3 compare_distance_3_object() const { return {}; }
  Left_turn_2 left_turn_2_object() const { return {}; }
  Compare_y_at_x_2 compare_y_at_x_2_object() const { return {}; }
};

}  // namespace cgal

/// A CGAL kernel of Cartesian doubles, for every algorithm that takes Epick.
class CgalKernel
    : public cgal::WithOurSigns<CGAL::Filtered_kernel_adaptor<
          CGAL::Type_equality_wrapper<CGAL::Simple_cartesian<double>::Base<CgalKernel>::Type, CgalKernel>, true>> {};

}  // namespace plumb

/// convex_hull_3 asks on which side of a facet points lie.  With a kernel of doubles it does so on its own, with the
/// rounding mode switched; with ours it asks the same of our signs, which do not.
template <class Mesh>
class CGAL::Convex_hull_3::internal::Is_on_positive_side_of_plane_3<
    CGAL::Convex_hull_traits_3<plumb::CgalKernel, Mesh, CGAL::Tag_true>, boost::true_type> {
  using Point_3 = plumb::CgalKernel::Point_3;

 public:
  using Protector = CGAL::Protect_FPU_rounding<false>;

  Is_on_positive_side_of_plane_3(const CGAL::Convex_hull_traits_3<plumb::CgalKernel, Mesh, CGAL::Tag_true>&,
                                 const Point_3& p, const Point_3& q, const Point_3& r)
      : p_(p), q_(q), r_(r) {}

  bool operator()(const Point_3& s) const { return plumb::cgal::orient3d(p_, q_, r_, s) == plumb::Sign::negative; }

 private:
  Point_3 p_, q_, r_;
};

/// Points are located by plain doubles first, as with Epick.
template <>
struct CGAL::Triangulation_structural_filtering_traits<plumb::CgalKernel> {
  using Use_structural_filtering_tag = CGAL::Tag_true;
};
