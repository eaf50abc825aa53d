// The signs, figures, trees of many, meshes with their files, and worlds: all but what each of these faces says is
// apart.  Generators of hard inputs are apart as well, in plumb/degenerate.hpp.
#pragma once

#include "plumb/certify/accepted.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "plumb/surface.hpp"
#include "plumb/world.hpp"
