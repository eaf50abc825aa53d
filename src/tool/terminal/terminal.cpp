#include "tool/terminal/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "plumb/arith/error.hpp"

namespace plumb::tool {
namespace {

bool outlives_reader = false, left = false, quiet = false, colorless = false;
std::string_view own_name = "plumb";

void fail_output(int error) {
  if (error != EPIPE) throw Error(fmt::format("cannot write standard output: {}", std::strerror(error)));
  left = true;
  if (!outlives_reader) throw ReaderLeft();
}

bool wants_color(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  const bool refused = no_color != nullptr && *no_color != '\0';
  return !colorless && !refused && obeys_escapes(stream);
}

}  // namespace

bool obeys_escapes(std::FILE* stream) {
  const char* term = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return term != nullptr && std::string_view(term) != "dumb" && ::isatty(::fileno(stream)) == 1;
}

int terminal_width(std::FILE* stream) {
  winsize size{};
  const bool known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

Style::Style(std::FILE* stream) : colored_(wants_color(stream)) {}

std::string Style::wrapped(std::string_view code, std::string_view text) const {
  return colored_ ? fmt::format("\033[{}m{}\033[0m", code, text) : std::string(text);
}

void be_named(std::string_view program) { own_name = program; }

void never_color() { colorless = true; }

void be_quiet() { quiet = true; }

bool is_quiet() { return quiet; }

void say(std::string_view text) {
  if (!quiet) put_out(text);
}

void put_out(std::string_view text) {
  if (!left && std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail_output(errno);
}

void flush_output() {
  if (!left && std::fflush(stdout) != 0) fail_output(errno);
}

void outlive_reader() { outlives_reader = true; }

bool reader_left() { return left; }

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string printable(std::string_view text) {
  std::string s(text);
  std::ranges::replace_if(s, is_control, '?');
  return s;
}

void complain(std::string_view text) {
  std::fflush(stdout);  // answers given before the fault come first; whether they arrived no longer matters
  std::string shown(text);
  std::ranges::replace_if(
      shown, [](char c) { return is_control(c) && c != '\n'; }, '?');
  // Where standard error is closed the exit status alone speaks.
  std::fputs(fmt::format("{} {}\n", Style(stderr).red(std::string(own_name) + ":"), shown).c_str(), stderr);
}

}  // namespace plumb::tool
