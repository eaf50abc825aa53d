// Is every question kept that is asked, with its answer, whichever thread asks it; does the ring keep the last ones, and
// outlive the process?
#include "plumb/query/variant/question_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "plumb/query.hpp"
#include "query/variant/question_lines.hpp"
#include "query/variant/recorded.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;

std::vector<std::string> lines_of(const QuestionRecorder& recorder) { return recorded_lines(recorder.text()); }

// Those of figures alone; penetration and contact are asked of bodies, which need be no AnyFigure.
bool is_recorded(const QuestionLine& line) { return line.question != "penetration" && line.question != "contact"; }

std::string with_answer(QuestionLine line, const std::string& answer) {
  line.answer = answer;
  return to_string(line);
}

TEST(QuestionRecorder, KeepsEveryQuestionAsItIsAskedAgain) {
  int kept = 0;
  for (const QuestionLine& asked : question_lines(11)) {
    if (!is_recorded(asked)) continue;
    const QuestionRecorder recorder(1 << 13);
    const std::string answer = answer_of(asked);
    const std::vector<std::string> lines = lines_of(recorder);
    // What the line itself refuses before it asks is no question.
    if (answer.find("the second figure is a point") != answer.npos || answer.find("no whole number") != answer.npos) {
      EXPECT_TRUE(lines.empty());
      continue;
    }
    ASSERT_FALSE(lines.empty()) << to_string(asked);
    EXPECT_EQ(lines.front(), with_answer(asked, answer));
    ++kept;
  }
  EXPECT_GT(kept, 10'000);
}

std::string ball_line(int i) {
  return with_answer({"distance", {Point3{0, 0, 0}, Point3{0, 0, static_cast<double>(i)}}, {}, ""}, "");
}
void ask_ball(int i) { (void)distance(AnyFigure(Point3{0, 0, 0}), AnyFigure(Point3{0, 0, static_cast<double>(i)})); }

TEST(QuestionRecorder, KeepsTheLastOnesInOrder) {
  for (const std::size_t bytes : {1024UL, 1025UL, 1500UL, 4096UL, 1UL << 20}) {
    const QuestionRecorder recorder(bytes);
    constexpr int asked = 3000;
    for (int i = 0; i < asked; ++i) ask_ball(i);
    const std::vector<std::string> lines = lines_of(recorder);
    ASSERT_LE(lines.size(), static_cast<std::size_t>(asked));
    const std::size_t length = ball_line(asked - 1).size() + 40;
    EXPECT_GE(lines.size(), std::min<std::size_t>(asked, bytes / length - 4)) << bytes;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const int i = asked - static_cast<int>(lines.size() - k);
      EXPECT_THAT(lines[k], testing::StartsWith(ball_line(i) + " = ")) << bytes;
      const auto read = parse_question_line(lines[k]);
      EXPECT_EQ(answer_of(*read), read->answer);
    }
  }
}

TEST(QuestionRecorder, KeepsWhatManyThreadsAsk) {
  constexpr int of_each = 500;
  std::vector<std::string> expected;
  for (int i = 0; i < 4 * of_each; ++i) {
    const QuestionLine asked = *parse_question_line(ball_line(i));
    expected.push_back(with_answer(asked, answer_of(asked)));
  }
  const QuestionRecorder recorder(1 << 22);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([t] {
      for (int i = 0; i < of_each; ++i) ask_ball(t * of_each + i);
    });
  }
  for (std::thread& t : threads) t.join();
  EXPECT_THAT(lines_of(recorder), testing::UnorderedElementsAreArray(expected));
}

TEST(QuestionRecorder, ALineThatIsTooLongIsLeftOut) {
  const QuestionRecorder recorder(1024);
  ask_ball(1);
  Polygon3 large;
  for (int i = 0; i < 100; ++i) large.vertices.push_back({static_cast<double>(i), static_cast<double>(i * i), 0});
  (void)fit_aabb(AnyFigure(large));
  EXPECT_EQ(recorder.left_out(), 2U);  // before it was asked and behind it
  EXPECT_EQ(lines_of(recorder).size(), 1U);
}

TEST(QuestionRecorder, OneLivesAtATime) {
  const QuestionRecorder recorder(1024);
  EXPECT_THROW(QuestionRecorder(1024), Error);
  EXPECT_THROW(QuestionRecorder(1023), Error);
  ask_ball(3);
  EXPECT_EQ(lines_of(recorder).size(), 1U);
}

class InAFile : public testing::Test {
 protected:
  InAFile() { std::filesystem::create_directory(folder_); }
  ~InAFile() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("plumb_recorder_" + std::to_string(::getpid()));
  const std::filesystem::path file_ = folder_ / "ring";
  [[nodiscard]] std::string content() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(InAFile, OutlivesTheProcess) {
  const pid_t child = ::fork();
  ASSERT_NE(child, -1);
  if (child == 0) {
    const QuestionRecorder recorder(file_, 2048);
    for (int i = 0; i < 100; ++i) ask_ball(i);
    // One that never comes to its answer.
    query::living_ring.load()->ask("relate | point3 0x0p+0 0x0p+0 0x0p+0 | point3 0x0p+0 0x0p+0 0x0p+0");
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const std::vector<std::string> lines = recorded_lines(content());
  ASSERT_GT(lines.size(), 5U);
  EXPECT_EQ(lines.back(), "relate | point3 0x0p+0 0x0p+0 0x0p+0 | point3 0x0p+0 0x0p+0 0x0p+0");
  EXPECT_THAT(lines[lines.size() - 2], HasSubstr(ball_line(99) + " = "));
}

TEST_F(InAFile, ReplacesNothing) {
  std::ofstream(file_) << "mine";
  EXPECT_THROW(QuestionRecorder(file_, 2048), Error);
  EXPECT_EQ(content(), "mine");
  EXPECT_THROW(QuestionRecorder(folder_ / "none" / "ring", 2048), Error);
  const QuestionRecorder none_lives(1024);
}

// Cut or overwritten anywhere, a ring tells whole lines alone.
TEST_F(InAFile, TellsWholeLinesOfWhatWasCut) {
  std::vector<std::string> all;
  std::string whole;
  {
    const QuestionRecorder recorder(file_, 1200);
    for (int i = 0; i < 57; ++i) ask_ball(i);
    all = lines_of(recorder);
    whole = content();
  }
  EXPECT_EQ(recorded_lines(whole), all);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::vector<std::string> some = recorded_lines(whole.substr(0, length));
    if (length < 64) continue;  // of what begins otherwise each line is one
    for (const std::string& line : some) EXPECT_THAT(all, testing::Contains(line)) << length;
  }
  EXPECT_EQ(recorded_lines("one\n\ntwo"), (std::vector<std::string>{"one", "", "two"}));
}

}  // namespace
}  // namespace plumb
