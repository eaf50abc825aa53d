#include "tool/fuzz/foreign_child.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "tool/terminal/out_of_memory.hpp"

namespace plumb::tool {
namespace {

constexpr int kOver = 0;  // how a child ends whose program is gone or has said enough

void set_text(ForeignBoard& board, std::string_view text) {
  const std::size_t length = std::min(text.size(), board.text.size() - 1);
  std::memcpy(board.text.data(), text.data(), length);
  board.text[length] = '\0';
}

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &both);
}

/// Of the address space: what is taken already counts, sanitizers' shadows too.
void limit_memory(std::uint64_t mib) {
  std::ifstream sizes("/proc/self/statm");
  std::uint64_t pages = 0;
  if (sizes >> pages) limit(RLIMIT_AS, pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + (mib << 20));
}

void shut_in(std::uint64_t memory_mib) {
  obey_memory_no_more();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::setsid();  // so that its own children can be ended with it, Ctrl-C is the program's to answer, and /dev/tty nothing
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) ::dup2(nowhere, stream);
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  std::signal(SIGXFSZ, SIG_IGN);  // that nothing is written is no crash
  limit_memory(memory_mib);
  std::fesetenv(FE_DFL_ENV);  // the program's own exceptions are none of the code that traps them
}

/// A name without a folder is looked for here first, and then where the system keeps libraries.
std::string loadable(const std::string& library) {
  std::error_code ignored;
  return library.find('/') == std::string::npos && std::filesystem::exists(library, ignored)
             ? std::string("./").append(library)
             : library;
}

/// Nothing where it was found, else why not.
std::string find_function(const ForeignCode& code, degenerate::ForeignFunction& function) {
  const std::string path = loadable(code.library);
  void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    std::string_view why = reason == nullptr ? "no reason given" : reason;
    if (why.starts_with(path)) why.remove_prefix(path.size());
    return fmt::format("cannot load {}{}{}; a shared library for this machine is wanted", code.library,
                       why.starts_with(':') ? "" : ": ", why);
  }
  ::dlerror();
  void* const address = ::dlsym(library, code.symbol.c_str());
  if (address == nullptr) {
    return fmt::format(
        "{} has no symbol {}; a C function is wanted (in C++ declare it extern \"C\"), and `nm -D {}` "
        "lists what there is",
        code.library, code.symbol, code.library);
  }
  Dl_info info{};
  void* entry = nullptr;
  const int found = ::dladdr1(address, &info, &entry, RTLD_DL_SYMENT);
  if (found != 0 && entry != nullptr && info.dli_saddr == address) {
    const int type = ELF64_ST_TYPE(static_cast<const ElfW(Sym)*>(entry)->st_info);  // the same bits in 32-bit files
    if (type == STT_OBJECT || type == STT_TLS || type == STT_COMMON)
      return fmt::format("{} in {} is data; a function is wanted", code.symbol, code.library);
  }
  function = reinterpret_cast<degenerate::ForeignFunction>(address);
  return {};
}

/// Room for arguments, each of which ends where readable memory ends.
class Guarded {
 public:
  explicit Guarded(std::size_t arguments) {
    static_assert(sizeof(std::size_t) <= sizeof(double));
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const std::size_t bytes = (ForeignBoard::most_numbers * sizeof(double) + page - 1) / page * page;
    for (std::size_t i = 0; i < arguments; ++i) {
      void* const place = ::mmap(nullptr, bytes + page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (place == MAP_FAILED || ::mprotect(place, bytes, PROT_READ | PROT_WRITE) != 0) return;
      ends_.push_back(static_cast<char*>(place) + bytes);
    }
  }
  [[nodiscard]] bool made(std::size_t arguments) const { return ends_.size() == arguments; }
  [[nodiscard]] void* room(std::size_t argument, std::size_t bytes) const { return ends_[argument] - bytes; }

 private:
  std::vector<char*> ends_;
};

void answer_batch(const ForeignCode& code, degenerate::ForeignFunction function, ForeignBoard& board,
                  const degenerate::Room& room) {
  using Ended = ForeignBoard::Ended;
  std::uint32_t used = 0;
  for (std::uint64_t i = 0; i < board.cases; ++i) {
    const std::span<const double> numbers(board.numbers.data() + board.begin[i], board.begin[i + 1] - board.begin[i]);
    degenerate::Numbers answer;
    board.at.store(i, std::memory_order_release);
    Ended ended = Ended::answered;
    try {
      answer = ask(code.kind, function, numbers, room).numbers;
    } catch (const std::exception& e) {
      ended = Ended::threw;
      set_text(board, e.what());
    } catch (...) {
      ended = Ended::threw;
      set_text(board, "what is no std::exception");
    }
    if (answer.size() > ForeignBoard::most_answers - used) break;  // the next batch has room
    if (!answer.empty()) std::memcpy(board.answers.data() + used, answer.data(), answer.size() * sizeof(double));
    used += static_cast<std::uint32_t>(answer.size());
    board.answer_end[i] = used;
    board.ended[i] = ended;
    if (ended == Ended::threw) break;  // so that its text is read before the next is written
  }
  board.at.store(ForeignBoard::no_case, std::memory_order_release);
}

bool read_byte(int from) {
  char byte = 0;
  ssize_t n = 0;
  do n = ::read(from, &byte, 1);
  while (n < 0 && errno == EINTR);
  return n == 1;
}

void write_byte(int to) {
  const char byte = 0;
  ssize_t n = 0;
  do n = ::write(to, &byte, 1);
  while (n < 0 && errno == EINTR);
}

}  // namespace

void serve_foreign(const ForeignCode& code, ForeignBoard& board, int requests, int replies) {
  const Guarded guarded(code.kind.arguments.size());
  shut_in(code.memory_mib);
  ::madvise(&board, sizeof board, MADV_DONTFORK);  // a copy of this process that comes back from the call ends here
  degenerate::ForeignFunction function = nullptr;
  std::string refusal = find_function(code, function);
  if (refusal.empty() && !guarded.made(code.kind.arguments.size()))
    refusal = fmt::format("no memory to call {}", code.library);
  const auto room = [&](std::size_t argument, std::size_t bytes) { return guarded.room(argument, bytes); };
  set_text(board, refusal);
  board.state.store(refusal.empty() ? ForeignBoard::State::serving : ForeignBoard::State::refused);
  write_byte(replies);
  while (refusal.empty() && read_byte(requests)) {
    answer_batch(code, function, board, room);
    write_byte(replies);
  }
  ::_exit(kOver);
}

}  // namespace plumb::tool
