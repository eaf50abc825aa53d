// Which pairs of bodies may meet, by what a GPU draws of them?  A filter in front of the exact questions.
//
//   GpuFilter gpu({.resolution = 64});                    // throws NoGpu where there is none
//   for (const BoxPair& p : gpu.may_meet(bodies)) ...     // all that meet, and some more
//   for (const MeetingBodies& m : gpu.meeting(bodies))    // exactly those that meet
//   gpu.may_collide(bodies)                               // the potentially colliding set
//
// Laws: (1) nothing that meets is filtered out: each pair that has a point in common is among those of may_meet, and
// both bodies are in may_collide, at every resolution.  (2) meeting() are exactly the pairs that meet, as a
// CollisionWorld tells them, on any GPU and at any resolution; these change only how many are asked.  (3) Pairs
// ascend; a < b in those found.
// Why it is conservative: a point goes to a cell, a pixel and a depth, by an affine map along each axis and floor.
// Each corner goes to a range of integers that holds its exact image, by interval arithmetic; ranges of midpoints are
// made of these in integers, so that the cells of the parts of a triangle hold each of its points.  What is drawn is
// rectangles of whole pixels with whole depths, which floats hold: their edges run half a pixel from the centers that
// are asked, no depth is interpolated, and shaders multiply by powers of two.  A common point is in a cell of both
// bodies, and above and below a point inside of a solid its surface is drawn in the same pixel.  So a pixel always
// says so.
// A resolution that is no power of two from 16 to 1,024 throws Error, as does a GPU that fails; bodies throw as in a
// world.
// A filter is for one thread at a time; what context was current is so again afterwards.
// It is in the library plumb_gpu alone (PLUMB_BUILD_GPU): nothing else includes it or needs EGL.
// Source: RTCD 10.1, 10.1.1, 10.1.2, 10.2, 10.3, 10.4.
// Cost: docs/world.md#the-gpu-as-a-filter.  Two draws for each body, order and direction for the set; for each pair
// three for its views at most.  Results are read back once for a batch of pairs.  Nothing is searched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/space/pairs/box_pair.hpp"
#include "plumb/world/any_body.hpp"

namespace plumb {

/// There is no EGL device that draws without a display; the text says what was tried.
struct NoGpu : Error {
  using Error::Error;
};

struct GpuFilterOptions {
  std::uint32_t resolution = 64;  // pixels along each side of a view
};

/// What the last call did.
struct GpuFilterCounts {
  std::size_t in_set = 0;  // bodies that a visibility pass has left
  std::size_t asked = 0;   // pairs that were drawn, of those whose boxes overlap
  std::size_t kept = 0;    // pairs of these that may meet
  std::size_t queries = 0, readbacks = 0;
};

/// Two bodies by their numbers.
struct MeetingBodies {
  std::uint32_t a, b;
  Relation relation;
  friend bool operator==(const MeetingBodies&, const MeetingBodies&) = default;
};

class GpuFilter {
 public:
  explicit GpuFilter(const GpuFilterOptions& options = {});
  GpuFilter(GpuFilter&&) noexcept;
  GpuFilter& operator=(GpuFilter&&) noexcept;
  ~GpuFilter();

  /// What draws, as it names itself.
  [[nodiscard]] const std::string& renderer() const;
  [[nodiscard]] const GpuFilterCounts& counts() const;

  /// The bodies that may meet another, ascending: again and again, those that along no axis are seen whole in front of
  /// all drawn before them and, in the other order, of all drawn after them.
  std::vector<std::uint32_t> may_collide(std::span<const AnyBody> bodies);
  /// Those of the pairs that may meet, in their order: along each axis two solids by their depths, pixel by pixel, two
  /// surfaces by the edges of each among the faces of the other, and a surface by its faces within a solid.
  std::vector<BoxPair> may_meet(std::span<const AnyBody> bodies, std::span<const BoxPair> pairs);
  /// Those of all pairs whose boxes overlap.
  std::vector<BoxPair> may_meet(std::span<const AnyBody> bodies);
  /// The exact answers of these.
  std::vector<MeetingBodies> meeting(std::span<const AnyBody> bodies);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
