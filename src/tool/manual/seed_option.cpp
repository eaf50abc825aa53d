#include "tool/manual/command.hpp"

namespace plumb::tool {

void add_seed(CLI::App* parser, std::uint64_t& seed, const std::string& about) {
  parser->add_option("--seed", seed, about + " 2026 when not given.")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return text.starts_with('-') ? "a whole number from 0 is wanted, not " + text : std::string();
          },
          ""))
      ->type_name("N");
}

}  // namespace plumb::tool
