#include <fmt/format.h>

#include "tool/manual/command.hpp"

namespace plumb::tool {

void add_placements(CLI::App* parser, std::uint32_t& placements, double& refined_ns) {
  parser
      ->add_option("--placements", placements,
                   fmt::format("How many placements of two copies; {} when not given.", placements))
      ->check(CLI::Range(1U, 1'000'000U))
      ->type_name("N");
  parser
      ->add_option("--refined", refined_ns,
                   fmt::format("What the test behind the bounds costs, in nanoseconds; {} when not given.", refined_ns))
      ->check(CLI::Range(0.0, 1e12))
      ->type_name("NS");
}

}  // namespace plumb::tool
