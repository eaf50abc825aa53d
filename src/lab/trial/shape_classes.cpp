#include <array>

#include "lab/trial/float_methods.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::lab::trial {

Symmetry reordered(std::size_t dimension, const std::vector<std::size_t>& order) {
  Symmetry s{{}, 1};
  for (const std::size_t point : order) {
    for (std::size_t axis = 0; axis < dimension; ++axis)
      s.from.push_back(static_cast<std::uint8_t>(point * dimension + axis));
  }
  return s;
}

std::vector<InputClass> shape_classes(std::size_t dimension) {
  constexpr std::array chosen{Family::uniform,     Family::float32,  Family::near_half, Family::degenerate_long,
                              Family::off_by_ulps, Family::repeated, Family::extreme};
  std::vector<InputClass> classes;
  for (const Family family : chosen) {
    const FamilyInfo& info = families[static_cast<std::size_t>(family)];
    classes.push_back(
        {std::string(info.name), std::string(info.about), [=](std::span<double> question, Entropy& entropy) {
           const Degeneracy aim = dimension == 2 ? Degeneracy::collinear : Degeneracy::coplanar;
           fill_points(family, aim, static_cast<int>(dimension), question, entropy);
         }});
  }
  classes.push_back({"touching", "integers from -2 to 2", [](std::span<double> question, Entropy& entropy) {
                       for (double& x : question) x = static_cast<double>(entropy.within(2));
                     }});
  return classes;
}

std::vector<InputClass> refilled(std::vector<InputClass> classes, void (*change)(std::span<double> question)) {
  for (InputClass& c : classes) {
    c.fill = [fill = c.fill, change](std::span<double> question, Entropy& entropy) {
      fill(question, entropy);
      change(question);
    };
  }
  return classes;
}

}  // namespace plumb::lab::trial
