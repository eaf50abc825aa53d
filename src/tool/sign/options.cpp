#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "plumb/arith/error.hpp"
#include "tool/manual/command.hpp"
#include "tool/sign/command.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

Command sign_command(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("sign", "Decide one sign exactly.");
  parser->prefix_command();  // what follows is a case: a leading '-' there is a sign, not an option
  const auto after_dashes = std::make_shared<std::vector<std::string>>();
  const auto run = [parser, after_dashes] {
    std::vector<std::string> words;
    for (const std::string& word : parser->remaining()) {  // options of all commands, also behind a case
      if (word == "--help" || word == "-h") throw CLI::CallForHelp();
      if (word == "--version" || word == "-V") throw CLI::CallForVersion();
      if (word == "--no-color") {
        never_color();
      } else if (word == "--quiet" || word == "-q") {
        be_quiet();
      } else {
        words.push_back(word);
      }
    }
    if (!words.empty() && words.front().starts_with('-')) throw CLI::ExtrasError({words.front()});
    words.insert(words.end(), after_dashes->begin(), after_dashes->end());
    errno = 0;
    const int code = run_sign(words, std::cin);
    // The stream ends alike at the end of a file and at a failure; only the C stream below it knows which it was.
    if (std::ferror(stdin) != 0) throw Error(fmt::format("cannot read standard input: {}", std::strerror(errno)));
    return code;
  };
  return {parser, sign_manual, run, after_dashes.get(), {{"PREDICATE", predicate_names}}};
}

}  // namespace plumb::tool
