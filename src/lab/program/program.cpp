#include "lab/program/program.hpp"

#include <algorithm>

#include "lab/chart/command.hpp"
#include "lab/stability/command.hpp"
#include "lab/vectors/command.hpp"
#include "tool/manual/help_text.hpp"
#include "tool/manual/parsed_options.hpp"

namespace plumb::lab {
namespace {

Manual laboratory_manual() {
  return {"plumb-lab",
          "the ways of answering geometric questions, on trial",
          {"plumb-lab COMMAND [OPTION]...", "plumb-lab help [COMMAND]"},
          {{"DESCRIPTION", R"(
What does exactness cost, and what does it buy? plumb-lab puts the same
questions to every way that software answers them by, on inputs from
harmless to exactly degenerate, and counts what is wrong. The work itself
is the program plumb's.)"},
           {"COMMANDS", R"(
chart
       Holds the ways of answering geometric questions against each
       other: how often each is wrong, and how long it takes.

stability
       Runs geometric algorithms on inputs that break them, and says what
       one sees of it: a hull lost a corner, a loop did not end.

vectors
       Writes test vectors for other programs: inputs with their exact
       answers, in text files.

help [COMMAND]
       Shows the page of a command, or writes all as manual pages.

completion SHELL
       Prints what lets bash, zsh or fish complete a command line.)"}},
          {{"EXIT STATUS", exit_status("An exact method was found to be wrong.")},
           {"OUTPUTS", R"(
A folder that --out names is made where it is missing; it appears whole
at the end of the run. What else is in it stays.)"},
           {"ENVIRONMENT", environment() + "\n" + environment_of_batches()},
           {"EXAMPLES", R"(
plumb-lab chart --quick --task orient2d --class near_half
       The ways of deciding on which side of a line a point is.)"}}};
}

std::string command_of_plumb(const std::string& word) {
  CLI::App plumb;
  const std::vector<std::string> names = names_of(plumb_facts().commands(plumb));
  return std::ranges::find(names, word) != names.end() ? "that is a command of plumb" : "";
}

}  // namespace

ProgramFacts laboratory_facts(std::span<const trial::Rival> rivals, const std::vector<stability::WorldRival>& worlds) {
  return {"plumb-lab", laboratory_manual,
          [rivals, worlds](CLI::App& app) -> std::vector<Command> {
            return {chart_command(app, rivals), stability_command(app, worlds), vectors_command(app)};
          },
          command_of_plumb};
}

}  // namespace plumb::lab
