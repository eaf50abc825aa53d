// The face of worlds: bodies that come, go and move, and which of them meet.
//
// plumb/world/gpu_filter.hpp is of the library plumb_gpu, which not every build has: it is included by those who want it.
// Source: docs/sections.md, chapter 2.
#pragma once

#include "plumb/world/any_body.hpp"     // what stands in a world: a figure, a shared mesh, a compound of both
#include "plumb/world/clash.hpp"        // parts of an assembly: touching, overlapping, piercing, enclosed, duplicate
#include "plumb/world/clashes.hpp"      // all such pairs of many parts
#include "plumb/world/heightfield.hpp"  // a grid of heights as a mesh
#include "plumb/world/plan.hpp"         // for which bodies of a world a proxy pays
#include "plumb/world/world.hpp"  // CollisionWorld: which pairs meet, where they touch, and what has begun and ended
