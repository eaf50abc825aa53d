#include "tool/terminal/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

constexpr std::chrono::milliseconds kPause(100);
constexpr int kBar = 30;

}  // namespace

Progress::Progress(std::string task, std::uint64_t total)
    : Progress(std::move(task), total, stderr, obeys_escapes(stderr) && !is_quiet()) {}

// The first drawing waits as well: what ends sooner needs no bar.
Progress::Progress(std::string task, std::uint64_t total, std::FILE* stream, bool shown)
    : task_(std::move(task)),
      total_(total),
      stream_(stream),
      shown_(shown),
      next_drawing_((Clock::now() + kPause).time_since_epoch().count()) {}

Progress::~Progress() { erase(); }

void Progress::erase() {
  const std::scoped_lock lock(drawing_);
  if (!drawn_) return;
  std::fputs("\r\033[K", stream_);
  std::fflush(stream_);
  drawn_ = false;
}

void Progress::advance(std::uint64_t steps) {
  const std::uint64_t done = done_.fetch_add(steps, std::memory_order_relaxed) + steps;
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  Clock::rep next = next_drawing_.load(std::memory_order_relaxed);
  if (now.time_since_epoch().count() < next) return;
  if (!next_drawing_.compare_exchange_strong(next, (now + kPause).time_since_epoch().count())) return;
  if (const std::unique_lock lock(drawing_, std::try_to_lock); lock.owns_lock()) draw(done);
}

void Progress::note(std::string what) {
  if (!shown_) return;
  {
    const std::scoped_lock lock(drawing_);
    note_ = std::move(what);
  }
  advance(0);
}

void Progress::draw(std::uint64_t done) {
  const double share = total_ == 0 ? 1 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  const int filled = static_cast<int>(share * kBar);
  const std::string bar(static_cast<std::size_t>(filled), '#'), rest(static_cast<std::size_t>(kBar - filled), '.');
  std::string line = fmt::format("{}{} {:3d} %  {}", bar, rest, static_cast<int>(share * 100), task_);
  if (!note_.empty()) line.append(": ").append(note_);
  const auto width = static_cast<std::size_t>(std::max(1, terminal_width(stream_) - 1));
  if (line.size() > width) line.resize(width);  // a wrapped line could not be erased
  fmt::print(stream_, "\r{}\033[K", line);
  std::fflush(stream_);
  drawn_ = true;
}

}  // namespace plumb::tool
