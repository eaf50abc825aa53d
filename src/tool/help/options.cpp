#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "plumb/arith/error.hpp"
#include "plumb/certify/environment.hpp"
#include "tool/manual/command.hpp"
#include "tool/manual/parsed_options.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/suggestion.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

struct HelpOptions {
  Manual (*of_program)();
  std::string (*instead)(const std::string& word);
  std::string command{};
  bool roff = false;
  std::optional<std::string> pages{};  // a folder such as /usr/share
};

std::string roff_of(const CLI::App& program, Manual (*of_program)(), const std::vector<Command>& commands,
                    const Command* command) {
  std::vector<std::string> also;
  if (command != nullptr) {
    also = {program.get_name()};
  } else {
    for (const std::string& name : names_of(commands)) also.push_back(program.get_name() + "-" + name);
  }
  return command != nullptr
             ? roff_page(command->manual(), shown_options(*command->parser), check_environment().version, also)
             : roff_page(of_program(), shown_options(program), check_environment().version, also);
}

int write_pages(const fs::path& folder, const CLI::App& program, Manual (*of_program)(),
                const std::vector<Command>& commands) {
  const std::string name = program.get_name();
  std::vector<std::pair<fs::path, std::string>> pages{
      {"man/man1/" + name + ".1", roff_of(program, of_program, commands, nullptr)}};
  for (const Command& c : commands)
    pages.emplace_back(fmt::format("man/man1/{}-{}.1", name, c.parser->get_name()),
                       roff_of(program, of_program, commands, &c));
  for (const ShellScript& s : shell_scripts)
    pages.emplace_back(s.place(name), s.script(name, shapes_of(program, commands)));
  std::vector<PathAndText> files;
  std::vector<fs::path> folders;
  const auto add_parents = [&folders](const fs::path& file) {
    fs::path parent;
    for (const fs::path& step : file.parent_path()) folders.push_back(parent /= step);
  };
  for (const auto& [place, text] : pages) {
    files.push_back({folder / place, text});
    add_parents(files.back().path);
  }
  for (const fs::path& parent : folders) {
    std::error_code error;
    if (fs::exists(parent, error) && !fs::is_directory(parent, error))
      throw Error(fmt::format("cannot write into {}: it is no folder", printable(parent.string())));
  }
  say(fmt::format("{} files in {}\n", files.size(), printable(folder.string())));
  flush_output();
  keep_files(files, folders);
  return 0;
}

int run_help(const HelpOptions& o, const CLI::App& program, const std::vector<Command>& commands) {
  if (o.pages) return write_pages(*o.pages, program, o.of_program, commands);
  const auto named =
      std::ranges::find_if(commands, [&](const Command& c) { return c.parser->get_name() == o.command; });
  if (!o.command.empty() && named == commands.end()) {
    const std::string other = o.instead(o.command);
    throw Error(fmt::format("there is no command {}{}; '{} help' lists the commands", printable(o.command),
                            other.empty() ? suggestion(o.command, names_of(commands)) : ": " + other,
                            program.get_name()));
  }
  const Command* const command = o.command.empty() ? nullptr : &*named;
  if (o.roff) {
    say(roff_of(program, o.of_program, commands, command));
  } else {
    show_page(program, command, o.of_program);
  }
  return 0;
}

}  // namespace

void show_page(const CLI::App& program, const Command* command, Manual (*of_program)()) {
  const Style style(stdout);
  say(command != nullptr ? manual_page(command->manual(), shown_options(*command->parser), style)
                         : manual_page(of_program(), shown_options(program), style));
}

Command help_command(CLI::App& program, const Commands& commands, Manual (*of_program)(),
                     std::string (*instead)(const std::string& word)) {
  const auto options = std::make_shared<HelpOptions>(HelpOptions{of_program, instead});
  CLI::App* const parser = program.add_subcommand("help", "Show the page of a command.");
  parser->add_option("COMMAND", options->command, "Whose page; the program's when not given.");
  CLI::Option* const roff = parser->add_flag("--roff", options->roff, "Print the page as source for man(1).");
  parser
      ->add_option("--write-pages", options->pages,
                   "Write the manual pages of all commands, and what lets shells complete, into this folder where they "
                   "look for them: /usr/local/share, or ~/.local/share.")
      ->type_name("DIR")
      ->excludes(roff);
  return {parser,
          help_manual,
          [options, commands, &program] { return run_help(*options, program, commands()); },
          nullptr,
          {{"COMMAND", [commands] { return names_of(commands()); }}}};
}

Command completion_command(CLI::App& program, const Commands& commands) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* const parser = program.add_subcommand("completion", "Print what lets a shell complete a command line.");
  std::vector<std::string> shells;
  for (const ShellScript& s : shell_scripts) shells.emplace_back(s.shell);
  parser->add_option("SHELL", *shell, "bash, zsh or fish.")->required()->check(CLI::IsMember(shells));
  const auto run = [shell, commands, &program] {
    say(std::ranges::find(shell_scripts, *shell, &ShellScript::shell)
            ->script(program.get_name(), shapes_of(program, commands())));
    return 0;
  };
  return {parser, completion_manual, run};
}

}  // namespace plumb::tool
