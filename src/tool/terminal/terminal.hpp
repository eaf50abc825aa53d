// How does the program speak?  Colors where a terminal shows them, and output that is known to have arrived.
//
// Laws: (1) no escape sequence reaches a stream that is no terminal, nor any stream when TERM is "dumb" or not set, and
// no color any stream when NO_COLOR is set to something (no-color.org); (2) a full disk or a closed stream is an Error, never a silent success; a
// reader that left ends the run quietly.
// Source: none.
// Cost: one system call a stream.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace plumb::tool {

/// It is a terminal, and TERM is set, to another than "dumb".
bool obeys_escapes(std::FILE* stream);

/// Columns of the terminal that shows the stream; 80 where it does not say.
int terminal_width(std::FILE* stream);

/// From now on `complain` begins with this name.
void be_named(std::string_view program);

/// From now on, whatever the streams and the environment are.
void never_color();
void be_quiet();
[[nodiscard]] bool is_quiet();

class Style {
 public:
  /// Colors as suits the stream.
  explicit Style(std::FILE* stream);
  explicit Style(bool colored) : colored_(colored) {}

  [[nodiscard]] std::string bold(std::string_view text) const { return wrapped("1", text); }
  [[nodiscard]] std::string dim(std::string_view text) const { return wrapped("2", text); }
  [[nodiscard]] std::string red(std::string_view text) const { return wrapped("31", text); }
  [[nodiscard]] std::string green(std::string_view text) const { return wrapped("32", text); }
  [[nodiscard]] std::string yellow(std::string_view text) const { return wrapped("33", text); }

 private:
  [[nodiscard]] std::string wrapped(std::string_view code, std::string_view text) const;
  bool colored_;
};

/// Who read standard output has left, as `| head` does: no error, but nothing more is wanted. No std::exception.
struct ReaderLeft {};

/// Writes to standard output; throws Error or, unless something else outlives it, ReaderLeft.
void put_out(std::string_view text);

/// The same for what was not asked to be written: nothing where the user wants quiet.
void say(std::string_view text);

/// Hands everything said so far to the system; throws as say() does.
void flush_output();

/// From now on what is said to a reader that left is lost, and the run goes on: it has other outputs.
void outlive_reader();
[[nodiscard]] bool reader_left();

/// The text with control characters, which a file's name may hold and a terminal would obey, replaced by '?'.
std::string printable(std::string_view text);

/// One line "plumb: text", or by the name that was given, on standard error, after everything said so far; control characters, which it may have from a
/// file's name, are replaced by '?'.
void complain(std::string_view text);

}  // namespace plumb::tool
