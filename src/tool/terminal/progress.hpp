// How far is the work?  A bar on standard error while a long task runs, gone when it ends.
//
// Laws: (1) any number of threads may advance it; (2) it is drawn at most ten times a second, by whichever thread comes
// by, and nobody waits for the drawing; (3) on a stream that obeys no escapes (terminal.hpp) nothing is ever written; (4) its line is
// erased when it ends, however it ends.
// Source: none.
// Cost: an atomic addition and a look at the clock an advance, so advance by chunks.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>

namespace plumb::tool {

class Progress {
 public:
  /// On standard error, where that shows it.
  Progress(std::string task, std::uint64_t total);
  /// On this stream, when `shown`.
  Progress(std::string task, std::uint64_t total, std::FILE* stream, bool shown);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void advance(std::uint64_t steps = 1);
  /// What is being done right now, shown after the task; drawn as seldom as the bar, and also where nothing advances.
  void note(std::string what);
  /// Its line is gone, for other text to stand there; called by one thread, when the others are done.
  void erase();
  [[nodiscard]] bool shown() const { return shown_; }
  [[nodiscard]] std::uint64_t done() const { return done_.load(std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::uint64_t done);

  const std::string task_;
  const std::uint64_t total_;
  std::FILE* const stream_;
  const bool shown_;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<Clock::rep> next_drawing_;
  std::mutex drawing_;
  bool drawn_ = false;  // guarded by drawing_, as is
  std::string note_;
};

}  // namespace plumb::tool
