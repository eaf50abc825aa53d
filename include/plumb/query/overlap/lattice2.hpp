// Integer arithmetic: do segments of a lattice meet, and where does a point lie to a triangle or polygon of it?  In the
// plan's arithmetic.
//
//   const Kernel kernel(plan(lattice_of(coordinates)));
//   const LatticeTests2 tests(kernel);
//   tests.relate({p[0], p[1]}, {p[2], p[3]});          // p = kernel.points(vertices), checked once
//   tests.relate(these, those, relations);              // many: the arithmetic is chosen once
//
// Laws: (1) what relate, intersects and locate say of the same figures as given (query/overlap/overlap.hpp,
// figure/containment/contains.hpp, figure/containment/polygon_location.hpp), degenerate ones included.  (2) Every sign is orient2d in the
// cheapest arithmetic that is exact for all points of the lattice (certify/plan.hpp): plain doubles up to 25 bits,
// doubles with a bound and integers up to 62.  (3) Points that another lattice took in throw OffLattice: no wrong input gets an answer.
// Spans of different lengths throw UnequalLengths, a polygon of fewer than three vertices InvalidShape.
// The kernel must outlive its tests.
// Source: RTCD 11.5.3, 5.1.9.1, 5.4.1, 5.4.2.
// Cost: docs/intersection.md.  Nothing is searched: each edge of a polygon is looked at once.
#pragma once

#include <span>

#include "plumb/certify/kernel.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

struct LatticeSegment2 {
  LatticePoint<2> a, b;
};
struct LatticeTriangle2 {
  LatticePoint<2> a, b, c;
};

class LatticeTests2 {
 public:
  explicit LatticeTests2(const Kernel& kernel) : kernel_(&kernel) {}

  [[nodiscard]] Relation relate(const LatticeSegment2& s, const LatticeSegment2& t) const;
  [[nodiscard]] bool intersects(const LatticeSegment2& s, const LatticeSegment2& t) const {
    return relate(s, t) != Relation::disjoint;
  }
  /// A segment is all boundary.
  [[nodiscard]] Location locate(const LatticeSegment2& segment, const LatticePoint<2>& p) const;
  [[nodiscard]] Location locate(const LatticeTriangle2& triangle, const LatticePoint<2>& p) const;
  /// Of any chain, the last vertex joined to the first: inside where it winds around p an odd number of times.
  [[nodiscard]] Location locate(std::span<const LatticePoint<2>> polygon, const LatticePoint<2>& p) const;

  /// One with one: out[i] is of s[i] and t[i].
  void relate(std::span<const LatticeSegment2> s, std::span<const LatticeSegment2> t, std::span<Relation> out) const;
  /// One figure against many points.
  void locate(const LatticeTriangle2& triangle, std::span<const LatticePoint<2>> p, std::span<Location> out) const;
  void locate(std::span<const LatticePoint<2>> polygon, std::span<const LatticePoint<2>> p,
              std::span<Location> out) const;

 private:
  const Kernel* kernel_;
};

}  // namespace plumb
