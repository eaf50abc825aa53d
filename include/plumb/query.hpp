// The face of questions about two figures: everything in plumb/query/.
//
// Whether they meet (overlap.hpp), what they have in common (intersection.hpp), how near they are and where
// (closest.hpp), what a ray hits first (ray.hpp), when they meet on their way (translating_contact.hpp,
// continuous_contact.hpp, interval_halving.hpp).
// Source: RTCD 2.3.
#pragma once

#include "plumb/query/closest.hpp"
#include "plumb/query/closest_batch.hpp"
#include "plumb/query/closest_pairs.hpp"
#include "plumb/query/closest_result.hpp"
#include "plumb/query/continuous_contact.hpp"
#include "plumb/query/convex_location.hpp"
#include "plumb/query/exact_distance.hpp"
#include "plumb/query/exact_point.hpp"
#include "plumb/query/intersection.hpp"
#include "plumb/query/intersection2.hpp"
#include "plumb/query/intersection_result.hpp"
#include "plumb/query/interval_halving.hpp"
#include "plumb/query/item_batch.hpp"
#include "plumb/query/kinds.hpp"
#include "plumb/query/lattice2.hpp"
#include "plumb/query/motion.hpp"
#include "plumb/query/moving_distance.hpp"
#include "plumb/query/overlap.hpp"
#include "plumb/query/overlap2.hpp"
#include "plumb/query/overlap_batch.hpp"
#include "plumb/query/overlap_box.hpp"
#include "plumb/query/overlap_cylinder_cone.hpp"
#include "plumb/query/overlap_plane.hpp"
#include "plumb/query/overlap_round.hpp"
#include "plumb/query/overlap_round2.hpp"
#include "plumb/query/overlap_triangle.hpp"
#include "plumb/query/pairs.hpp"
#include "plumb/query/planes.hpp"
#include "plumb/query/ray.hpp"
#include "plumb/query/ray2.hpp"
#include "plumb/query/ray_batch.hpp"
#include "plumb/query/ray_hits.hpp"
#include "plumb/query/ray_parameter.hpp"
#include "plumb/query/ray_parity.hpp"
#include "plumb/query/root.hpp"
#include "plumb/query/translating_contact.hpp"
