#include "degenerate/families_of_cases.hpp"

#include "plumb/degenerate/points.hpp"

namespace plumb::degenerate {

std::vector<Generator> families_of_cases(std::optional<Degeneracy> aim, const ArrangeBy& arrange) {
  std::vector<Generator> all;
  const auto add = [&](std::string_view name, std::string_view about, const FillOf& fill) {
    all.push_back({std::string(name), std::string(about),
                   [arrange, fill](Numbers& numbers, Entropy& entropy) { arrange(numbers, entropy, fill); }});
  };
  for (const FamilyInfo& info : families) {
    add(info.name, info.about, [family = info.family, aim](int dimension, std::span<double> c, Entropy& entropy) {
      fill_points(family, aim ? *aim : degeneracies[entropy.below(degeneracies.size())], dimension, c, entropy);
    });
  }
  add("touching", "integers from -2 to 2", [](int, std::span<double> c, Entropy& entropy) {
    for (double& x : c) x = static_cast<double>(entropy.within(2));
  });
  return all;
}

}  // namespace plumb::degenerate
