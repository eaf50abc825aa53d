// Where do hard inputs come from?  The face of degenerate/: streams of choices, families of points, shrinking.
//
// The bridge to RapidCheck is apart, in plumb/degenerate/rapidcheck.hpp, since it needs RapidCheck.
#pragma once

#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/family.hpp"
#include "plumb/degenerate/moves.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/shrink.hpp"
#include "plumb/degenerate/ulps.hpp"
