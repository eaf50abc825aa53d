// The face of questions about two figures: everything in plumb/query/.
#pragma once

#include "plumb/query/closest.hpp"
#include "plumb/query/closest_pairs.hpp"
#include "plumb/query/closest_result.hpp"
#include "plumb/query/continuous_contact.hpp"
#include "plumb/query/exact_distance.hpp"
#include "plumb/query/exact_point.hpp"
#include "plumb/query/intersection.hpp"
#include "plumb/query/intersection2.hpp"
#include "plumb/query/intersection_result.hpp"
#include "plumb/query/motion.hpp"
#include "plumb/query/overlap2.hpp"
#include "plumb/query/overlap_box.hpp"
#include "plumb/query/overlap_plane.hpp"
#include "plumb/query/overlap_triangle.hpp"
#include "plumb/query/root.hpp"
#include "plumb/query/translating_contact.hpp"
