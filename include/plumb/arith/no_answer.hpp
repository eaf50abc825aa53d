// What does a compiler say of a question that has no answer for these arguments?  One sentence, instead of all that it
// tried.
//
//   PLUMB_NO_ANSWER(Relation, "plumb: relate takes two figures of one space")
//   relate(PLUMB_ANYTHING) PLUMB_DELETED;
//
// Such a function takes whatever no other function of its name takes, and is deleted: it stands for the questions that
// are not answered.  So generic code may ask whether there is an answer, once all that may answer is included:
//   if constexpr (requires { relate(a, b); }) ...     in a template
// and what asks nevertheless does not compile.  GCC names the type of the answer then, which holds the sentence; Clang says
// why a function is unavailable, which is as good as deleted: of a deleted one it would list every other candidate.
// Laws: anything that fits is better than such a function, also what fits by converting its arguments, because this one
// converts all of them and is a template.
// Cost: compile time only.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <type_traits>

#include "plumb/predicates/standard.hpp"

namespace plumb::arith {

/// Whatever it is.
struct Anything {
  template <class T>
  Anything(const T&);  // NOLINT: the one argument that every call has an overload for
  Anything();
};

/// What stands for a point between the braces of a list of which no type says what it is of.
struct InBraces {
  InBraces(std::initializer_list<double>);
  template <class T>
  requires requires(const T& p) { p.x, p.y; }
  InBraces(const T&);  // NOLINT: a point as it is
};

#ifdef __clang__
template <class T>
inline constexpr bool is_complete = requires {
  sizeof(T);
};
template <template <class...> class Of, class T, class... Others>
inline constexpr bool is_complete<Of<T, Others...>> = is_complete<T>;

/// The type of an answer, or where that is not included another one: nothing more is to be said of that.
template <class T>
using AnswerType = std::conditional_t<is_complete<T>, T, bool>;
#else
template <std::size_t N>
struct Sentence {
  char text[N];
  constexpr Sentence(const char (&s)[N]) {  // NOLINT: made of a literal without a word
    for (std::size_t i = 0; i < N; ++i) text[i] = s[i];
  }
};

/// Stands where the type of an answer would stand.
template <Sentence>
struct NoAnswer;
#endif

}  // namespace plumb::arith

#ifdef __clang__
#define PLUMB_NO_ANSWER_TYPE(Answer, sentence) __attribute__((unavailable(sentence))) plumb::arith::AnswerType<Answer>
#define PLUMB_DELETED
#else
#define PLUMB_NO_ANSWER_TYPE(Answer, sentence) plumb::arith::NoAnswer<sentence>
#define PLUMB_DELETED = delete
#endif
#define PLUMB_NO_ANSWER(Answer, sentence) \
  template <class NoAnswerType = Answer>  \
  PLUMB_NO_ANSWER_TYPE(NoAnswerType, sentence)
#define PLUMB_ANYTHING                                                                                   \
  const plumb::arith::Anything&, const plumb::arith::Anything& = {}, const plumb::arith::Anything& = {}, \
                                       const plumb::arith::Anything& = {}
/// No template takes braces: a second function is deleted where points stand between them.
#define PLUMB_POINTS_IN_BRACES std::initializer_list<plumb::arith::InBraces>, const plumb::arith::Anything& = {}
