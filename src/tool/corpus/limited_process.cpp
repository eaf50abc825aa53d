#include "tool/corpus/limited_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr int no_memory_code = 2;  // as out_of_memory.hpp ends a run
constexpr int refused_code = 3;

/// A descriptor that is closed once.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  [[nodiscard]] int number() const { return number_; }
  void close() {
    if (const int open = std::exchange(number_, -1); open >= 0) ::close(open);
  }

 private:
  int number_;
};

[[noreturn]] void no_process(std::string_view step) {
  throw Error(fmt::format("cannot make a process for a model: {}: {}", step, std::strerror(errno)));
}

void limit_address_space(std::uint64_t mib) {
  unsigned long pages = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r"); file != nullptr) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    static_cast<void>(std::fclose(file));
  }
  const auto most = static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (rlim_t{mib} << 20);
  const rlimit limit{most, most};
  ::setrlimit(RLIMIT_AS, &limit);
}

void write_all(int to, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(to, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) ::_exit(refused_code);
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

bool means_no_memory(const std::system_error& e) {
  return e.code() == std::errc::resource_unavailable_try_again || e.code() == std::errc::not_enough_memory;
}

/// In the new process: nothing here returns, and no buffer or destructor that is also the other's is touched.
[[noreturn]] void work_and_leave(const ProcessLimits& limits, pid_t parent, int told, int said,
                                 const std::function<std::string()>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(refused_code);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nowhere, STDIN_FILENO), ::dup2(nowhere, STDOUT_FILENO), ::dup2(said, STDERR_FILENO);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (limits.mib) limit_address_space(*limits.mib);
  try {
    write_all(told, work());
    ::_exit(0);
  } catch (const std::bad_alloc&) {
    ::_exit(no_memory_code);
  } catch (const std::system_error& e) {
    if (means_no_memory(e)) ::_exit(no_memory_code);
    write_all(STDERR_FILENO, e.what());
  } catch (const std::exception& e) {
    write_all(STDERR_FILENO, e.what());
  }
  ::_exit(refused_code);
}

/// Milliseconds for poll(): -1 without an end.
int left_until(const std::optional<SteadyClock::time_point>& end) {
  if (!end) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - SteadyClock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, INT_MAX));
}

/// All that comes until the other end is closed; false where the time is over before.
bool read_until(int from, const std::optional<SteadyClock::time_point>& end, std::string& text) {
  std::array<char, 1 << 14> chunk;
  while (true) {
    pollfd ready{from, POLLIN, 0};
    const int n = ::poll(&ready, 1, left_until(end));
    if (n < 0 && errno == EINTR) continue;
    if (n == 0 && end && SteadyClock::now() >= *end) return false;
    if (n <= 0) continue;
    const ssize_t got = ::read(from, chunk.data(), chunk.size());
    if (got > 0) text.append(chunk.data(), static_cast<std::size_t>(got));
    if (got == 0) return true;
  }
}

/// The end of what was said.
std::string last_words(int said) {
  constexpr off_t most = 500;
  const off_t size = ::lseek(said, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, most)), ' ');
  const ssize_t got = ::pread(said, text.data(), text.size(), std::max<off_t>(0, size - most));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return printable(text);
}

std::string why_crashed(int status, const std::string& words) {
  std::string why;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    why = fmt::format("ended by signal {} ({}){}", signal, ::strsignal(signal),
                      signal == SIGKILL ? ", as the system ends what takes too much memory" : "");
  } else {
    why = fmt::format("ended with {}", WEXITSTATUS(status));
  }
  return words.empty() ? why : why + ": " + words;
}

}  // namespace

ProcessEnd run_limited(const ProcessLimits& limits, const std::function<std::string()>& work) {
  flush_output();  // what waits in a buffer would be written by both
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) no_process("pipe");
  Descriptor from(ends[0]), to(ends[1]);
  const Descriptor said(::memfd_create("plumb", MFD_CLOEXEC));
  if (said.number() < 0) no_process("memory for what it says");
  const auto begin = SteadyClock::now();
  std::optional<SteadyClock::time_point> end;
  if (limits.seconds)
    end = begin + std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(*limits.seconds));
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) no_process("fork");
  if (child == 0) work_and_leave(limits, parent, to.number(), said.number(), work);
  to.close();
  ProcessEnd found;
  const bool in_time = read_until(from.number(), end, found.text);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  found.seconds = std::chrono::duration<double>(SteadyClock::now() - begin).count();
  found.peak_mib = static_cast<double>(used.ru_maxrss) / 1024;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && in_time) {
    found.how = HowEnded::done;
    return found;
  }
  found.text.clear();
  if (!in_time) {
    found.how = HowEnded::timeout;
    found.why = fmt::format("took more than {} s", *limits.seconds);
  } else if (WIFEXITED(status) && WEXITSTATUS(status) == no_memory_code) {
    found.how = HowEnded::out_of_memory;
    found.why = limits.mib ? fmt::format("took more than {} MiB", *limits.mib) : "there was no more memory";
  } else {
    found.why = why_crashed(status, last_words(said.number()));
  }
  return found;
}

}  // namespace plumb::tool
