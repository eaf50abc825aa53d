#include "tool/stability/experiment.hpp"

namespace plumb::tool::stability {

std::vector<Experiment> all_experiments() {
  return {grid_experiment(), hull_experiment(), segment_experiment(), sweep_experiment()};
}

}  // namespace plumb::tool::stability
