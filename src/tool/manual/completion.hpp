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

std::string bash_completion(std::string_view program, std::span<const CommandShape> commands);
std::string zsh_completion(std::string_view program, std::span<const CommandShape> commands);
std::string fish_completion(std::string_view program, std::span<const CommandShape> commands);

struct ShellScript {
  std::string_view shell, before, after;
  std::string (*script)(std::string_view program, std::span<const CommandShape> commands);

  /// Where the shell looks for the script of this program, below /usr/share.
  [[nodiscard]] std::string place(const std::string& program) const {
    return std::string(before).append(program).append(after);
  }
};
inline constexpr std::array shell_scripts{ShellScript{"bash", "bash-completion/completions/", "", bash_completion},
                                          ShellScript{"zsh", "zsh/site-functions/_", "", zsh_completion},
                                          ShellScript{"fish", "fish/vendor_completions.d/", ".fish", fish_completion}};

}  // namespace plumb::tool
