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

/// Lines in a ring of bytes that is not its own.  Each is behind a NUL but at the ring's begin, and ends by its number.
class QuestionRing {
 public:
  explicit QuestionRing(std::size_t bytes);
  QuestionRing(const std::string& file, std::size_t bytes);
  QuestionRing(const QuestionRing&) = delete;
  QuestionRing& operator=(const QuestionRing&) = delete;
  ~QuestionRing();

  /// The number of the line.
  std::uint64_t ask(std::string_view question);
  void answer(std::uint64_t line, std::string_view question, std::string_view answer);

  [[nodiscard]] std::string content() const;
  [[nodiscard]] std::size_t left_out() const;

 private:
  class Bytes;
  std::unique_ptr<Bytes> bytes_;
};

/// None where nothing is recorded.
extern std::atomic<QuestionRing*> living_ring;

std::string question_text(std::string_view question, std::initializer_list<PosedView> figures,
                          std::initializer_list<double> numbers);

template <class Ask>
auto recorded(std::string_view question, std::initializer_list<PosedView> figures,
              std::initializer_list<double> numbers, const Ask& ask) {
  QuestionRing* const ring = living_ring.load(std::memory_order_acquire);
  if (ring == nullptr) [[likely]]
    return ask();
  const std::string text = question_text(question, figures, numbers);
  const std::uint64_t line = ring->ask(text);
  try {
    auto answer = ask();
    ring->answer(line, text, answer_text(answer));
    return answer;
  } catch (const Error& e) {
    ring->answer(line, text, refusal_text(e));
    throw;
  }
}

}  // namespace plumb::query
