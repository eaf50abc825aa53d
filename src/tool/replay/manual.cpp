#include "plumb/query/variant/question_line.hpp"
#include "tool/manual/help_text.hpp"

namespace plumb::tool {
namespace {

/// The name of each question, and what it takes.
std::string questions() {
  std::string text;
  for (const QuestionForm& form : question_forms()) {
    text += text.empty() ? "\n" : "\n\n";
    text += form.name;
    text += "\n       ";
    std::size_t column = 7;
    std::string_view rest = form.arguments;
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find(' '));
      if (column + word.size() > 72) text += "\n       ", column = 7;
      if (column != 7) text += ' ', ++column;
      text += word;
      column += word.size();
      rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    }
    text += '.';
  }
  return text;
}

}  // namespace

Manual replay_manual() {
  return {"plumb replay",
          "ask questions again that were kept with their answers",
          {"plumb replay [OPTION]... FILE..."},
          {{"DESCRIPTION", R"(
Reads questions of figures, one a line, asks each of them, and tells
those whose answer is not the one that stands behind '='. A question
without an answer is answered. Blank lines and what follows a '#' are
passed over.

    relate | ball3 0 0 0 1 | aabb3 1 0 0 2 1 1 = touching
    distance | point3 0 0 0 | segment3 1 0 0 0 1 0 rigid 1 0 0 1 0 0 2

A figure is its kind and dimension, then its numbers, decimal or
hexadecimal, then, if it is posed, 'pose' and the columns of a matrix
and the translation, 'rigid' and a quaternion and the translation, or
'chain' and these of each joint. Answers are exact decisions and numbers
that are rounded once, so they are the same on every machine; what
refuses a question is an answer too.

A program keeps such lines by a QuestionRecorder (docs/world.md), in
memory or in a ring of bytes in a file, which survives the program: the
last line, which has no answer, is what it was asked when it ended.

docs/questions.md tells how lines are written and kept. A page shows one
question: both answers, the figures, the points that the answer names,
and of two convex bodies the steps of the search, with a slider.)"},
           {"QUESTIONS", questions()}},
          {{"EXIT STATUS", R"(
0      All answers are as they were.
1      At least one is another.
2      Bad input: wrong usage, a file or a line that cannot be read, an
       output that cannot be written. What was wrong stands on standard
       error; all lines that can be read are asked.)"},
           {"EXAMPLES", R"(
plumb replay questions.txt
       Asks them here.

plumb replay --out - questions.txt
       Answers questions that were written by hand.

plumb replay --page why.html questions.txt
       Shows the first that is answered otherwise.

plumb replay --prove --json replay.json game.ring
       Asks the last questions of a program that ended, with proofs.)"}}};
}

}  // namespace plumb::tool
