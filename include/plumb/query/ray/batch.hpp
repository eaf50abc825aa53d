// Ray cast: which of many triangles does a ray hit first, and which at all, and which boxes?  In the lanes of vectors.
//
// Laws: (1) the answers are those of hits and first_hit, one by one, on every instruction set.  (2) The first hit is
// that of the least exact parameter, and of equal ones that of the lowest number.  (3) The numbers are looked through
// when a batch is made, not when it is asked: NonFinite names the triangle.  A span of another length throws
// UnequalLengths.
// Source: RTCD 5.3.3, 5.3.6, 13.7.
// Cost: about 2 ns a triangle or a box with four lanes; the scalar test for those that doubles leave in doubt.  The
// best instruction set that the processor has is taken.  Nothing is searched: each item is asked once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/aabb/box_batch.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/query/body/item_batch.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb {

/// out[i] is 1 where triangle i is hit, else 0.
void hits(const AnyRay& ray, const TriangleBatch& many, std::span<std::uint8_t> out, HitRule rule = HitRule::closed);

/// The same of axis-aligned boxes.
void hits(const AnyRay& ray, const BoxBatch& many, std::span<std::uint8_t> out);

/// The numbers of all that are hit, ascending.
std::vector<std::uint32_t> all_hits(const AnyRay& ray, const TriangleBatch& many, HitRule rule = HitRule::closed,
                                    std::vector<std::uint32_t> rows = {});

struct NumberedHit {
  std::uint32_t index;
  Hit hit;
  friend bool operator==(const NumberedHit&, const NumberedHit&) = default;
};

std::optional<NumberedHit> first_hit(const AnyRay& ray, const TriangleBatch& many, HitRule rule = HitRule::closed);
/// Of a mesh; for more than one ray make a TriangleBatch of it.
std::optional<NumberedHit> first_hit(const AnyRay& ray, const TriangleMesh& mesh, HitRule rule = HitRule::closed);
bool hits(const AnyRay& ray, const TriangleMesh& mesh, HitRule rule = HitRule::closed);

}  // namespace plumb
