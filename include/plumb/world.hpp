// The face of worlds: bodies that come, go and move, and which of them meet.
//
// Source: docs/sections.md, chapter 2.
#pragma once

#include "plumb/world/clash.hpp"  // parts of an assembly: touching, overlapping, piercing, enclosed, duplicate
#include "plumb/world/world.hpp"  // CollisionWorld: which pairs meet, and what has begun and ended
