// Approximate convex decomposition: which few convex hulls cover a solid, and how far do they reach beyond it?
//
//   const CoveringParts cover = covering_parts(mesh, {.concavity = 0.05, .most_parts = 32});
//   for (const CoveringPart& part : cover.parts) collide(part.proxy);      // hulls, with corners that are doubles
//
// Bottom up: of the exact parts two at a time become one, those first whose hull is thought to add least volume, as long
// as the hull is proved to stay near what it covers; where more are left than asked for, they go on becoming one.
// Laws: (1) each exact part is the share of one covering part, whose hull holds it, exactly; so the hulls cover the
// solid.  (2) concavity: no point of the hull's surface is farther from the share than this, which is proved; found
// between the greatest distance and some 1.05 times it, or as far above as a budget of steps left it.  (3) It is at
// most the length asked for, unless most_parts is less than what that allows.  A corner that is no double is covered by
// those around it, so that a single exact part has a concavity of some units in the last place.  (4) The order of the
// mesh's vertices and triangles changes nothing.
// A length that is negative, no parts at most, and what convex_parts refuses throw InvalidShape; NaN and infinity throw
// NonFinite.
// Source: RTCD 12.5.3; Lien and Amato, Approximate convex decomposition of polyhedra, 2007; Mamou, V-HACD, 2016; Wei
// and others, CoACD, 2022.
// Cost: that of convex_parts, a hull for each pair of neighbors and some 10 us a step of a proof.  Bounded by n^2 hulls
// for n exact parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/figure/bound/proxy.hpp"
#include "plumb/surface/parts/convex_parts.hpp"

namespace plumb {

struct CoveringOptions {
  double concavity = 0;  // a length: parts become one where it stays at most this
  std::optional<std::uint32_t> most_parts{};
};

struct CoveringPart {
  HullProxy proxy;
  std::vector<std::uint32_t> share;  // exact parts, ascending
  double concavity = 0;
};

struct CoveringParts {
  ConvexParts exact;
  std::vector<CoveringPart> parts;  // by the first exact part of each
};

CoveringParts covering_parts(const TriangleMesh& mesh, const CoveringOptions& options = {});

/// The same as collision geometry alone: a mesh's proxy that is a compound of hulls.
std::vector<HullProxy> compound_proxy(const TriangleMesh& mesh, const CoveringOptions& options = {});

}  // namespace plumb
