#include "tool/manual/command.hpp"

namespace plumb::tool {

void add_output(CLI::App* parser, const std::string& option, std::optional<std::string>& path,
                const std::string& about) {
  parser->add_option(option, path, about + "; '-' or no name is standard output.")
      ->expected(0, 1)
      ->default_str("-")  // of the option without a name
      ->type_name("FILE");
}

}  // namespace plumb::tool
