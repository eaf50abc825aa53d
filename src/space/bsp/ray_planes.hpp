// Where does a ray meet the planes of a tree, in which order?
//
// Laws: exact.  A place is the beginning, which of a line is infinitely far back, or that of a plane that the ray is not
// parallel to; doubles with their errors tell most signs and orders.
// Source: RTCD 8.4.2, 5.3.1.
// Cost: some 60 operations a plane, exact signs where errors leave a doubt.
#pragma once

#include "arith/running_error.hpp"
#include "plumb/query/ray/ray.hpp"
#include "space/bsp/plane_side.hpp"

namespace plumb::space {

inline constexpr std::uint32_t ray_begin = 0xffffffff, ray_end = 0xfffffffe;

struct RayPlace {
  std::uint32_t plane;  // by its number, or ray_begin or ray_end
  double least, most;   // between which t is
};

/// How the ray lies to a plane.
struct RayPassage {
  Sign from;     // of the beginning, positive in front; of a line it is told where it is parallel alone
  Sign heading;  // positive where the ray goes to the front; zero where it stays on one side of all planes parallel
  RayPlace place;
};

class RayPlanes {
 public:
  RayPlanes(const BspTree& tree, const AnyRay& ray);

  [[nodiscard]] RayPlace begin() const;
  [[nodiscard]] RayPlace end() const;
  [[nodiscard]] RayPassage passage(const BspNode& node) const;
  /// Of t; both places are the ray's.
  [[nodiscard]] Sign compare(const RayPlace& a, const RayPlace& b) const;
  /// Positive where the place is in front of the plane.
  [[nodiscard]] Sign side(const RayPassage& passage, const RayPlace& place) const;

 private:
  [[nodiscard]] Sign exact_order(const RayPlace& a, const RayPlace& b) const;
  /// Of the plane's place, to the beginning or to the end.
  [[nodiscard]] Sign order_to_end(std::uint32_t plane, const RayPlace& end) const;
  [[nodiscard]] Sign heading(std::uint32_t plane) const;

  const BspTree& tree_;
  const AnyRay& ray_;
  std::array<Running, 3> direction_;
};

}  // namespace plumb::space
