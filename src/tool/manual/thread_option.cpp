#include "tool/manual/command.hpp"

namespace plumb::tool {

void add_threads(CLI::App* parser, unsigned& threads) {
  parser->add_option("--threads", threads, "How many threads work; as many as the machine has when not given.")
      ->check(CLI::Range(1U, 4096U))
      ->type_name("N");
}

}  // namespace plumb::tool
