// Which questions were asked before the program failed, and what was answered?  Those of AnyFigures, kept as lines
// (query/variant/question_line.hpp) in a ring of bytes, the last of them, until they are asked again elsewhere.
//
//   const QuestionRecorder recorder(1 << 20);            while it lives, in memory
//   world.commit();
//   std::ofstream("questions.txt") << recorder.text();
//   const QuestionRecorder ring("questions.ring", 1 << 20);    in a mapped file, which survives the process
//   recorded_lines(content of questions.ring)
//   plumb replay questions.ring
//
// Laws: (1) every question of query/variant/questions.hpp that any thread asks is kept, and contact and penetration of
// AnyFigures that are bodies, with its answer or what refused it, and what is asked of AnyFigures on the way. (2) A
// question is in the ring before it is asked: one that never came to its answer is the line that has none. (3) text()
// and recorded_lines tell the lines in the order in which they were asked; a line that was overwritten in part is none.
// Numbers stand in the ring as doubles: one of another version, or cut, is refused by name. (4) Of recorders one lives
// at a time, and longer than the questions that are asked while it lives; another, a ring of less than 1024 bytes, a
// file that is there, or one that cannot be made or mapped, throws Error.
// Source: RTCD 2.7.1.
// Cost: a load and a branch a question where no recorder lives; else that of copying its numbers, docs/questions.md.
// Nothing is searched.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

namespace query {
class QuestionRing;
}

class QuestionRecorder {
 public:
  explicit QuestionRecorder(std::size_t bytes);
  QuestionRecorder(const std::string& file, std::size_t bytes);
  QuestionRecorder(const QuestionRecorder&) = delete;
  QuestionRecorder& operator=(const QuestionRecorder&) = delete;
  ~QuestionRecorder();

  /// The lines that are kept, the oldest first.
  [[nodiscard]] std::string text() const;
  /// Those that were too long for the ring.
  [[nodiscard]] std::size_t left_out() const;

 private:
  std::unique_ptr<query::QuestionRing> ring_;
};

/// Those of a ring, the oldest first; of any other text its lines as they stand.
std::vector<std::string> recorded_lines(std::string_view content);

}  // namespace plumb
