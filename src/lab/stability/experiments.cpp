#include "lab/stability/experiment.hpp"

namespace plumb::lab::stability {

std::vector<Experiment> all_experiments(const std::vector<WorldRival>& worlds) {
  return {grid_experiment(),       hull_experiment(),          space_hull_experiment(), segment_experiment(),
          sweep_experiment(),      location_experiment(),      leak_experiment(),       box_experiment(),
          convex_experiment(),     move_experiment(),          pose_experiment(),       distance_experiment(),
          ball_experiment(),       motion_experiment(),        touch_experiment(),      neighbor_experiment(),
          walk_experiment(),       triangulation_experiment(), welding_experiment(),    boolean_experiment(),
          world_experiment(worlds)};
}

}  // namespace plumb::lab::stability
