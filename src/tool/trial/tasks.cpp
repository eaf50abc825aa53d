#include <algorithm>
#include <array>
#include <cmath>

#include "tool/trial/predicate_task.hpp"

namespace plumb::tool::trial {

Scene scene_of(std::span<const double> coordinates) {
  double largest = 0;
  for (const double x : coordinates) largest = std::max(largest, std::fabs(x));
  return {lattice_of(coordinates), largest};
}

Method prepared_by(std::string_view name, std::string_view about, Prepare* prepare) {
  return {std::string(name), std::string(about), prepare};
}

std::vector<InputClass> point_classes(Degeneracy degeneracy, int dimension) {
  std::vector<InputClass> classes;
  for (const FamilyInfo& info : families) {
    classes.push_back({std::string(info.name), std::string(info.about),
                       [=, family = info.family](std::span<double> question, Entropy& entropy) {
                         fill_points(family, degeneracy, dimension, question, entropy);
                       }});
  }
  classes.push_back(
      {"lattice20", "exactly degenerate integers of 20 bits", [=](std::span<double> question, Entropy& entropy) {
         fill_exact(degeneracy, dimension, 20, question, entropy);
       }});
  return classes;
}

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
                              grid_walk_task};
  for (const auto make : makers) tasks.push_back(make());
  for (Task& task : tasks) {
    for (const Rival& rival : rivals) {
      if (rival.task == task.name) task.methods.push_back(rival.method);
    }
  }
  return tasks;
}

}  // namespace plumb::tool::trial
