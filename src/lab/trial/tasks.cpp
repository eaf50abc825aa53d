#include "lab/trial/tasks.hpp"

#include <array>

namespace plumb::lab::trial {

std::vector<Task> all_tasks(std::span<const Rival> rivals) {
  std::vector<Task> tasks;
  constexpr std::array makers{orient2d_task,
                              orient3d_task,
                              incircle_task,
                              insphere_task,
                              segment_segment_task,
                              ray_triangle_task,
                              segment_triangle_task,
                              triangle_triangle_task,
                              box_box_task,
                              oriented_boxes_task,
                              point_in_polygon_task,
                              point_in_polyhedron_task,
                              hull2_task,
                              hull3_task,
                              smallest_ball_task,
                              point_segment_distance_task,
                              point_box_distance_task,
                              point_triangle_distance_task,
                              segment_segment_distance_task,
                              convex_meeting_task,
                              convex_distance_task,
                              vertex_face_motion_task,
                              edge_edge_motion_task,
                              closest_hit_task,
                              mesh_pairs_task,
                              mesh_distance_task,
                              closest_point_task,
                              box_pairs_task,
                              nearest_point_task,
                              grid_walk_task,
                              triangulation_task,
                              welding_task};
  for (const auto make : makers) tasks.push_back(make());
  for (Task& task : tasks) {
    for (const Rival& rival : rivals) {
      if (rival.task == task.name) task.methods.push_back(rival.method);
    }
  }
  return tasks;
}

}  // namespace plumb::lab::trial
