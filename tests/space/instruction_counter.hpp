// How many instructions does this program run?  The processor's counter says it where there is one; else callgrind, under
// which the program runs once more.
#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define PLUMB_HAS_CALLGRIND 1
#else
#define PLUMB_HAS_CALLGRIND 0
#endif

#if defined(__SANITIZE_ADDRESS__)
#error "instructions are counted of what users run: without sanitizers"
#endif

namespace plumb::cost {

/// Instructions of this thread by the processor's counter.
class InstructionCounter {
 public:
  InstructionCounter() {
    perf_event_attr what{};
    what.type = PERF_TYPE_HARDWARE;
    what.size = sizeof what;
    what.config = PERF_COUNT_HW_INSTRUCTIONS;
    what.exclude_kernel = 1;
    what.exclude_hv = 1;
    file_ = static_cast<int>(::syscall(SYS_perf_event_open, &what, 0, -1, -1, 0));
  }
  ~InstructionCounter() {
    if (file_ >= 0) ::close(file_);
  }
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;
  [[nodiscard]] bool counts() const { return file_ >= 0 && now() > 0; }
  [[nodiscard]] double now() const {
    std::uint64_t count = 0;
    return ::read(file_, &count, sizeof count) == sizeof count ? static_cast<double>(count) : 0;
  }

 private:
  int file_ = -1;
};

inline constexpr const char* under_callgrind = "PLUMB_COUNTS_UNDER_CALLGRIND";

inline bool is_counted_by_callgrind() { return std::getenv(under_callgrind) != nullptr; }

/// By this program again; nothing where valgrind is not there.
inline std::vector<double> counts_by_callgrind(const std::string& test) {
  std::vector<double> counts;
#if PLUMB_HAS_CALLGRIND
  std::string folder = (std::filesystem::temp_directory_path() / "plumb_cost_XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return counts;
  const std::string out = "--callgrind-out-file=" + folder + "/counts";
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string filter = "--gtest_filter=" + test;
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv(under_callgrind, "1", 1);
    ::execlp("valgrind", "valgrind", "--quiet", "--tool=callgrind", "--dump-line=no", out.c_str(), self.c_str(),
             filter.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  for (int i = 1; WIFEXITED(status) && WEXITSTATUS(status) == 0; ++i) {
    std::ifstream file(folder + "/counts." + std::to_string(i));
    bool is_counted = false;
    double total = -1;
    for (std::string line; std::getline(file, line);) {
      is_counted = is_counted || line.ends_with("counted");
      if (line.starts_with("totals: ")) total = std::stod(line.substr(8));
    }
    if (!is_counted || total < 0) break;
    counts.push_back(total);
  }
  std::filesystem::remove_all(folder);
#endif
  return counts;
}

}  // namespace plumb::cost
