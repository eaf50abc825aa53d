// What does a foreign function answer, whatever it does?  The program's side: a child that is watched and replaced.
//
// Laws: (1) a crash, a call that takes too long, an exit and an exception are outcomes of the case that caused them,
// and the other cases are asked all the same; (2) a child is replaced at most so often, after which cases are not asked
// any more instead of asked for ever; (3) what cannot be loaded, or crashes or hangs in loading, is an Error, and
// later, when it is loaded anew, counts as a hang; (4) no child outlives this object.
// Source: none.
// Cost: 100 to 500 ns a case in batches of a thousand, about a millisecond a replaced child.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tool/fuzz/foreign_child.hpp"

namespace plumb::tool {

struct ForeignLimits {
  std::chrono::milliseconds call{1000};  // to load it may take ten times as long
  std::size_t replacements = 1000;       // of children, after crashes and exits
  std::size_t hangs = 10;                // each of which took its time
};

class ForeignProcess {
 public:
  /// Loads the function; throws Error.
  ForeignProcess(ForeignCode code, ForeignLimits limits);
  ForeignProcess(const ForeignProcess&) = delete;
  ForeignProcess& operator=(const ForeignProcess&) = delete;
  ~ForeignProcess();

  /// Fills the answers of as many of these cases, from the first on, as it returns: of all unless exhausted.
  std::size_t ask(std::span<const degenerate::Numbers> cases, std::span<degenerate::Answer> answers);

  /// From here on so many are allowed.
  void allow(std::size_t replacements, std::size_t hangs);

  /// Is told, some twenty times a second while an answer is awaited, which of the cases is being asked and for how
  /// long.
  using Watch = std::function<void(std::size_t number, std::chrono::milliseconds since)>;
  void watch(Watch watch) { watch_ = std::move(watch); }

  /// Calls that have not come back in time, so far.
  [[nodiscard]] std::size_t hangs() const { return hangs_; }

  [[nodiscard]] bool exhausted() const { return replacements_left_ == 0 || hangs_left_ == 0; }

 private:
  enum class Reply : unsigned char { done, died, too_late };
  struct Unmap {
    void operator()(ForeignBoard* board) const;
  };

  void start_child();
  void end_child();
  Reply wait_for_reply(std::chrono::milliseconds patience);
  bool child_is_dead();
  [[nodiscard]] degenerate::Answer end_of_child(Reply reply) const;
  std::size_t put_batch(std::span<const degenerate::Numbers> cases);
  std::size_t take_batch(std::span<degenerate::Answer> answers);

  ForeignCode code_;
  ForeignLimits limits_;
  std::size_t replacements_left_, hangs_left_;
  std::size_t hangs_ = 0;
  std::size_t done_ = 0;  // of the cases that are being asked
  Watch watch_;
  std::unique_ptr<ForeignBoard, Unmap> board_;
  pid_t child_ = -1;
  int status_ = 0;  // of the child that died last
  int requests_ = -1, replies_ = -1;
};

}  // namespace plumb::tool
