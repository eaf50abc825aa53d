// What does a page do in a browser?  Opens it in a headless Chromium, with a script of the test's at its end.
#pragma once

#include <cstdio>
#include <fstream>
#include <string>

#include "tool/run_program.hpp"

namespace plumb::tool {

/// The command of a Chromium without a window that opens `url` and prints what the page is in the end.
inline std::string browser(const Folder& folder, const std::string& url) {
  return "HOME=" + (folder / "home") +
         " timeout 120 \"$(command -v chromium-headless-shell || command -v chromium)\" --headless --no-sandbox" +
         " --disable-gpu --window-size=1200,900 --enable-logging=stderr --user-data-dir=" + (folder / "profile") +
         " --dump-dom " + url;
}

/// Whether there is one that starts here; says so where there is none (it does not start without /proc).
inline bool has_browser() {
  if (run(browser(Folder(), "about:blank")).code == 0) return true;
  std::puts("No Chromium starts here: what the page does in a browser is skipped.");
  return false;
}

/// What the page is after the script, in `out`; what the console said is in `err`.
inline Outcome in_browser(const std::string& page, const std::string& script) {
  const Folder folder;
  std::ofstream(folder / "page.html") << page << "<script>{\n" << script << "\n}</script>\n";
  return run(browser(folder, "file://" + (folder / "page.html")));
}

}  // namespace plumb::tool
