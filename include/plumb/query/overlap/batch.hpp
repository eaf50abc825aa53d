// Narrow phase, one against many: which of many triangles does a box meet, and which of many boxes a segment?  In the
// lanes of vectors.
//
// Laws: (1) the answers are those of intersects, one by one, on every instruction set.  (2) The numbers of the many are
// looked through when the batch is made: NonFinite names the item; those of the one when it is asked.  A span of
// another length throws UnequalLengths.
// Source: RTCD 5.2.9, 5.3.3, 13.7.
// Cost: some 2 to 5 ns an item with four lanes, less where the axes of the boxes separate; the scalar test for those
// that doubles leave in doubt.  The best instruction set that the processor has is taken.  Nothing is searched: each
// item is asked once.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/figure/aabb/box_batch.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/query/body/item_batch.hpp"

namespace plumb {

/// out[i] is 1 where the one meets item i of the many, else 0.
void intersects(const Aabb3& one, const TriangleBatch& many, std::span<std::uint8_t> out);
void intersects(const Segment3& one, const BoxBatch& many, std::span<std::uint8_t> out);

}  // namespace plumb
