// Is the question kept that is being asked?  By the recorder that lives, if one does.
//
//   return recorded("relate", {a, b}, {}, [&] { return relate_views(a, b); });
//
// Source: none.
// Cost: query/variant/question_recorder.hpp.  Nothing is searched.
#pragma once

#include <atomic>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "plumb/query/variant/question_recorder.hpp"
#include "query/variant/answer_text.hpp"

namespace plumb::query {

/// Questions and answers in a ring of bytes, by their parts.
class QuestionRing {
 public:
  explicit QuestionRing(std::size_t bytes);
  QuestionRing(const std::string& file, std::size_t bytes);
  QuestionRing(const QuestionRing&) = delete;
  QuestionRing& operator=(const QuestionRing&) = delete;
  ~QuestionRing();

  /// It says where a question is.
  struct Place {
    std::uint64_t line, written;  // its number, and how much was written before it
  };
  Place ask(const LineParts& question);
  /// The question once more where it was overwritten.
  void answer(const Place& at, const LineParts& question, const LineParts& answer);

  [[nodiscard]] std::string content() const;
  [[nodiscard]] std::size_t left_out() const;

 private:
  class Bytes;
  std::unique_ptr<Bytes> bytes_;
};

/// None where nothing is recorded.
extern std::atomic<QuestionRing*> living_ring;

LineParts question_parts(std::string_view question, std::initializer_list<PosedView> figures,
                         std::initializer_list<double> numbers);

template <class Ask>
auto recorded(std::string_view question, std::initializer_list<PosedView> figures,
              std::initializer_list<double> numbers, const Ask& ask) {
  QuestionRing* const ring = living_ring.load(std::memory_order_acquire);
  if (ring == nullptr) [[likely]]
    return ask();
  const LineParts parts = question_parts(question, figures, numbers);
  const QuestionRing::Place at = ring->ask(parts);
  try {
    auto answer = ask();
    ring->answer(at, parts, answer_parts(answer));
    return answer;
  } catch (const Error& e) {
    LineParts refusal;
    refusal.word(refusal_text(e));
    ring->answer(at, parts, refusal);
    throw;
  }
}

}  // namespace plumb::query
