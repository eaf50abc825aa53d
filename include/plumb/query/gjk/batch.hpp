// Narrow phase in batches: which of these pairs of convex bodies meet, and where does each come closest?  GJK over pairs, on one
// thread or on all.
//
//   std::vector<AnyBody3> bodies;
//   for (const Obb3& box : boxes) bodies.push_back(any_body(box));   // refers to it
//   std::vector<std::uint8_t> meet(pairs.size());
//   gjk_intersects(bodies, pairs, meet, {.execution = Execution::parallel, .caches = caches});
//
// Laws: (1) item i is what gjk_intersects and gjk say of pair i alone, on any number of threads.  (2) A cache belongs to the
// pair of its number; whatever is in it, the answers are the same.  (3) Where a body is none, or a pair names a body that there
// is not, the error is that of the lowest such pair, whose number it tells; what was written before means nothing then.
// Spans of another length than the pairs throw UnequalLengths, a number beyond the bodies Error.
// Source: RTCD 9.5.
// Cost: that of each pair; threads share them in blocks.  Bounded by n^2 signs a pair for n corners of both, as
// gjk.hpp says.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/certify/batch.hpp"
#include "plumb/query/gjk/gjk.hpp"

namespace plumb {

/// A body of any type; refers to the shape, which has to live on.  Of a figure of your own give a RoundedHull3.
using AnyBody3 = query::BodyView;
template <ConvexBody3 Shape>
requires(!RoundedHullFigure<query::UnposedType<Shape>>)  //
    AnyBody3 any_body(const Shape& shape) {
  return query::body_view(shape);
}

/// Two bodies, by their numbers.
struct BodyPair {
  std::uint32_t a, b;
  friend bool operator==(const BodyPair&, const BodyPair&) = default;
};

struct GjkBatchOptions {
  Execution execution = Execution::serial;
  std::span<GjkCache> caches{};  // none, or one a pair
  WhichPair pair = WhichPair::any;
};

/// 1 where the pair meets, else 0.
void gjk_intersects(std::span<const AnyBody3> bodies, std::span<const BodyPair> pairs, std::span<std::uint8_t> out,
                    const GjkBatchOptions& options = {});

void gjk(std::span<const AnyBody3> bodies, std::span<const BodyPair> pairs, std::span<GjkAnswer> out,
         const GjkBatchOptions& options = {});

}  // namespace plumb
