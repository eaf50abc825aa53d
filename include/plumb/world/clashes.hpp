// Clashes of an assembly: which pairs of many parts touch, overlap, pierce or enclose one another, or come too near?
//
//   for (const PartClash& p : find_clashes(meshes).found) use(p.a, p.b, p.clash.kind);
//   find_clashes(meshes, pairs_in_reach(meshes, 0.05), {.clearance = 0.05})
//
// Laws: (1) found are exactly the pairs of those asked for that are not apart, each with what find_clash says of it; they
// ascend by a, then b.  (2) Pairs without pairs_in_reach are apart, and farther than the reach from one another.  (3)
// The answers depend on the meshes alone, not on threads; parts in another order have the same answers by other numbers.
// (4) Pairs that are a translation of one another, exactly, are asked once: `answered` counts those that were asked.
// A part whose numbers are not finite or name no vertex throws as ClashPart does, before anything is asked.  progress may stop
// it (plumb/space/bvh/progress.hpp).
// Source: RTCD 2.4.1.
// Cost: that of overlapping_pairs for boxes; of ClashPart for parts that are asked about, and of find_clash for pairs
// that are no image of another.  Bounded by n^2 pairs, and each as find_clash is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/space/bvh/progress.hpp"
#include "plumb/world/clash.hpp"

namespace plumb {

/// Two parts by their numbers, a < b.
struct AskedPair {
  std::uint32_t a, b;
  std::optional<double> clearance{};  // instead of that of the options
  friend bool operator==(const AskedPair&, const AskedPair&) = default;
};

/// Those whose boxes are no farther than the reach from one another along any axis, and some that are hardly farther.
std::vector<AskedPair> pairs_in_reach(std::span<const TriangleMesh> parts, double reach = 0);

struct PartClash {
  std::uint32_t a, b;
  Clash clash;
};

struct Clashes {
  std::vector<PartClash> found;
  std::size_t asked = 0, answered = 0;  // pairs
};

struct ClashesOptions {
  std::optional<double> clearance{};
  bool measure = true;
  Execution execution = Execution::parallel;
  Progress progress = {};
};

Clashes find_clashes(std::span<const TriangleMesh> parts, std::span<const AskedPair> pairs,
                     const ClashesOptions& options = {});
/// All pairs in reach of the clearance are asked.
Clashes find_clashes(std::span<const TriangleMesh> parts, const ClashesOptions& options = {});

}  // namespace plumb
