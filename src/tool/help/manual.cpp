#include "tool/manual/help_text.hpp"

namespace plumb::tool {
namespace {

const std::string kExitStatus = R"(
0      Done.
2      There is no such command or shell, or the output cannot be
       written. What was wrong stands on standard error.)";

}  // namespace

Manual help_manual() {
  return {"plumb help",
          "how is a command used?",
          {"plumb help [--roff] [COMMAND]", "plumb help --write-pages DIR"},
          {{"DESCRIPTION", R"(
Shows the page of COMMAND, which is that of plumb COMMAND --help, or of
the program. Where plumb was installed, man plumb-COMMAND shows the
same.)"}},
          {{"EXIT STATUS", kExitStatus}, {"EXAMPLES", R"(
plumb help check
       The page of plumb check.

plumb help --roff check | man -l -
       The same, by man.

plumb help --write-pages ~/.local/share
       Manual pages and completion for a program that was not installed.)"}}};
}

Manual completion_manual() {
  return {"plumb completion",
          "what can follow on the command line?",
          {"plumb completion SHELL"},
          {{"DESCRIPTION", R"(
Prints a script that lets SHELL (bash, zsh or fish) complete commands,
options, their values and file names. Where plumb was installed, shells
find the script by themselves.)"}},
          {{"EXIT STATUS", kExitStatus}, {"EXAMPLES", R"(
source <(plumb completion bash)
       Completion in this bash; the same line in ~/.bashrc: in all.

plumb completion zsh > ~/.zfunc/_plumb
       Where ~/.zfunc is in zsh's fpath.

plumb completion fish > ~/.config/fish/completions/plumb.fish
       In every fish.)"}}};
}

}  // namespace plumb::tool
