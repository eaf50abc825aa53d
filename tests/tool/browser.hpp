// What does a page do in a browser?  Opens it in a headless Chromium, with a script of the test's at its end.
#pragma once

#include <cstdio>
#include <fstream>
#include <string>

#include "run_program.hpp"

namespace plumb::tool {

/// Whether there is one; says so where there is none.
inline bool has_browser() {
  if (run("command -v chromium").code == 0) return true;
  std::puts("No chromium here: what the page does in a browser is skipped.");
  return false;
}

/// What the page is after the script, in `out`; what the console said is in `err`.
inline Outcome in_browser(const std::string& page, const std::string& script) {
  const Folder folder;
  std::ofstream(folder / "page.html") << page << "<script>{\n" << script << "\n}</script>\n";
  return run("HOME=" + (folder / "home") +
             " timeout 120 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir=" +
             (folder / "profile") + " --dump-dom file://" + (folder / "page.html"));
}

}  // namespace plumb::tool
