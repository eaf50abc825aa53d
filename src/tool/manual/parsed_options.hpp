// What does a parser tell of itself?  Its options, for pages and for shells, and what was meant by a word that is none.
//
// Law: nothing is said of an option twice: all is taken from the parser.
// Source: none.
// Cost: none worth a word.
#pragma once

#include <string>
#include <vector>

#include "tool/manual/command.hpp"
#include "tool/manual/completion.hpp"
#include "tool/manual/man_page.hpp"

namespace plumb::tool {

std::vector<ShownOption> shown_options(const CLI::App& parser);

/// With what its options may be.
CommandShape shape_of(const Command& command);

/// The program by itself, then its commands.
std::vector<CommandShape> shapes_of(const CLI::App& program, const std::vector<Command>& commands);

std::vector<std::string> names_of(const std::vector<Command>& commands);

/// "there is no option --jsno (did you mean --json?)", of the first word that the parser did not take; `instead` says what
/// a command's place is taken by.
std::string why_not_taken(const CLI::App& parser, const std::vector<std::string>& words,
                          const std::vector<Command>& commands, std::string (*instead)(const std::string& word));

}  // namespace plumb::tool
