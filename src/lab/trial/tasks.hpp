// Which questions does the laboratory put to the methods?  The four classics, which the program asks as well, and these.
//
// Law: a task is told once, wherever it is asked: by `plumb-lab chart`, as test vectors, in experiments.
// Source: RTCD 3, 5, 6, 7, 11.2, 12.
// Cost: none, a list.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/trial/terms.hpp"

namespace plumb::lab::trial {

/// Methods that need a rival's library: whoever links one names the task that it joins.
struct Rival {
  std::string task;
  Method method;
};

/// In the order of the report, each with the rivals that join it.
std::vector<Task> all_tasks(std::span<const Rival> rivals);

Task segment_segment_task();
Task ray_triangle_task();
Task segment_triangle_task();
Task triangle_triangle_task();
Task box_box_task();
Task oriented_boxes_task();
Task point_in_polygon_task();
Task point_in_polyhedron_task();
Task hull2_task();
Task hull3_task();
Task smallest_ball_task();
Task point_segment_distance_task();
Task point_box_distance_task();
Task point_triangle_distance_task();
Task segment_segment_distance_task();
Task convex_meeting_task();
Task convex_distance_task();
Task vertex_face_motion_task();
Task edge_edge_motion_task();
Task closest_hit_task();
Task mesh_pairs_task();
Task mesh_distance_task();
Task closest_point_task();
Task box_pairs_task();
Task nearest_point_task();
Task grid_walk_task();
Task triangulation_task();
Task welding_task();

/// For test vectors alone: no task of the report.
Task ray_mesh_task();

}  // namespace plumb::lab::trial
