#include "tool/trial/predicate_task.hpp"

namespace plumb::tool::trial {

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

}  // namespace plumb::tool::trial
