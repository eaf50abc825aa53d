// Where do hard inputs come from, and who is wrong on them?  The face of degenerate/.
//
// Apart: the bridge to RapidCheck (degenerate/rapidcheck.hpp), which needs RapidCheck, and the kinds of questions that the
// library answers (query/kinds/kinds.hpp).
// Source: docs/degeneracies.md, docs/fuzzing.md.
#pragma once

#include "plumb/predicates/standard.hpp"

// Which inputs are hard?
#include "plumb/degenerate/cloud.hpp"        // sets of many points
#include "plumb/degenerate/coordinates.hpp"  // single numbers
#include "plumb/degenerate/entropy.hpp"      // the stream of choices that all are made from
#include "plumb/degenerate/exact.hpp"        // exactly collinear, coplanar, cocircular, cospherical
#include "plumb/degenerate/family.hpp"       // families of point sets
#include "plumb/degenerate/moves.hpp"        // what makes a set harder
#include "plumb/degenerate/points.hpp"       // points of every family
#include "plumb/degenerate/shape.hpp"        // single shapes
#include "plumb/degenerate/shape_pair.hpp"   // two shapes in special positions
#include "plumb/degenerate/ulps.hpp"         // neighbors of doubles

// Who is wrong on them?
#include "plumb/degenerate/check.hpp"        // a function against the exact answers
#include "plumb/degenerate/convention.hpp"   // what it promises: boundary in or out, ends open or closed
#include "plumb/degenerate/domain.hpp"       // which numbers it is made for
#include "plumb/degenerate/fuzz_target.hpp"  // libFuzzer, AFL++
#include "plumb/degenerate/kind.hpp"         // a kind of question
#include "plumb/degenerate/own_kind.hpp"     // and one of your own
#include "plumb/degenerate/paste.hpp"        // a failing case as C++, Python, OBJ
#include "plumb/degenerate/shrink.hpp"       // the simplest list of choices that fails
#include "plumb/degenerate/shrink_case.hpp"  // the simplest case that fails
