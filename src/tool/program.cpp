#include "program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <new>

#include "command.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/environment.hpp"
#include "terminal.hpp"

namespace plumb::tool {
namespace {

/// The page of a command, with the options that its parser knows.
std::string manual_page(const Manual& manual, const CLI::App& app, const Style& style) {
  std::vector<ShownOption> options;
  for (const CLI::Option* const option : app.get_options()) {
    ShownOption& shown = options.emplace_back();
    shown.description = option->get_description();
    if (option->get_positional()) {
      shown.names.push_back(option->get_name(true));
      continue;
    }
    for (const std::string& name : option->get_snames()) shown.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) shown.names.push_back("--" + name);
    const std::string type = option->get_type_name();  // "METHOD:{float32,...}": the checks follow the colon
    if (option->get_items_expected_max() > 0) shown.value = type.substr(0, type.find(':'));
  }
  return tool::manual_page(manual, options, style);
}

class Program {
 public:
  explicit Program(std::span<const trial::Rival> rivals) : rivals_(rivals) {
    constexpr const char* page = "Show this page.";
    app_.set_help_flag("-h,--help", page);
    for (const Command& c : commands_) c.parser->set_help_flag("-h,--help", page);
    app_.add_flag("--version", version_, "Print the version.");
  }

  int run(int argc, char** argv) {
    // What follows "--" is kept from the parser, which would not take it for a MESH once there is another.
    char** const end = argv + argc;
    char** const dashes = std::find_if(argv, end, [](const char* word) { return std::string_view(word) == "--"; });
    const std::vector<std::string> rest(dashes == end ? end : dashes + 1, end);
    app_.parse(static_cast<int>(dashes - argv), argv);
    if (version_) {
      say(fmt::format("plumb {}\n", check_environment().version));
      return 0;
    }
    const Command* const c = named();
    if (c != nullptr && c->takes_rest != nullptr) {
      c->takes_rest->insert(c->takes_rest->end(), rest.begin(), rest.end());
    } else if (!rest.empty()) {
      throw CLI::ExtrasError(rest);
    }
    if (c != nullptr) return c->run();
    std::string names;
    for (const Command& known : commands_) names.append(names.empty() ? "" : ", ").append(known.parser->get_name());
    throw Error(fmt::format("a command is needed, one of {}; 'plumb --help' explains", names));
  }

  /// The page of the command that was named, or of the program.
  void help() const {
    const Style style(stdout);
    const Command* const c = named();
    say(c != nullptr ? manual_page(c->manual(), *c->parser, style) : manual_page(program_manual(), app_, style));
  }

  [[nodiscard]] std::string help_hint() const {
    const Command* const c = named();
    return c != nullptr ? fmt::format("'plumb {} --help' explains", c->parser->get_name()) : "'plumb --help' explains";
  }

 private:
  [[nodiscard]] const Command* named() const {
    const auto at = std::ranges::find_if(commands_, [](const Command& c) { return bool(*c.parser); });
    return at == commands_.end() ? nullptr : &*at;
  }

  CLI::App app_;
  bool version_ = false;
  std::span<const trial::Rival> rivals_;
  const std::vector<Command> commands_ = {bounds_command(app_), chart_command(app_, rivals_), check_command(app_),
                                          fuzz_command(app_),   plan_command(app_),           sign_command(app_),
                                          proof_command(app_),  stability_command(app_),      vectors_command(app_),
                                          doctor_command(app_), section_command(app_),        convert_command(app_)};
};

int refuse(std::string_view text) {
  complain(text);
  return 2;
}

/// As a program ends whose reader has left: by the signal that says so, and without a word.
int leave_with_reader() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  return 128 + SIGPIPE;  // where the signal is blocked
}

}  // namespace

int run_program(int argc, char** argv, std::span<const trial::Rival> rivals) try {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that left is learned of where output is written, not by sudden death
  Program program(rivals);
  int code = 0;
  try {
    code = program.run(argc, argv);
  } catch (const CLI::CallForHelp&) {
    program.help();
  } catch (const CLI::ParseError& e) {
    return refuse(fmt::format("{}; {}", e.what(), program.help_hint()));
  }
  flush_output();
  return reader_left() ? leave_with_reader() : code;
} catch (const ReaderLeft&) {
  return leave_with_reader();
} catch (const std::bad_alloc&) {
  return refuse("out of memory");
} catch (const std::exception& e) {
  return refuse(e.what());
}

}  // namespace plumb::tool
