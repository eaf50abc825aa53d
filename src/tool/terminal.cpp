#include "terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "plumb/arith/error.hpp"

namespace plumb::tool {
namespace {

[[noreturn]] void fail(std::string_view output, int error) {
  throw Error(fmt::format("cannot write {}: {}", output, std::strerror(error)));
}

bool wants_color(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  const char* term = std::getenv("TERM");          // NOLINT(concurrency-mt-unsafe)
  const bool refused = no_color != nullptr && *no_color != '\0';
  return !refused && term != nullptr && std::string_view(term) != "dumb" && is_terminal(stream);
}

}  // namespace

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

int terminal_width(std::FILE* stream) {
  winsize size{};
  const bool known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

Style::Style(std::FILE* stream) : colored_(wants_color(stream)) {}

std::string Style::wrapped(std::string_view code, std::string_view text) const {
  return colored_ ? fmt::format("\033[{}m{}\033[0m", code, text) : std::string(text);
}

void say(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail("standard output", errno);
}

void flush_output() {
  if (std::fflush(stdout) != 0) fail("standard output", errno);
}

std::string printable(std::string_view text) {
  std::string s(text);
  std::ranges::replace_if(
      s, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return s;
}

void complain(std::string_view text) {
  std::fflush(stdout);  // answers given before the fault come first; whether they arrived no longer matters
  // Where standard error is closed the exit status alone speaks.
  std::fputs(fmt::format("{} {}\n", Style(stderr).red("plumb:"), text).c_str(), stderr);
}

void require_writable(const std::string& path) {
  if (path == "-") return;
  std::FILE* file = std::fopen(path.c_str(), "ab");
  if (file == nullptr) fail(path, errno);
  std::fclose(file);
}

void write_text_file(const std::string& path, std::string_view text) {
  if (path == "-") return say(text);
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "wb"));
  if (file == nullptr || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    fail(path, errno);
  }
  if (std::fclose(file.release()) != 0) fail(path, errno);  // some systems find the disk full only here
}

}  // namespace plumb::tool
