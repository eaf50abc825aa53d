// Does `plumb convex` say how the hulls of two meshes lie, and prove it?
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/browser.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

/// A cube, one beside it, one on it, one within, a bent sheet, a needle.
std::string in(const Folder& folder) {
  write_mesh(folder / "cube.obj", solids::box({0, 0, 0}, {4, 4, 4}));
  write_mesh(folder / "beside.obj", solids::box({7, 8, 0}, {9, 9, 4}));
  write_mesh(folder / "on.obj", solids::box({1, 1, 4}, {2, 2, 9}));
  write_mesh(folder / "in.obj", solids::box({1, 1, 3}, {2, 2, 5}));
  std::ofstream(folder / "bent.obj") << "v 0 0 4\nv 4 0 4\nv 4 4 5\nv 0 4 4\nv 9 9 9\nf 1 2 3\nf 1 3 4\n";
  std::ofstream(folder / "needle.obj") << "v 5 2 2\nv 6 2 2\nv 5.5 2 2\nf 1 2 3\n";
  return "cd " + (folder / "") + " && $PLUMB convex ";
}

TEST(Convex, SaysHowFarAndBetweenWhich) {
  const Folder folder;
  const Outcome o = run(in(folder) + "cube.obj beside.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("cube.obj: 8 vertices, 12 triangles, closed; convex\n"),
                           HasSubstr("disjoint, 5 apart\n"), HasSubstr("proved by a direction: 3/8 1/2 0\n")));
}

TEST(Convex, SaysHowDeep) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_THAT(run(at + "cube.obj in.obj").out, HasSubstr("overlapping, 1 deep\n"));
  EXPECT_THAT(run(at + "cube.obj on.obj").out, AllOf(HasSubstr("touching\n"), Not(HasSubstr("moved by"))));
  const json said = json::parse(run(at + "cube.obj in.obj --json").out);
  EXPECT_EQ(said.at("program"), "plumb convex");
  EXPECT_EQ(said.at("relation"), "overlapping");
  EXPECT_EQ(said.at("distance"), 0.0);
  EXPECT_EQ(said.at("penetration").at("depth"), 1.0);
  EXPECT_EQ(json::parse(run(at + "cube.obj beside.obj --json").out).at("penetration"), nullptr);
}

TEST(Convex, TakesHullsOfWhateverThereIs) {
  const Folder folder;
  const std::string at = in(folder);
  const Outcome bent = run(at + "bent.obj needle.obj");
  EXPECT_EQ(bent.code, 0) << bent.err;
  EXPECT_THAT(
      bent.out,
      AllOf(HasSubstr("bent.obj: 5 vertices, 2 triangles, not closed; hull of 5 vertices, not convex itself: vertex 4"),
            HasSubstr("needle.obj: 3 vertices, 1 triangles, not closed; hull of 2 vertices, not convex")));
  const json said = json::parse(run(at + "cube.obj needle.obj --json").out);
  EXPECT_EQ(said.at("distance"), 1.0);
  EXPECT_EQ(said.at("hulls")[1].at("vertex_numbers"), (json{0, 1}));
  EXPECT_EQ(said.at("nearest")[1].at("vertex_numbers"), (json{0}));
  EXPECT_EQ(said.at("nearest")[1].at("point"), (json{5.0, 2.0, 2.0}));
}

TEST(Convex, TakesPointsWithoutFaces) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream(folder / "cloud.obj") << "v 5 2 2\nv 7 1 2\nv 7 3 2\nv 7 2 4\nv 6.5 2 2.5\n";
  std::ofstream(folder / "wire.obj") << "v 5 2 2\nv 6 2 2\nl 1 2\n";
  std::ofstream(folder / "point.ply") << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                         "property float y\nproperty float z\nend_header\n4 4 4\n";
  const Outcome cloud = run(at + "cube.obj cloud.obj");
  EXPECT_EQ(cloud.code, 0) << cloud.err;
  EXPECT_THAT(cloud.out,
              AllOf(HasSubstr("cloud.obj: 5 vertices, 0 triangles, not closed; hull of 4 vertices, not convex "
                              "itself: it has no faces\n"),
                    HasSubstr("disjoint, 1 apart\n")));
  EXPECT_THAT(run(at + "wire.obj cloud.obj").out, HasSubstr("touching\n"));
  EXPECT_THAT(run(at + "point.ply cube.obj --history steps").out, HasSubstr("touching\n"));
  EXPECT_THAT(content(folder / "steps/bodies.obj"), HasSubstr("o a\nv 4 4 4\np 1\no b\n"));
  EXPECT_THAT(run(at + "wire.obj wire.obj").out,
              AllOf(HasSubstr("overlapping, 0 deep\na plane has one on each side"), Not(HasSubstr("moved by"))));
  EXPECT_EQ(run("cd " + (folder / "") + " && $PLUMB distance wire.obj cube.obj").code, 2);
}

TEST(Convex, ProofsArePythonsToo) {
  const Folder folder;
  const std::string at = in(folder), check = "python3 " PLUMB_SOURCE_DIR "/docs/verify_certificate.py ";
  for (const std::string other : {"beside.obj", "on.obj", "in.obj", "needle.obj", "cube.obj"}) {
    EXPECT_EQ(run(at + "cube.obj " + other + " --certificate " + other + ".json").code, 0) << other;
    const Outcome o = run(check + (folder / (other + ".json")));
    EXPECT_EQ(o.code, 0) << other << o.out << o.err;
  }
  std::string proof = content(folder / "beside.obj.json");
  const std::size_t claim = proof.find("disjoint");
  ASSERT_NE(claim, std::string::npos);
  std::ofstream(folder / "lie.json") << proof.replace(claim, 8, "touching");
  EXPECT_NE(run(check + (folder / "lie.json")).code, 0);
}

TEST(Convex, HistoryIsFramesAndAPage) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_EQ(run(at + "cube.obj beside.obj --history steps").code, 0);
  const std::string page = content(folder / "steps/index.html");
  EXPECT_THAT(content(folder / "steps/bodies.obj"), AllOf(HasSubstr("o a\nv 0 0 0\n"), HasSubstr("o b\nv 7 8 0\n")));
  EXPECT_THAT(content(folder / "steps/step-001.obj"), AllOf(HasSubstr("o simplex\n"), HasSubstr("o between\n")));
  EXPECT_THAT(page, Not(AnyOf(HasSubstr("src=\"http"), HasSubstr("href=\"http"))));
  if (has_browser()) {
    const Outcome shown = in_browser(page, R"(addEventListener('DOMContentLoaded', () => {
const slider = document.getElementById('step');
slider.value = slider.max;
slider.dispatchEvent(new Event('input'));
document.title = [slider.max > 0, document.querySelectorAll('#bodies line').length > 24, document.querySelectorAll('#differences circle').length > 2,
                  document.getElementById('told').textContent === `${slider.max} of ${slider.max}`].join();
});)");
    EXPECT_THAT(shown.out, HasSubstr("<title>true,true,true,true</title>")) << shown.err;
  }
  // Again: the report's own files are replaced, others are kept.
  std::ofstream(folder / "steps/mine.txt") << "kept";
  EXPECT_EQ(run(at + "cube.obj in.obj --history steps").code, 0);
  EXPECT_EQ(content(folder / "steps/mine.txt"), "kept");
}

TEST(Convex, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream(folder / "empty.obj") << "# nothing\n";
  const std::pair<const char*, const char*> refusals[] = {{"", "two meshes are needed"},
                                                          {"cube.obj", "two meshes are needed"},
                                                          {"cube.obj cube.obj cube.obj", "two meshes are needed"},
                                                          {"cube.obj none.obj", "none.obj"},
                                                          {"- - <cube.obj", "'-' stands twice"},
                                                          {"cube.obj empty.obj", "empty.obj"},
                                                          {"--json cube.obj in.obj", "which is kept"},
                                                          {"cube.obj in.obj --certificate in.obj", "in.obj"},
                                                          {"cube.obj in.obj --history no/steps", "no/steps"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
