#include "tool/fuzz/foreign_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <thread>
#include <utility>

#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;
using degenerate::Answer;
using degenerate::Numbers;
using degenerate::Outcome;

constexpr milliseconds kGlance(20);  // how often a silent child is looked at
constexpr int kLoading = 10;         // times what a call may take

/// Not among the standard streams, of which some may be closed: the child turns those to nowhere.
std::array<int, 2> make_pipe(const ForeignCode& code) {
  std::array<int, 2> ends{}, high{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) == 0) {
    for (std::size_t i = 0; i < 2; ++i) high[i] = ::fcntl(ends[i], F_DUPFD_CLOEXEC, 3);
    for (const int end : ends) ::close(end);
  }
  if (high[0] < 0 || high[1] < 0)
    throw Error(fmt::format("cannot make a pipe to {}: {}", printable(code.library), std::strerror(errno)));
  return high;
}

/// What the child wrote; it may be anything.
std::string text_on(ForeignBoard& board) {
  board.text.back() = '\0';
  return printable(board.text.data());
}

std::string in_words(const Answer& end) { return fmt::format("{} ({})", name_of(end.outcome), end.note); }

void close_end(int& end) {
  if (end >= 0) ::close(end);
  end = -1;
}

}  // namespace

void ForeignProcess::Unmap::operator()(ForeignBoard* board) const { ::munmap(board, sizeof(ForeignBoard)); }

ForeignProcess::ForeignProcess(ForeignCode code, ForeignLimits limits)
    : code_(std::move(code)),
      limits_(limits),
      replacements_left_(limits.replacements),
      hangs_left_(limits.hangs),
      board_([] {
        void* const place =
            ::mmap(nullptr, sizeof(ForeignBoard), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (place == MAP_FAILED) throw std::bad_alloc();
        return new (place) ForeignBoard;  // its pages are zero, and it has no constructor that would touch them
      }()) {
  start_child();
}

ForeignProcess::~ForeignProcess() { end_child(); }

void ForeignProcess::allow(std::size_t replacements, std::size_t hangs) {
  replacements_left_ = replacements;
  hangs_left_ = hangs;
}

void ForeignProcess::start_child() {
  std::array<int, 2> to = make_pipe(code_), from = make_pipe(code_);
  board_->state = ForeignBoard::State::loading;
  board_->at = ForeignBoard::no_case;
  flush_output();  // or a child that exits would write it once more
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(to[1]);
    ::close(from[0]);
    serve_foreign(code_, *board_, to[0], from[1]);
  }
  const int error = errno;
  close_end(to[0]);
  close_end(from[1]);
  requests_ = to[1];
  replies_ = from[0];
  child_ = child;
  if (child < 0) {
    end_child();
    throw Error(fmt::format("cannot start a process for {}: {}", printable(code_.library), std::strerror(error)));
  }
  const Reply reply = wait_for_reply(kLoading * limits_.call);
  if (reply == Reply::done && board_->state == ForeignBoard::State::serving) return;
  std::string why;
  if (reply == Reply::done) {
    why = text_on(*board_);
  } else {
    why = fmt::format("cannot load {}: while loading it {}", printable(code_.library), in_words(end_of_child(reply)));
  }
  end_child();
  throw Error(why);
}

void ForeignProcess::end_child() {
  if (child_ > 0) {
    ::kill(-child_, SIGKILL);
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, &status_, 0) < 0 && errno == EINTR) {
    }
  }
  child_ = -1;
  close_end(requests_);
  close_end(replies_);
}

/// Takes leave of a child that is dead.
bool ForeignProcess::child_is_dead() {
  const pid_t gone = ::waitpid(child_, &status_, WNOHANG);
  if (gone != child_ && (gone >= 0 || errno != ECHILD)) return false;
  ::kill(-child_, SIGKILL);  // what it may have started
  child_ = -1;
  return true;
}

ForeignProcess::Reply ForeignProcess::wait_for_reply(milliseconds patience) {
  std::uint64_t at = board_->at;
  Clock::time_point since = Clock::now();
  milliseconds glance = std::clamp(patience / 4, milliseconds(1), kGlance);
  pollfd reply{replies_, POLLIN, 0};
  for (;;) {
    if (::poll(&reply, 1, static_cast<int>(glance.count())) > 0) {
      char byte = 0;
      if (::read(replies_, &byte, 1) == 1) return Reply::done;
      reply.fd = -1;  // closed: the child is about to end, or it has closed what is not its own and goes on
      glance = milliseconds(1);
      since = Clock::now();
    }
    if (child_is_dead()) return Reply::died;
    const std::uint64_t now_at = board_->at;
    if (now_at != at) {
      at = now_at;
      since = Clock::now();
    } else if (Clock::now() - since >= patience) {
      return Reply::too_late;
    }
    if (watch_ && at < ForeignBoard::most_cases)
      watch_(done_ + at, std::chrono::duration_cast<milliseconds>(Clock::now() - since));
  }
}

Answer ForeignProcess::end_of_child(Reply reply) const {
  if (reply == Reply::too_late) return Answer(Outcome::hung, fmt::format("longer than {} ms", limits_.call.count()));
  if (!WIFSIGNALED(status_)) return Answer(Outcome::exited, fmt::format("with code {}", WEXITSTATUS(status_)));
  const char* const name = ::sigabbrev_np(WTERMSIG(status_));
  return Answer(Outcome::crashed, fmt::format("SIG{}", name == nullptr ? "?" : name));
}

/// As many of the cases as there is room for.
std::size_t ForeignProcess::put_batch(std::span<const Numbers> cases) {
  std::size_t count = 0, used = 0;
  for (; count < std::min(cases.size(), ForeignBoard::most_cases); ++count) {
    const Numbers& numbers = cases[count];
    if (numbers.size() > ForeignBoard::most_numbers - used) break;
    std::ranges::copy(numbers, board_->numbers.begin() + static_cast<std::ptrdiff_t>(used));
    board_->begin[count] = static_cast<std::uint32_t>(used);
    used += numbers.size();
    board_->ended[count] = ForeignBoard::Ended::pending;
  }
  if (count == 0) {
    throw Error(fmt::format("a case of {} numbers is longer than the {} that a foreign function is given",
                            cases[0].size(), ForeignBoard::most_numbers));
  }
  board_->begin[count] = static_cast<std::uint32_t>(used);
  board_->cases = count;
  board_->at = ForeignBoard::no_case;
  return count;
}

/// How many have been answered.  Nothing on the board is believed that does not fit.
std::size_t ForeignProcess::take_batch(std::span<Answer> answers) {
  std::size_t taken = 0, from = 0;
  for (; taken < answers.size(); ++taken) {
    const ForeignBoard::Ended ended = board_->ended[taken];
    const std::size_t end = board_->answer_end[taken];
    if (ended == ForeignBoard::Ended::pending || end < from || end > ForeignBoard::most_answers) break;
    if (ended == ForeignBoard::Ended::threw) {
      answers[taken] = Answer(Outcome::threw, text_on(*board_));
    } else {
      answers[taken] = Answer();
      const auto written = board_->answers.begin();
      answers[taken].numbers.assign(written + static_cast<std::ptrdiff_t>(from),
                                    written + static_cast<std::ptrdiff_t>(end));
    }
    from = end;
  }
  return taken;
}

std::size_t ForeignProcess::ask(std::span<const Numbers> cases, std::span<Answer> answers) {
  done_ = 0;
  while (done_ < cases.size() && !exhausted()) {
    try {
      if (child_ < 0) start_child();
    } catch (const Error&) {
      hangs_left_ -= 1;
      continue;
    }
    const std::size_t asked = put_batch(cases.subspan(done_));
    const char byte = 0;
    // Where it has closed its end it ends, which is seen below; SIGPIPE is ignored by the program.
    [[maybe_unused]] const ssize_t told = ::write(requests_, &byte, 1);
    const Reply reply = wait_for_reply(limits_.call);
    const bool calling = board_->at != ForeignBoard::no_case;
    const std::size_t taken = take_batch(answers.subspan(done_, asked));
    done_ += taken;
    if (reply == Reply::done && taken > 0) continue;
    // Whoever died between two calls does so for something that nobody can tell any more: the batch is asked anew.
    if (calling && taken < asked) answers[done_++] = end_of_child(reply);
    end_child();
    if (reply == Reply::too_late) ++hangs_;
    (reply == Reply::too_late ? hangs_left_ : replacements_left_) -= 1;
  }
  return done_;
}

}  // namespace plumb::tool
