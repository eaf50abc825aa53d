// `plumb replay` as a user meets it: questions of a file, a pipe and a ring, what is told of them, and what is refused.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "plumb/query/variant/question_line.hpp"
#include "plumb/query/variant/question_recorder.hpp"
#include "plumb/query/variant/questions.hpp"
#include "tool/browser.hpp"
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

json scene_in(const std::string& page) {
  const std::string begin = "id=\"raw\">";
  const std::size_t from = page.find(begin) + begin.size();
  return json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(Replay, APageShowsTheQuestionThatDiffers) {
  const Folder folder;
  write(folder, "q.txt",
        "distance | point3 0 0 0 | point3 3 4 0 = 0x1.4p+2\n"
        "relate | tetrahedron3 0 0 0 1 0 0 0 1 0 0 0 1 | obb3 2 2 2 1 0 0 0 1 0 0 0 1 0.5 0.5 0.5 rigid 3 1 0 1 0 0 0 "
        "= touching\n"
        "first_hit | ray3 -3 0 0 1 0 0 | ball3 0 0 0 1\n");
  EXPECT_EQ(run(in(folder) + "q.txt --page why.html").code, 1);
  const std::string page = content(folder / "why.html");
  EXPECT_THAT(page, AllOf(StartsWith("<!DOCTYPE html>"), HasSubstr("q.txt, line 2"), HasSubstr("is proved"),
                          HasSubstr("<em>(otherwise)</em>"),
                          testing::Not(testing::AnyOf(HasSubstr("http:"), HasSubstr("https:"), HasSubstr("src=\"")))));
  const json told = scene_in(page), scene = told.at("scene");
  EXPECT_EQ(told.at("question").at("line"), 2);
  EXPECT_EQ(told.at("question").at("is"), "disjoint");
  EXPECT_EQ(scene.at("bodies").at(0).at("points").size(), 4U);
  EXPECT_EQ(scene.at("bodies").at(1).at("points").size(), 8U);
  EXPECT_EQ(scene.at("bodies").at(1).at("edges").size(), 12U);
  EXPECT_EQ(scene.at("marks").size(), 1U) << "the closest points";
  EXPECT_GE(scene.at("steps").size(), 2U);

  const Outcome again = run(in(folder) + "q.txt --page why.html --question 3");
  EXPECT_EQ(again.code, 2) << "no file is replaced that was not to be";
  EXPECT_THAT(again.err, AllOf(HasSubstr("why.html"), HasSubstr("--overwrite")));
  EXPECT_EQ(content(folder / "why.html"), page);
  EXPECT_EQ(run(in(folder) + "q.txt --page hit.html --question 3").code, 1);
  EXPECT_EQ(scene_in(content(folder / "hit.html")).at("question").at("line"), 3);
  const Outcome none = run(in(folder) + "q.txt --page none.html --question 9");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("line 9 is no question"));
  EXPECT_EQ(run("test -e " + (folder / "none.html")).code, 1);
  EXPECT_EQ(run(in(folder) + "q.txt --question 1").code, 2);

  if (!has_browser()) return;
  const Outcome shown = in_browser(page, R"(addEventListener('DOMContentLoaded', () => {
const find = id => document.getElementById(id), said = [], lines = id => find(id).querySelectorAll('line').length;
said.push(!find('stage').hidden, lines('bodies') >= 18, find('told').textContent);
find('after').click();
said.push(find('told').textContent, find('bodies').querySelectorAll('circle').length > 4, lines('differences') > 0);
said.push([...document.querySelectorAll('tr.fails')].map(row => row.dataset.step).join());
document.title = 'said ' + said.join(' ');
}))");
  EXPECT_THAT(shown.out, HasSubstr("said true true 1 of 2 2 of 2 true true 1")) << shown.err;
  const Outcome hit = in_browser(content(folder / "hit.html"), R"(addEventListener('DOMContentLoaded', () => {
const find = id => document.getElementById(id);
document.title = ['said', find('bodies').querySelectorAll('line').length > 100, find('step').offsetParent === null].join(' ');
}))");
  EXPECT_THAT(hit.out, HasSubstr("said true true")) << hit.err;
}

// Whatever is asked, of whichever figures, there is something to look at, or it is said why not.
TEST(Replay, EveryQuestionHasAPage) {
  const Folder folder;
  std::string lines;
  std::size_t count = 0;
  for (const QuestionForm& form : question_forms()) {
    const bool is_of_ray = form.name.starts_with("first_hit") || form.name == "hits";
    for (const char* figure :
         {"aabb3 0 0 0 1 2 3", "capsule3 0 0 0 1 1 1 0.5 rigid 3 1 0 1 1 0 0", "halfspace3 0 0 1 2", "segment2 0 0 3 1",
          "point3 0x1p-1000 0x1p1000 1", "cap3 0 0 0 1 0 0 1 0"}) {
      lines += form.name;
      for (std::size_t i = 0; i < form.figures; ++i)
        lines += std::string(" | ") + (i == 0 && is_of_ray               ? "ray3 -3 0 0 1 0 0"
                                       : i == 1 && form.name == "locate" ? "point3 0 0 1"
                                       : i % 2 == 0                      ? figure
                                                                         : "obb3 2 2 2 1 0 0 0 1 0 0 0 1 1 1 1");
      if (form.numbers > 0) lines += " |";
      for (std::size_t i = 0; i < form.numbers; ++i) lines += i == 0 ? " 1" : " 0";
      lines += '\n';
      ++count;
    }
  }
  write(folder, "q.txt", lines);
  ASSERT_GT(count, 100U);
  std::string all;
  for (std::size_t n = 1; n <= count; ++n)
    all += "$PLUMB replay q.txt --page p" + std::to_string(n) + ".html --question " + std::to_string(n) +
           " > told.txt 2> errors.txt || cat errors.txt\n";
  const Outcome o = run("cd " + (folder / "") + " && " + all);
  EXPECT_EQ(o.out, "");
  std::size_t drawn = 0;
  for (std::size_t n = 1; n <= count; ++n) {
    const std::string page = content(folder / ("p" + std::to_string(n) + ".html"));
    const json scene = scene_in(page).at("scene");
    for (const json& body : scene.at("bodies")) {
      if (body.at("points").empty()) {
        EXPECT_THAT(page, HasSubstr("not drawn: ")) << n;
      } else {
        ++drawn;
      }
    }
    EXPECT_THAT(page, testing::Not(HasSubstr("null"))) << n;  // as what is no number is written
  }
  EXPECT_GT(drawn, count);
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
