// `plumb replay` as a user meets it: questions of a file, a pipe and a ring, what is told of them, and what is refused.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "plumb/query/variant/question_recorder.hpp"
#include "plumb/query/variant/questions.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string in(const Folder& folder) { return "cd " + (folder / "") + " && $PLUMB replay "; }
void write(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
}

TEST(Replay, TellsWhatIsAnsweredOtherwise) {
  const Folder folder;
  write(folder, "q.txt",
        "# two of three are as they were\nrelate | ball3 0 0 0 1 | ball3 2 0 0 1 = touching\n\n"
        "relate | ball3 0 0 0 1 | ball3 3 0 0 1 = touching  # is it?\n"
        "distance | point3 0 0 0 | point3 3 4 0 = 0x1.4p+2\n");
  const Outcome o = run(in(folder) + "q.txt --json q.json");
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(o.err, "");
  EXPECT_THAT(o.out, AllOf(HasSubstr("3 questions asked, 2 answered as before\n"),
                           HasSubstr("q.txt, line 4: relate | "), HasSubstr("was touching; is disjoint")));
  const json said = json::parse(content(folder / "q.json"));
  EXPECT_EQ(said.at("asked"), 3);
  EXPECT_EQ(said.at("different").at(0).at("line"), 4);
  EXPECT_EQ(said.at("different").at(0).at("is"), "disjoint");
}

TEST(Replay, AnswersWhatHasNoAnswer) {
  const Folder folder;
  write(folder, "q.txt", "# by hand\nrelate | ball3 0 0 0 1 | ball3 2 0 0 1\n");
  const Outcome o = run(in(folder) + "q.txt");
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.out, AllOf(HasSubstr("1 question had no answer"), HasSubstr("    touching\n")));
  const Outcome answered = run(in(folder) + "--out - q.txt");
  EXPECT_EQ(answered.out,
            "# by hand\nrelate | ball3 0x0p+0 0x0p+0 0x0p+0 0x1p+0 | ball3 0x1p+1 0x0p+0 0x0p+0 0x1p+0 = touching\n");
  // What it answered is as before, and may come through a pipe.
  EXPECT_THAT(run(in(folder) + "--out - q.txt | $PLUMB replay -").out, HasSubstr("1 question asked, 1 answered"));
}

TEST(Replay, ProvesWhatIsAskedOfTwoConvexFigures) {
  const Folder folder;
  write(folder, "q.txt",
        "relate | obb3 0 0 0 1 0 0 0 1 0 0 0 1 1 1 1 | aabb3 1 0 0 2 1 1 = touching\n"
        "intersects | triangle3 0 0 0 1 0 0 0 1 0 | segment3 0 0 1 0 0 2 = no\n"
        "distance | ball3 0 0 0 1 | capsule3 0 4 0 1 4 0 1 = 0x1p+1\n"
        "relate | cylinder3 0 0 0 1 0 0 1 | point3 0 0 0 = overlapping\n");
  const Outcome o = run(in(folder) + "--prove --json q.json q.txt");
  const json said = json::parse(content(folder / "q.json"));
  EXPECT_EQ(said.at("proved"), 3) << o.out;
  EXPECT_TRUE(said.at("disproved").empty()) << o.out;
}

TEST(Replay, AsksWhatARingKept) {
  const Folder folder;
  {
    const QuestionRecorder recorder(folder / "game.ring", 4096);
    for (int i = 0; i < 1000; ++i)
      relate(AnyFigure(Sphere3{{0, 0, 0}, 1}), AnyFigure(Point3{static_cast<double>(i), 0, 0}));
  }
  const Outcome o = run(in(folder) + "game.ring");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("answered as before"));
}

TEST(Replay, WhatNoNumberMakesIsRefusedAsBefore) {
  const Folder folder;
  write(folder, "q.txt", "relate | ball3 nan 0 0 1 | point3 0 0 0 = refused: the ball is of no numbers\n");
  EXPECT_EQ(run(in(folder) + "q.txt").code, 0);
  write(folder, "q.txt", "relate | ball3 nan 0 0 1 | point3 0 0 0 = touching\n");
  EXPECT_EQ(run(in(folder) + "q.txt").code, 2);
}

TEST(Replay, WhatCannotBeReadIsNamedAndTheOthersAsked) {
  const Folder folder;
  write(folder, "q.txt",
        "touch | ball3 0 0 0 1\nrelate | ball3 0 0 0 1 | ball3 2 0 0 1 = touching\nrelate | ball3 0 0 0\n");
  const Outcome o = run(in(folder) + "q.txt");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.out, HasSubstr("1 question asked, 1 answered as before"));
  EXPECT_THAT(o.err, AllOf(HasSubstr("q.txt, line 1: there is no question 'touch'"), HasSubstr("q.txt, line 3: ")));
  EXPECT_THAT(run(in(folder) + "none.txt").err, HasSubstr("none.txt"));
  EXPECT_EQ(run(in(folder) + "none.txt").code, 2);
  EXPECT_THAT(run(in(folder)).err, HasSubstr("a file of questions is needed"));
}

TEST(Replay, ReplacesNothingUnasked) {
  const Folder folder;
  write(folder, "q.txt", "relate | ball3 0 0 0 1 | ball3 2 0 0 1\n");
  write(folder, "kept.txt", "mine");
  EXPECT_EQ(run(in(folder) + "--out kept.txt q.txt").code, 2);
  EXPECT_EQ(content(folder / "kept.txt"), "mine");
  EXPECT_EQ(run(in(folder) + "--out q.txt --overwrite q.txt").code, 2);
  EXPECT_EQ(run(in(folder) + "--out kept.txt --overwrite q.txt").code, 0);
  EXPECT_THAT(content(folder / "kept.txt"), HasSubstr("= touching"));
}

}  // namespace
}  // namespace plumb::tool
