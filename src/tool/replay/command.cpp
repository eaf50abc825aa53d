#include "tool/replay/command.hpp"

#include <fmt/format.h>

#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/query/certificate/certificate.hpp"
#include "plumb/query/certificate/verify.hpp"
#include "plumb/query/variant/question_recorder.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/answer_text.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

/// A figure that no number makes is recorded together with what refused it, and cannot be read back.
bool was_refused(std::string_view line) {
  const std::size_t answer = line.find('=');
  return answer != line.npos && line.substr(answer).find("refused: ") != line.npos;
}

std::string question_alone(QuestionLine line) {
  line.answer.clear();
  return to_string(line);
}

void prove(const QuestionLine& asked, const ReplayedLine& told, ReplayReport& report) {
  if (told.is.starts_with("refused: ")) return;
  const std::optional<std::string> proved = proved_answer(asked);
  if (!proved) return;
  ++report.proved;
  if (*proved == told.is) return;
  report.disproved.push_back(told);
  report.disproved.back().was = *proved;
}

/// Keeps the question that a page is about.
class PageChoice {
 public:
  explicit PageChoice(std::optional<std::uint64_t> line) : line_(line) {}

  void look_at(const QuestionLine& asked, const ReplayedLine& told) {
    const bool differs = !told.was.empty() && told.was != told.is;
    if (line_ ? told.line == *line_ : !chosen_ || (differs && !differs_)) {
      chosen_.emplace(ReplayedQuestion{asked, told, {}});
      differs_ = differs;
    }
  }
  [[nodiscard]] ReplayedQuestion take() {
    if (!chosen_ && line_) throw Error(fmt::format("replay: line {} is no question that can be read", *line_));
    if (!chosen_) throw Error("replay: there is no question to make a page of");
    if (!chosen_->told.is.starts_with("refused: ")) chosen_->proved = proved_answer(chosen_->asked);
    return std::move(*chosen_);
  }

 private:
  std::optional<std::uint64_t> line_;
  std::optional<ReplayedQuestion> chosen_;
  bool differs_ = false;
};

/// Asks the line, and tells it again with the answer of here.
std::string replayed(QuestionLine asked, const std::string& file, std::uint64_t line, bool with_proof,
                     ReplayReport& report, PageChoice& page) {
  ++report.asked;
  const ReplayedLine told{file, line, question_alone(asked), asked.answer, answer_of(asked)};
  page.look_at(asked, told);
  if (told.was.empty()) {
    report.unanswered.push_back(told);
  } else if (told.was == told.is) {
    ++report.alike;
  } else {
    report.different.push_back(told);
  }
  if (with_proof) prove(asked, told, report);
  asked.answer = told.is;
  return to_string(asked) + "\n";
}

std::string replay_file(const std::string& file, bool with_proof, ReplayReport& report, PageChoice& page) {
  const std::string name = name_of_input(file);
  std::string answered;
  std::uint64_t number = 0;
  for (const std::string& line : recorded_lines(bytes_of_input(file))) {
    ++number;
    try {
      if (std::optional<QuestionLine> asked = parse_question_line(line)) {
        answered += replayed(std::move(*asked), name, number, with_proof, report, page);
      } else {
        answered += line + "\n";
      }
    } catch (const NonFinite& e) {
      if (was_refused(line)) {
        ++report.asked, ++report.alike;
        answered += line + "\n";
      } else {
        report.unread.push_back({name, number, e.what()});
      }
    } catch (const Error& e) {
      report.unread.push_back({name, number, e.what()});
    }
  }
  return answered;
}

}  // namespace

std::optional<std::string> proved_answer(const QuestionLine& line) {
  if (line.figures.size() != 2 || !line.numbers.empty()) return {};
  const AnyFigure &a = line.figures[0], &b = line.figures[1];
  try {
    if (line.question == "relate" || line.question == "intersects") {
      const Certificate proof = relate_with_proof(a, b);
      if (!verify(proof, a, b)) return "nothing: the proof has a flaw";
      if (line.question == "relate")
        return query::answer_text(proof.claim == Claim::disjoint   ? Relation::disjoint
                                  : proof.claim == Claim::touching ? Relation::touching
                                                                   : Relation::overlapping);
      return query::answer_text(proof.claim != Claim::disjoint);
    }
    if (line.question == "distance") {
      const DistanceCertificate proof = distance_with_proof(a, b);
      if (!verify(proof, a, b)) return "nothing: the proof has a flaw";
      return query::answer_text(proof.distance);
    }
  } catch (const Unsupported&) {  // a figure is no convex body
  } catch (const Error& e) {      // what was answered can be proved
    return std::string("nothing: ") + e.what();
  }
  return {};
}

int run_replay(const ReplayOptions& options) {
  if (options.files.empty())
    throw Error("replay: a file of questions is needed; 'plumb replay --help' tells how they are written");
  OutputFiles outputs(options.files);
  outputs.promise_unless_there("--out", options.out, options.overwrite);
  outputs.promise_unless_there("--page", options.page, options.overwrite);
  outputs.promise("--json", options.json);
  if (options.question && !options.page) throw Error("replay: --question is of a page; give --page too");
  if (options.question && options.files.size() > 1) throw Error("replay: --question is a line of one file alone");
  ReplayReport report;
  PageChoice page(options.question);
  std::string answered;
  for (const std::string& file : options.files) answered += replay_file(file, options.prove, report, page);
  if (!outputs.on_standard_output()) say(replay_text(report, Style(stdout)));
  for (const UnreadLine& u : report.unread) complain(fmt::format("{}, line {}: {}", printable(u.file), u.line, u.why));
  outputs.write("--out", std::move(answered));
  nlohmann::json said = origin_json("plumb replay");
  said.update(replay_json(report));
  outputs.write("--json", json_text(said));
  if (options.page) outputs.write("--page", replay_page(page.take()));
  outputs.keep();
  if (!report.unread.empty()) return 2;
  return report.different.empty() && report.disproved.empty() ? 0 : 1;
}

}  // namespace plumb::tool
