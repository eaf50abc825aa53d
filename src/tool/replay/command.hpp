// `plumb replay`: are questions that were kept with their answers answered alike here?
//
// Laws: (1) every line of every file is asked again, and told where its answer is another one; a question that has no
// answer, as one that ended the program, is answered.  (2) With --prove what is asked of two convex figures is asked with a
// proof as well, which is verified by sums and products alone; where it proves another answer, the line is told.
// (3) Lines that cannot be read are told, with why, and all others are asked.  (4) Text and JSON tell the same.  (5) A page
// is about the line that is asked for; else about the first that is answered otherwise, or the first of all.
// Exit code 0 where all answers are as they were, 1 where one is another, 2 where a line or a file cannot be read; an
// output that cannot be written throws Error.
// Source: RTCD 2.7.1; plumb/query/variant/question_line.hpp.
// Cost: that of the questions.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/query/variant/question_line.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct ReplayOptions {
  std::vector<std::string> files;         // "-" is standard input
  bool prove = false, overwrite = false;  // ask with proofs; replace the files of `out` and `page`
  std::optional<std::string> out, json, page;
  std::optional<std::uint64_t> question;  // the line that the page is about
};

int run_replay(const ReplayOptions& options);

/// One that is told: what it was is empty where it had no answer.
struct ReplayedLine {
  std::string file;
  std::uint64_t line;
  std::string question, was, is;
};
struct UnreadLine {
  std::string file;
  std::uint64_t line;
  std::string why;
};

struct ReplayReport {
  std::uint64_t asked = 0, alike = 0, proved = 0;
  std::vector<ReplayedLine> different, unanswered, disproved;  // of the last, what was proved stands for what it was
  std::vector<UnreadLine> unread;
};

/// One question to be looked at.
struct ReplayedQuestion {
  QuestionLine asked;
  ReplayedLine told;
  std::optional<std::string> proved;
};
/// Opens without a network: both answers, the figures, what the answer names of them, and the steps of a search.
std::string replay_page(const ReplayedQuestion& of);

std::string replay_text(const ReplayReport& report, const Style& style);
/// Leaves out what a report begins with.
nlohmann::json replay_json(const ReplayReport& report);

/// What a verified proof says of the question, in the words of its answer; none where it is of no two convex figures.  The question has
/// an answer.
std::optional<std::string> proved_answer(const QuestionLine& line);

}  // namespace plumb::tool
