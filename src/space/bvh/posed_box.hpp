// Between which doubles does a posed box lie, rounded outward?  And have two meshes been moved alike, so that a question
// about both is the question without poses?
//
// Laws: (1) around(pose, box) contains the exact image of every p in the box.  (2) A bound of which doubles know nothing
// is infinite: one beyond the largest, or whose terms are.
// Source: RTCD 3.2, 4.2.6 (Arvo 1990), 6.3.3.
// Cost: 18 products and sums with their magnitudes, some 20 ns, of a rigid pose twice that; a determinant.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "arith/approximate.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/predicates.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"

namespace plumb::space {

/// The double before; -infinity stays.
inline double lowered(double x) {
  constexpr std::int64_t rest = std::numeric_limits<std::int64_t>::max();
  const auto flip = [](std::int64_t bits) { return bits ^ (bits >> 63 & rest); };
  const std::int64_t least = flip(std::bit_cast<std::int64_t>(-std::numeric_limits<double>::infinity()));
  const std::int64_t at = flip(std::bit_cast<std::int64_t>(x));
  return std::bit_cast<double>(flip(at - static_cast<std::int64_t>(at > least)));
}
inline double raised(double x) { return -lowered(-x); }

/// At most the exact value; -infinity where nothing is known of it.
inline double surely_below(const Approximate& x) {
  const double low = x.value - x.reach();
  return low == low ? lowered(low) : -std::numeric_limits<double>::infinity();
}
inline double surely_above(const Approximate& x) { return -surely_below({-x.value, x.magnitude, x.error}); }

/// One coordinate of matrix * p + translation.
inline Approximate posed_part(double a, double b, double c, double shift, double x, double y, double z) {
  return Approximate(a) * Approximate(x) + Approximate(b) * Approximate(y) + Approximate(c) * Approximate(z) +
         Approximate(shift);
}

inline Aabb3 around(const Pose& pose, const Aabb3& box) {
  const auto& [c, t] = pose;
  const auto least = [&](double m, double n, double o, double shift) {
    return surely_below(posed_part(m, n, o, shift, m < 0 ? box.max.x : box.min.x, n < 0 ? box.max.y : box.min.y,
                                   o < 0 ? box.max.z : box.min.z));
  };
  const auto most = [&](double m, double n, double o, double shift) {
    return surely_above(posed_part(m, n, o, shift, m < 0 ? box.min.x : box.max.x, n < 0 ? box.min.y : box.max.y,
                                   o < 0 ? box.min.z : box.max.z));
  };
  return {{least(c[0].x, c[1].x, c[2].x, t.x), least(c[0].y, c[1].y, c[2].y, t.y), least(c[0].z, c[1].z, c[2].z, t.z)},
          {most(c[0].x, c[1].x, c[2].x, t.x), most(c[0].y, c[1].y, c[2].y, t.y), most(c[0].z, c[1].z, c[2].z, t.z)}};
}

inline Aabb3 around(const Pose& pose, const Point3& p) {
  const auto& [c, t] = pose;
  const Approximate x = posed_part(c[0].x, c[1].x, c[2].x, t.x, p.x, p.y, p.z);
  const Approximate y = posed_part(c[0].y, c[1].y, c[2].y, t.y, p.x, p.y, p.z);
  const Approximate z = posed_part(c[0].z, c[1].z, c[2].z, t.z, p.x, p.y, p.z);
  return {{surely_below(x), surely_below(y), surely_below(z)}, {surely_above(x), surely_above(y), surely_above(z)}};
}

inline Aabb3 merged(const Aabb3& a, const Aabb3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}
/// Its lower end, off by no more than its width, which is part of the magnitude.
inline Approximate approximate(const Interval& x) {
  const double width = raised(x.upper - x.lower);
  return {x.lower, raised(magnitude_of(x.lower) + 0x1p53 * width), 1};
}
/// By the rows of a rigid pose: by intervals where doubles do not know the sign of a factor.
inline Aabb3 around_rigidly(const MeshPose& pose, const Aabb3& box) {
  const Interval x(box.min.x, box.max.x), y(box.min.y, box.max.y), z(box.min.z, box.max.z);
  const auto on = [&](std::size_t i) {
    const auto& row = pose.rows()[i];
    const Interval &u = row[0], &v = row[1], &w = row[2], &shift = row[3];
    const auto has_sign = [](const Interval& factor) { return factor.lower >= 0 || factor.upper <= 0; };
    if (!has_sign(u) || !has_sign(v) || !has_sign(w)) return u * x + v * y + w * z + shift;
    const Approximate a = approximate(u), b = approximate(v), c = approximate(w), d = approximate(shift);
    const auto end = [&](bool most) {
      const auto part = [&](const Interval& factor, const Interval& of) {
        return Approximate((factor.lower < 0) == most ? of.lower : of.upper);
      };
      return a * part(u, x) + b * part(v, y) + c * part(w, z) + d;
    };
    return Interval(surely_below(end(false)), surely_above(end(true)));
  };
  const Interval at_x = on(0), at_y = on(1), at_z = on(2);
  return {{at_x.lower, at_y.lower, at_z.lower}, {at_x.upper, at_y.upper, at_z.upper}};
}
inline Aabb3 around(const MeshPose& pose, const Aabb3& box) {
  return pose.matrix() != nullptr ? around(*pose.matrix(), box) : around_rigidly(pose, box);
}
inline Aabb3 around(const MeshPose& pose, const Point3& p) {
  return pose.matrix() != nullptr ? around(*pose.matrix(), p) : around_rigidly(pose, {p, p});
}
inline Aabb3 around(const PosedTriangle& t) {
  return merged(merged(around(t.pose, t.shape.a), around(t.pose, t.shape.b)), around(t.pose, t.shape.c));
}

/// Has it no infinite bound?
inline bool is_bounded(const Aabb3& box) {
  constexpr double most = std::numeric_limits<double>::max();
  return box.min.x >= -most && box.min.y >= -most && box.min.z >= -most && box.max.x <= most && box.max.y <= most &&
         box.max.z <= most;
}

template <class Mesh>
Aabb3 around(const PosedMeshOf<Mesh>& mesh, const BoxNode& node) {
  return around(mesh.pose, mesh.bvh.tree.frame.outside(node.box()));
}

/// Throws NonFinite, by the pose's own name.
inline void require_finite_pose(const char* function, const std::string& name, const Pose& pose) {
  const auto require = [&](const std::string& part, const Vector3& v) {
    for (const auto& [axis, x] : {std::pair{".x", v.x}, {".y", v.y}, {".z", v.z}}) {
      if (x - x == 0) continue;
      throw NonFinite(std::string(function) + ": " + name + part + axis + " is " +
                      (x > 0   ? "inf"
                       : x < 0 ? "-inf"
                               : "nan") +
                      ", not a real number; give a finite double");
    }
  };
  for (std::size_t i = 0; i < 3; ++i) require(".columns[" + std::to_string(i) + "]", pose.columns[i]);
  require(".translation", pose.translation);
}
inline void require_finite_pose(const char* function, const std::string& name, const MeshPose& pose) {
  pose.visit([&]<class By>(const By& by) {
    if constexpr (std::is_same_v<By, Pose>) {
      require_finite_pose(function, name, by);
    } else {
      figure::require_sound(function, name, by);
    }
  });
}
/// The same of a mesh's: "first_hit: mesh.pose.columns[0].x is nan, not a real number; give a finite double".
inline void require_pose(const char* function, const char* name, const MeshPose& pose) {
  require_finite_pose(function, std::string(name) + ".pose", pose);
}

/// Then it maps one to one, and what is in common has an image of its own.
inline bool is_regular(const Pose& pose) {
  const auto point = [](const Vector3& v) { return Point3{v.x, v.y, v.z}; };
  const auto& c = pose.columns;
  return orient3d(point(c[0]), point(c[1]), point(c[2]), Point3{0, 0, 0}) != Sign::zero;
}
inline bool is_regular(const MeshPose& pose) { return pose.matrix() == nullptr || is_regular(*pose.matrix()); }

/// Is it the question without poses?
template <class Mesh>
bool are_moved_alike(const char* function, const PosedMeshOf<Mesh>& a, const PosedMeshOf<Mesh>& b) {
  require_pose(function, "a", a.pose);
  require_pose(function, "b", b.pose);
  return a.pose == b.pose && is_regular(a.pose);
}

/// The same of one mesh and itself.
template <class Mesh>
bool is_moved_regularly(const char* function, const PosedMeshOf<Mesh>& mesh) {
  require_pose(function, "mesh", mesh.pose);
  return is_regular(mesh.pose);
}

/// Which of two posed boxes is to be descended; a guess.
inline Descend larger_posed(const Aabb3& a, const Aabb3& b) {
  const auto size = [](const Aabb3& x) { return std::max({x.max.x - x.min.x, x.max.y - x.min.y, x.max.z - x.min.z}); };
  return size(a) < size(b) ? Descend::second : Descend::first;
}

}  // namespace plumb::space
