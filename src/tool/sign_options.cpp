#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "command.hpp"
#include "plumb/arith/error.hpp"
#include "sign_command.hpp"

namespace plumb::tool {

Command sign_command(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("sign", "Decide one sign exactly.");
  parser->prefix_command();  // what follows is a case: a leading '-' there is a sign, not an option
  const auto after_dashes = std::make_shared<std::vector<std::string>>();
  const auto run = [parser, after_dashes] {
    std::vector<std::string> words = parser->remaining();
    words.insert(words.end(), after_dashes->begin(), after_dashes->end());
    if (std::ranges::any_of(words, [](const std::string& w) { return w == "--help" || w == "-h"; }))
      throw CLI::CallForHelp();
    if (!words.empty() && words.front().starts_with('-')) throw CLI::ExtrasError({words.front()});
    errno = 0;
    const int code = run_sign(words, std::cin);
    // The stream ends alike at the end of a file and at a failure; only the C stream below it knows which it was.
    if (std::ferror(stdin) != 0) throw Error(fmt::format("cannot read standard input: {}", std::strerror(errno)));
    return code;
  };
  return {parser, sign_manual, run, after_dashes.get()};
}

}  // namespace plumb::tool
