// The committed test vectors: what the generator writes, true, and hard for the float ways that they are meant to
// catch.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "certify/sanitized.hpp"
#include "lab/trial/location_tests.hpp"
#include "lab/trial/terms.hpp"
#include "lab/vectors/command.hpp"
#include "lab/vectors/sized_cases.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "tool/run_program.hpp"
#include "tool/trial/task.hpp"

namespace plumb::lab {
namespace {

namespace fs = std::filesystem;
const fs::path folder = fs::path(PLUMB_SOURCE_DIR) / "docs/vectors";

/// Read as docs/vectors.md tells other languages to.
struct Vector {
  std::vector<double> numbers;
  std::vector<std::string> answer;
  std::string input;
  std::set<std::string> wrong;
};

std::vector<Vector> read(const std::string& text, const std::string& task) {
  std::vector<Vector> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    Vector v;
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word;
    words >> word;
    EXPECT_EQ(word, task);
    while (words >> word && word != "=") v.numbers.push_back(std::strtod(word.c_str(), nullptr));
    while (words >> word) v.answer.push_back(word);
    std::istringstream remark(line.substr(line.find('#') + 1));
    remark >> v.input;
    if (v.input.ends_with(';')) v.input.pop_back();
    while (remark >> word) {
      if (word != "wrong:") v.wrong.insert(word);
    }
    all.push_back(std::move(v));
  }
  return all;
}

double number_of(const std::vector<std::string>& answer, const std::string& task) {
  if (task.starts_with("hull")) {
    double corners = 0;
    for (const std::string& i : answer) corners += std::ldexp(1, std::stoi(i));
    return corners;
  }
  const std::string& word = answer.at(0);
  if (word == "+" || word == "yes") return 1;
  if (word == "-") return -1;
  return word == "0" || word == "no" ? 0 : std::strtod(word.c_str(), nullptr);
}

double said(const trial::Task& task, std::string_view method, const std::vector<double>& numbers) {
  const auto found = std::ranges::find(task.methods, method, &trial::Method::name);
  const auto round = found->prepare(numbers, trial::scene_of(numbers));
  round->answer();
  return round->given(0);
}

/// The same case for the kind of that name, which says how many points follow where there may be any number.
degenerate::Numbers as_asked_of_kinds(const std::string& task, degenerate::Numbers numbers) {
  if (task == "point-in-polygon") numbers.insert(numbers.begin() + 2, 8);
  if (task == "point-in-polyhedron" || task == "ray-mesh") {
    numbers.insert(numbers.begin() + (task == "ray-mesh" ? 6 : 3), 6);
    numbers.push_back(static_cast<double>(trial::octahedron_faces.size()));
    for (const auto& face : trial::octahedron_faces) numbers.insert(numbers.end(), face.begin(), face.end());
  }
  if (task == "convex-distance") {
    numbers.insert(numbers.begin() + 12, 4);
    numbers.insert(numbers.begin(), 4);
  }
  return numbers;
}

TEST(Vectors, AreThoseOfTheKinds) {
  int shared = 0;
  for (const degenerate::Kind& kind : degenerate::kinds()) {
    const std::string name(kind.name);
    const std::vector<Vector> vectors = read(content(folder / (name + ".txt")), name);
    if (vectors.empty()) continue;
    ++shared;
    std::set<std::string> inputs;
    for (const Vector& v : vectors) {
      const degenerate::Numbers numbers = as_asked_of_kinds(name, v.numbers);
      EXPECT_EQ(flaw_of(kind, numbers), "") << name;
      EXPECT_EQ(kind.exact(numbers).numbers.at(0), number_of(v.answer, name)) << name;
      inputs.insert(v.input);
    }
    if (std::ranges::any_of(kind.arguments, &degenerate::Argument::any_number)) continue;
    for (const degenerate::Generator& g : kind.generators)
      EXPECT_TRUE(inputs.contains(g.name)) << name << ' ' << g.name;
  }
  EXPECT_GE(shared, 10);
}

// Of questions about any number of points every generator has its cases, and the kinds' own answers, which the library
// gives, are those of the rationals in the files.
TEST(Vectors, OfAnySizeCoverEveryGenerator) {
  for (const SizedTask& task : sized_tasks()) {
    const degenerate::Kind& kind = degenerate::kind_named(task.kind);
    const std::vector<Vector> vectors = read(content(folder / (sized_name(task) + ".txt")), sized_name(task));
    std::set<std::string> inputs, answers;
    std::set<std::size_t> sizes;
    for (const Vector& v : vectors) {
      EXPECT_EQ(flaw_of(kind, v.numbers), "") << sized_name(task);
      const degenerate::Numbers ours = kind.exact(v.numbers).numbers;
      if (task.kind == "hull") {
        const std::set<double> corners(ours.begin(), ours.end());
        std::set<double> told;
        for (const std::string& i : v.answer) told.insert(std::stod(i));
        if (!corners.empty()) {  // flat ones have no triangles
          EXPECT_EQ(corners, told) << v.input;
        }
      } else {
        EXPECT_EQ(ours.at(0), number_of(v.answer, std::string(task.kind))) << sized_name(task) << ' ' << v.input;
      }
      inputs.insert(v.input);
      answers.insert(v.answer.at(0));
      sizes.insert(v.numbers.size());
    }
    for (const degenerate::Generator& g : kind.generators)
      EXPECT_TRUE(inputs.contains(g.name)) << sized_name(task) << ' ' << g.name;
    EXPECT_GE(answers.size(), 2U) << sized_name(task);
    EXPECT_GE(sizes.size(), 3U) << sized_name(task);
  }
  for (const degenerate::Kind& kind : degenerate::kinds()) {
    const bool any = std::ranges::any_of(kind.arguments, &degenerate::Argument::any_number);
    EXPECT_EQ(any, std::ranges::find(sized_tasks(), kind.name, &SizedTask::kind) != sized_tasks().end()) << kind.name;
  }
}

TEST(Vectors, AreWhatTheProgramWrites) {
  if (battery::sanitized) {  // one way of each kind of answer; all of them take a minute there
    for (const char* task : {"orient3d", "segment-segment-distance"}) {
      for (const NamedText& file : vector_files(2026, task))
        EXPECT_TRUE(content(folder / file.name) == file.text) << file.name;
    }
    return;
  }
  const std::vector<NamedText> files = vector_files(2026);
  EXPECT_GE(files.size(), 16);
  std::set<std::string> names;
  std::uintmax_t bytes = 0;
  std::string list;
  for (const NamedText& file : files) {
    names.insert(file.name);
    list += file.name + '\n';
    bytes += file.text.size();
    EXPECT_TRUE(content(folder / file.name) == file.text) << file.name << ": run plumb-lab vectors --out docs/vectors";
  }
  EXPECT_LT(bytes, 1'200'000);
  names.insert(".plumb-vectors-files");
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_TRUE(names.contains(entry.path().filename())) << entry.path();
  EXPECT_EQ(content(folder / ".plumb-vectors-files"), list);
}

TEST(Vectors, AreTrueAndCatchEveryUsualWay) {
  for (const trial::Task& task : vector_tasks()) {
    const std::string text = content(folder / (task.name + ".txt"));
    if (text.empty()) continue;
    const std::vector<Vector> vectors = read(text, task.name);
    std::map<std::string, int> caught;
    std::set<std::string> inputs, answers;
    for (const Vector& v : vectors) {
      ASSERT_EQ(v.numbers.size(), task.numbers);
      const double answer = number_of(v.answer, task.name);
      EXPECT_EQ(task.judge(v.numbers), answer) << task.name;           // rationals
      EXPECT_EQ(said(task, "exact", v.numbers), answer) << task.name;  // ours
      if (task.kind != trial::AnswerKind::number) {
        for (const std::string_view method : marked_methods) {
          EXPECT_EQ(v.wrong.contains(std::string(method)), said(task, method, v.numbers) != answer)
              << task.name << ' ' << method;
        }
      }
      inputs.insert(v.input);
      answers.insert(v.answer.empty() ? "" : v.answer[0]);
      for (const std::string& method : v.wrong) ++caught[method];
    }
    for (const trial::InputClass& input : task.classes)
      EXPECT_TRUE(inputs.contains(input.name)) << task.name << ' ' << input.name;
    EXPECT_GE(answers.size(), 2U) << task.name;
    for (const std::string_view method : marked_methods) {
      if (task.name == "box-box" && method == "double") continue;  // compares, and rounds nothing
      EXPECT_GE(caught[std::string(method)], 2) << task.name << ' ' << method;
    }
    EXPECT_EQ(task.name == "box-box", caught["double"] == 0) << task.name;
  }
}

TEST(Vectors, OthersComeFromOtherSeedsAndNothingIsHalfWritten) {
  const auto other = vector_files(7, "orient2d");
  ASSERT_EQ(other.size(), 1);
  EXPECT_NE(other[0].text, content(folder / "orient2d.txt"));
  EXPECT_EQ(run("$PLUMB_LAB vectors").code, 2);
  const Outcome o = run("$PLUMB_LAB vectors --out /dev/null/x");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, testing::HasSubstr("/dev/null/x"));
}

}  // namespace
}  // namespace plumb::lab
