// Does Gappa prove this script?  Runs the program as a user would.
//
// Law: where it is not installed, the tests that need it say so on standard output and prove nothing.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace plumb::gappa {

struct Answer {
  int code = -1;
  std::string text;  // of both output streams
};

/// Runs a shell line in a folder of its own, in which the file `claim` has this script.
inline Answer run(const std::string& script, const std::string& line) {
  std::string folder = (std::filesystem::temp_directory_path() / "plumb-gappa-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return {-1, "no folder for the proofs: " + folder};
  std::ofstream(folder + "/claim") << script;
  const int status = std::system(("cd '" + folder + "' && { " + line + "\n} >answer 2>&1 </dev/null").c_str());
  std::ifstream in(folder + "/answer");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove_all(folder);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

inline bool is_installed() {
  static const bool found = run("", "command -v gappa").code == 0;
  if (!found) std::puts("SKIPPED: gappa is not installed (apt-get install gappa), so no bound is proved here.");
  return found;
}

inline Answer prove(const std::string& script) { return run(script, "timeout 300 gappa claim"); }

/// Gappa read the script and did not find a proof; a script that it cannot read is an error of ours.  It is kept from
/// cutting intervals into pieces until it gives up, which takes minutes and which no proof of ours needs.
inline bool refuses(const std::string& script) {
  const Answer answer = run(script, "timeout 300 gappa -Eno-auto-dichotomy claim");
  return answer.code != 0 && answer.text.find("some properties were not satisfied") != std::string::npos;
}

}  // namespace plumb::gappa
