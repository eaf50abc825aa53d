#include "tool/program/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <new>

#include "plumb/arith/error.hpp"
#include "plumb/certify/environment.hpp"
#include "tool/manual/command.hpp"
#include "tool/manual/parsed_options.hpp"
#include "tool/terminal/out_of_memory.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

class Program {
 public:
  explicit Program(const ProgramFacts& facts) : facts_(facts), app_("", facts.name), commands_(facts.commands(app_)) {
    commands_.push_back(help_command(app_, known_, facts.manual, facts.instead));
    commands_.push_back(completion_command(app_, known_));
    app_.require_subcommand(0, 1);  // once there is a command, the next word is no other, but may be a file of its name
    add_common_options(app_);
    for (const Command& c : commands_) {
      for (CLI::Option* const option : c.parser->get_options()) {
        if (option->get_expected_max() == 1) option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
      }
      add_common_options(*c.parser);
    }
  }

  int run(int argc, char** argv) {
    // What follows "--" is kept from the parser, which would not take it for a MESH once there is another.
    char** const end = argv + argc;
    char** const dashes = std::find_if(argv, end, [](const char* word) { return std::string_view(word) == "--"; });
    app_.parse(static_cast<int>(dashes - argv), argv);
    if (dashes != end) take_rest({dashes + 1, end});
    if (no_color_) never_color();
    if (quiet_) be_quiet();
    if (const Command* const c = named()) return c->run();
    throw Error(fmt::format("a command is needed, one of {}; '{} help' explains", fmt::join(names_of(commands_), ", "),
                            facts_.name));
  }

  /// The page of the command that was named, or of the program.
  void help() const {
    require_command();
    show_page(app_, named(), facts_.manual);
  }

  void version() const {
    require_command();
    say(fmt::format("{} {}\n", facts_.name, check_environment().version));
  }

  /// What stood where nothing is expected.
  [[nodiscard]] std::string extras() const {
    const Command* const c = named();
    const bool of_command = c != nullptr && !c->parser->remaining().empty();
    const CLI::App& parser = of_command ? *c->parser : app_;
    return why_not_taken(parser, parser.remaining(), commands_, facts_.instead);
  }

  /// Of an option that was given nothing; the parser names it before a colon.
  [[nodiscard]] std::string without_value(std::string_view fault) const {
    const std::string name(fault.substr(0, fault.find(':')));
    const Command* const c = named();
    for (const ShownOption& o : shown_options(c != nullptr ? *c->parser : app_)) {
      if (std::ranges::find(o.names, name) != o.names.end() && !o.value.empty())
        return fmt::format("{0} needs a value: write '{0}{1}'", name, o.shown_value());
    }
    return std::string(fault);
  }

  [[nodiscard]] std::string help_hint() const {
    const Command* const c = named();
    return c != nullptr ? fmt::format("'{} {} --help' explains", facts_.name, c->parser->get_name())
                        : fmt::format("'{} help' explains", facts_.name);
  }

 private:
  void add_common_options(CLI::App& parser) {
    parser.add_flag("--no-color", no_color_, "No colors, also where the output is a terminal.");
    parser.add_flag("-q,--quiet", quiet_,
                    "Say nothing on standard output and show no progress; the exit status and the files that were "
                    "asked for remain.");
    parser.set_help_flag("-h,--help", "Show this page.");
    parser.set_version_flag("-V,--version", "", "Print the version.");
  }

  [[nodiscard]] const Command* named() const {
    const auto at = std::ranges::find_if(commands_, [](const Command& c) { return bool(*c.parser); });
    return at == commands_.end() ? nullptr : &*at;
  }

  /// Help on a command that there is not would be the wrong help.
  void require_command() const {
    if (named() == nullptr && !app_.remaining().empty()) throw CLI::ExtrasError(app_.remaining());
  }

  void take_rest(const std::vector<std::string>& rest) {
    const Command* const c = named();
    if (c != nullptr && c->takes_rest != nullptr) {
      c->takes_rest->insert(c->takes_rest->end(), rest.begin(), rest.end());
      return;
    }
    const std::vector<CLI::Option*> arguments = (c != nullptr ? c->parser : &app_)->get_options([](CLI::Option* o) {
      return o->get_positional() && o->empty();
    });
    if (rest.size() > arguments.size()) {
      throw Error(fmt::format(
          "{}; {}", why_not_taken(c != nullptr ? *c->parser : app_, rest, commands_, facts_.instead), help_hint()));
    }
    for (std::size_t k = 0; k < rest.size(); ++k) {
      arguments[k]->add_result(rest[k]);
      arguments[k]->run_callback();
    }
  }

  const ProgramFacts& facts_;
  CLI::App app_;
  bool no_color_ = false, quiet_ = false;
  const Commands known_ = [this]() -> const std::vector<Command>& { return commands_; };
  std::vector<Command> commands_;
};

int refuse(std::string_view text) {
  complain(text);
  return 2;
}

int run_parsed(Program& program, int argc, char** argv) try {
  return program.run(argc, argv);
} catch (const CLI::CallForHelp&) {
  program.help();
  return 0;
} catch (const CLI::CallForVersion&) {
  program.version();
  return 0;
}

/// As a program ends whose reader has left: by the signal that says so, and without a word.
int leave_with_reader() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  return 128 + SIGPIPE;  // where the signal is blocked
}

}  // namespace

int run_program(const ProgramFacts& facts, int argc, char** argv) try {
  be_named(facts.name);
  end_without_memory(facts.name, argc, argv);
  std::signal(SIGPIPE, SIG_IGN);  // a reader that left is learned of where output is written, not by sudden death
  std::signal(SIGXFSZ, SIG_IGN);  // and so of a file that may not grow so large (ulimit -f)
  Program program(facts);
  int code = 0;
  try {
    code = run_parsed(program, argc, argv);
  } catch (const CLI::ExtrasError&) {
    return refuse(fmt::format("{}; {}", program.extras(), program.help_hint()));
  } catch (const CLI::ArgumentMismatch& e) {
    return refuse(fmt::format("{}; {}", program.without_value(e.what()), program.help_hint()));
  } catch (const CLI::ParseError& e) {
    return refuse(fmt::format("{}; {}", e.what(), program.help_hint()));
  }
  flush_output();
  return reader_left() ? leave_with_reader() : code;
} catch (const ReaderLeft&) {
  return leave_with_reader();
} catch (const std::bad_alloc&) {
  say_out_of_memory();
  return 2;
} catch (const std::exception& e) {
  return refuse(e.what());
}

}  // namespace plumb::tool
