// The face of figures: everything in plumb/figure/.
#pragma once

#include "plumb/figure/aabb.hpp"
#include "plumb/figure/aabb_relation.hpp"
#include "plumb/figure/barycentric.hpp"
#include "plumb/figure/box.hpp"
#include "plumb/figure/climbing_aabb.hpp"
#include "plumb/figure/contains.hpp"
#include "plumb/figure/convex_polyhedron.hpp"
#include "plumb/figure/hull2.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/mesh.hpp"
#include "plumb/figure/plane.hpp"
#include "plumb/figure/polygon.hpp"
#include "plumb/figure/relation.hpp"
#include "plumb/figure/round.hpp"
#include "plumb/figure/simplex.hpp"
#include "plumb/figure/small_system.hpp"
