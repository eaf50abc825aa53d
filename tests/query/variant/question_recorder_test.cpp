// Is every question kept that is asked, with its answer, whichever thread asks it; does the ring keep the last ones, and
// outlive the process?
#include "plumb/query/variant/question_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "figure/basic/thrown.hpp"
#include "plumb/query.hpp"
#include "plumb/world.hpp"
#include "query/variant/question_lines.hpp"
#include "query/variant/recorded.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;

std::vector<std::string> lines_of(const QuestionRecorder& recorder) { return recorded_lines(recorder.text()); }

std::string with_answer(QuestionLine line, const std::string& answer) {
  line.answer = answer;
  return to_string(line);
}

TEST(QuestionRecorder, KeepsEveryQuestionAsItIsAskedAgain) {
  int kept = 0;
  for (const QuestionLine& asked : question_lines(11)) {
    const QuestionRecorder recorder(1 << 13);
    const std::string answer = answer_of(asked);
    const std::vector<std::string> lines = lines_of(recorder);
    // What the line itself refuses before it asks is no question, nor is one of what is no body of space.
    const bool is_of_bodies = asked.question == "penetration" || asked.question == "contact";
    if (is_of_bodies && answer.starts_with("refused: ") && lines.empty()) continue;
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
    constexpr std::size_t length = 232;  // its numbers and words, and what stands around them and around the answer
    EXPECT_GE(lines.size(), std::min<std::size_t>(asked, (bytes - 72) / length - 1)) << bytes;
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
  EXPECT_EQ(recorder.left_out(), 1U);
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
    constexpr Point3 none{};
    query::living_ring.load()->ask(
        query::question_parts("relate", {query::posed_view(none), query::posed_view(none)}, {}));
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

// Overwritten anywhere, a ring tells whole lines alone; cut, or of another version, it is refused by name.
TEST_F(InAFile, TellsWholeLinesOfWhatWasDamaged) {
  std::vector<std::string> all;
  std::string whole;
  {
    const QuestionRecorder recorder(file_, 1200);
    for (int i = 0; i < 57; ++i) ask_ball(i);
    all = lines_of(recorder);
    whole = content();
  }
  EXPECT_EQ(recorded_lines(whole), all);
  EXPECT_GT(all.size(), 2U);
  const std::size_t first_line = whole.find('\n') + 1 + 8;
  for (std::size_t at = first_line; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 5);
    const std::vector<std::string> some = recorded_lines(damaged);
    EXPECT_GE(some.size() + 1, all.size()) << at;
    for (const std::string& line : some) {
      const bool is_one = std::ranges::any_of(all, [&](const std::string& one) {
        return one == line || one.starts_with(line + " = ");  // of which the answer was hit
      });
      EXPECT_TRUE(is_one) << at << ": " << line;
    }
  }
  const auto refusal = [](const std::string& text) { return text_of<Error>([&] { (void)recorded_lines(text); }); };
  for (std::size_t length = 64; length < whole.size(); ++length)
    EXPECT_THAT(refusal(whole.substr(0, length)), HasSubstr("was cut")) << length;
  EXPECT_THAT(refusal("# questions and answers of plumb, in a ring\n"), HasSubstr("another version"));
  EXPECT_EQ(recorded_lines("one\n\ntwo"), (std::vector<std::string>{"one", "", "two"}));
}

// What is asked of a world is kept, with the contacts of its figures.
TEST(QuestionRecorder, KeepsContactsInAWorld) {
  const QuestionRecorder recorder(1 << 16);
  CollisionWorld world({.contacts = true});
  world.add(Aabb3{{0, 0, 0}, {1, 1, 1}});
  world.add(Aabb3{{0, 0, 1}, {1, 1, 2}});
  (void)world.commit();
  (void)penetration(AnyFigure(Sphere3{{0, 0, 0}, 1}), Point3{0, 0, 0.5});
  const std::vector<std::string> lines = lines_of(recorder);
  EXPECT_THAT(lines, testing::Contains(testing::StartsWith("contact | aabb3 ")));
  EXPECT_THAT(lines, testing::Contains(testing::StartsWith("penetration | ball3 ")));
  for (const std::string& line : lines) {
    const auto read = parse_question_line(line);
    EXPECT_EQ(answer_of(*read), read->answer) << line;
  }
}

}  // namespace
}  // namespace plumb
