// Where do hard inputs come from, and who is wrong on them?  The face of degenerate/: streams of choices, families of
// points, shrinking, functions held against exact answers.
//
// The bridge to RapidCheck is apart, in plumb/degenerate/rapidcheck.hpp, since it needs RapidCheck.
#pragma once

#include "plumb/degenerate/check.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/convention.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/domain.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/family.hpp"
#include "plumb/degenerate/fuzz_target.hpp"
#include "plumb/degenerate/kind.hpp"
#include "plumb/degenerate/moves.hpp"
#include "plumb/degenerate/own_kind.hpp"
#include "plumb/degenerate/paste.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/shape.hpp"
#include "plumb/degenerate/shape_pair.hpp"
#include "plumb/degenerate/shrink.hpp"
#include "plumb/degenerate/shrink_case.hpp"
#include "plumb/degenerate/ulps.hpp"
