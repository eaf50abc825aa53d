// What can follow what is typed?  Scripts that tell the shells, made from what the parser knows.
//
// Laws: (1) every command, option and listed value of the parser is offered, and nothing else: bash, zsh and fish offer
// the same; (2) a script needs its shell alone.
// Source: bash(1) "Programmable Completion", zshcompsys(1), fish's complete(1).
// Cost: none worth a word.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tool/manual/man_page.hpp"

namespace plumb::tool {

struct CommandShape {
  std::string name, about;  // of the program by itself: no name
  std::vector<ShownOption> options;
};

std::string bash_completion(std::span<const CommandShape> commands);
std::string zsh_completion(std::span<const CommandShape> commands);
std::string fish_completion(std::span<const CommandShape> commands);

struct ShellScript {
  std::string_view shell, place;  // below /usr/share
  std::string (*script)(std::span<const CommandShape> commands);
};
inline constexpr std::array shell_scripts{ShellScript{"bash", "bash-completion/completions/plumb", bash_completion},
                                          ShellScript{"zsh", "zsh/site-functions/_plumb", zsh_completion},
                                          ShellScript{"fish", "fish/vendor_completions.d/plumb.fish", fish_completion}};

}  // namespace plumb::tool
