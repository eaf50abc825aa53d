// What are the signs for many cases at once?  The four classic predicates over spans.
//
// Laws: (1) out[i] is the sign of case i, the one that the predicate gives for it alone, on every instruction set and
//       number of threads.  (2) Spans of unequal length throw UnequalLengths before anything is written.
//       (3) A coordinate that is NaN or infinite throws NonFinite, which names the first such case by its number
//       (from 0) and the argument: "orient3d: b.y of item 17 is nan, ..."; signs may have been written by then.
//       (4) `out` must not overlap the coordinates.
// The points of an argument lie one after the other, or each coordinate has an array of its own (a view).  The vectors
// are those of the processor at hand: SSSE3, AVX2 or AVX-512; elsewhere one case after the other.
// One line, plane, circle or sphere against many points: certify/side.hpp.
// Source: RTCD 13.7; docs/batches.md.
// Cost: with AVX-512 0.3 to 2 ns a sign where floating point suffices.
// These functions are in the library plumb::batch.
#pragma once

#include <span>

#include "plumb/arith/point.hpp"
#include "plumb/arith/points_view.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/certify/answered.hpp"

namespace plumb {

/// On how many threads: the caller's, or also those of oneTBB where there are enough cases to occupy them.
enum class Execution : unsigned char { serial, parallel };

void orient2d(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> c, std::span<Sign> out,
              Execution execution = Execution::serial);
void orient2d(const Points2View& a, const Points2View& b, const Points2View& c, std::span<Sign> out,
              Execution execution = Execution::serial);

void orient3d(std::span<const Point3> a, std::span<const Point3> b, std::span<const Point3> c,
              std::span<const Point3> d, std::span<Sign> out, Execution execution = Execution::serial);
void orient3d(const Points3View& a, const Points3View& b, const Points3View& c, const Points3View& d,
              std::span<Sign> out, Execution execution = Execution::serial);

void incircle(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> c,
              std::span<const Point2> d, std::span<Sign> out, Execution execution = Execution::serial);
void incircle(const Points2View& a, const Points2View& b, const Points2View& c, const Points2View& d,
              std::span<Sign> out, Execution execution = Execution::serial);

void insphere(std::span<const Point3> a, std::span<const Point3> b, std::span<const Point3> c,
              std::span<const Point3> d, std::span<const Point3> e, std::span<Sign> out,
              Execution execution = Execution::serial);
void insphere(const Points3View& a, const Points3View& b, const Points3View& c, const Points3View& d,
              const Points3View& e, std::span<Sign> out, Execution execution = Execution::serial);

}  // namespace plumb
