// The nearest point of a shape as others find it: in plain doubles, by Eigen, by CGAL's Epick.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

struct NearestFound {
  Point3 point;
  double distance;
};

NearestFound nearest_in_doubles(const Segment3& s, const Point3& p);
NearestFound nearest_in_doubles(const Triangle3& t, const Point3& p);
NearestFound nearest_in_doubles(const Aabb3& box, const Point3& p);
/// For orthonormal axes.
NearestFound nearest_in_doubles(const Obb3& box, const Point3& p);

NearestFound nearest_by_eigen(const Segment3& s, const Point3& p);
NearestFound nearest_by_eigen(const Triangle3& t, const Point3& p);
NearestFound nearest_by_eigen(const Aabb3& box, const Point3& p);
NearestFound nearest_by_eigen(const Obb3& box, const Point3& p);

NearestFound nearest_by_cgal(const Segment3& s, const Point3& p);
NearestFound nearest_by_cgal(const Triangle3& t, const Point3& p);

}  // namespace plumb::bench
