// What does the built program do for its user?  Runs a shell line, in which $PLUMB is the program and $PLUMB_LAB the laboratory, and keeps what it
// wrote and how it ended; also on a terminal, as far as the program can tell.
#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace plumb::tool {

struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// That of this build, or of the one whose libraries this test is linked with.
inline std::string tested_program() {
  const char* const other = std::getenv("PLUMB_TESTED_PROGRAM");
  return other != nullptr ? other : PLUMB_PROGRAM;
}

/// The same of the laboratory; nothing where it is not built.
inline std::string tested_laboratory() {
  const char* const other = std::getenv("PLUMB_TESTED_LABORATORY");
#ifdef PLUMB_LAB_PROGRAM
  return other != nullptr ? other : PLUMB_LAB_PROGRAM;
#else
  return other != nullptr ? other : "";
#endif
}

/// A folder of this test's own, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = "/tmp/plumb-test-XXXXXX";
    path_ = ::mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::system(("rm -rf " + path_).c_str()); }
  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

inline Outcome run(const std::string& line, const std::string& input = "") {
  const Folder folder;
  std::ofstream(folder / "in") << input;
  ::setenv("PLUMB", tested_program().c_str(), 1);
  ::setenv("PLUMB_LAB", tested_laboratory().c_str(), 1);
  const int status = std::system(
      ("{ " + line + "\n} <" + (folder / "in") + " >" + (folder / "out") + " 2>" + (folder / "err")).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder / "out"), content(folder / "err")};
}

/// Every command, as the program tells them.
inline std::vector<std::string> commands(const std::string& program = "$PLUMB") {
  const std::string told = run(program).err, before = "one of ";
  std::vector<std::string> names;
  std::string name;
  for (const char c : told.substr(std::min(told.find(before) + before.size(), told.size()))) {
    if (c == ',' || c == ';') names.push_back(std::exchange(name, ""));
    if (c == ';') break;
    if (c >= 'a' && c <= 'z') name += c;
  }
  return names;
}

/// Whether this machine has terminals to give; says so where it has none, as in a bare chroot.
inline bool has_terminals() {
  int ours = -1, theirs = -1;
  if (::openpty(&ours, &theirs, nullptr, nullptr, nullptr) != 0) {
    std::puts("No pseudo-terminals here: what the program shows on a terminal is skipped.");
    return false;
  }
  ::close(ours);
  ::close(theirs);
  return true;
}

/// With the three standard streams on a terminal; `out` has all that it showed.
inline Outcome run_on_terminal(const std::string& line) {
  ::setenv("PLUMB", tested_program().c_str(), 1);
  ::setenv("PLUMB_LAB", tested_laboratory().c_str(), 1);
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::setenv("TERM", "xterm", 1);
    ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    ::_exit(127);
  }
  Outcome outcome;
  std::array<char, 4096> bytes{};
  for (ssize_t n = 0; (n = ::read(terminal, bytes.data(), bytes.size())) > 0;) {
    outcome.out.append(bytes.data(), static_cast<std::size_t>(n));
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

}  // namespace plumb::tool
