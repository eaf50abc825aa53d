// Into which triangles does a polygon fall?  Many are right; what is asked is whether they are a triangulation.
#include <algorithm>
#include <memory>

#include "lab/trial/cutting_judge.hpp"
#include "lab/trial/cutting_round.hpp"
#include "lab/trial/float_methods.hpp"
#include "plumb/surface/planar/triangulate_polygon.hpp"

namespace plumb::lab::trial {
namespace {

constexpr std::uint32_t lost_vertex = 1, other_area = 2, flat_triangle = 4, overlapping = 8;

double faults_of(const CutPolygon& polygon, const CutTriangles& triangles) {
  if (!triangles) return unsure;
  const CuttingJudge judge(polygon);
  return (judge.lost(*triangles) ? lost_vertex : 0) + (judge.other_area(*triangles) ? other_area : 0) +
         (judge.flat(*triangles) ? flat_triangle : 0) + (judge.overlap(*triangles) ? overlapping : 0);
}

/// The answer is the set of what is wrong with the triangles, which is judged after the clock has stopped.
class CuttingRound final : public Round {
 public:
  CuttingRound(std::span<const double> questions, const std::function<Cut(const CutPolygon&)>& make)
      : polygons_(questions_in<double, 2 * cut_corners>(questions)), made_(polygons_.size()) {
    for (const CutPolygon& polygon : polygons_) cuts_.push_back(make(polygon));
  }
  void answer() override {
    for (std::size_t i = 0; i < cuts_.size(); ++i) made_[i] = cuts_[i]();
  }
  [[nodiscard]] double given(std::size_t i) const override { return faults_of(polygons_[i], made_[i]); }

 private:
  std::vector<CutPolygon> polygons_;
  std::vector<Cut> cuts_;
  std::vector<CutTriangles> made_;
};

/// Ear by ear; an epsilon is of the question's largest coordinate, or not.
template <class T>
Method ears_method(std::string_view name, std::string_view about, double epsilon = 0, bool relative = false) {
  return cutting_method(name, about, [=](const CutPolygon& polygon) -> Cut {
    std::vector<Place<T>> points;
    for (std::size_t i = 0; i < polygon.size(); i += 2)
      points.push_back({static_cast<T>(polygon[i]), static_cast<T>(polygon[i + 1])});
    const T least = static_cast<T>(epsilon * (relative ? largest_of(polygon) : 1));
    return [points, least] { return EarClipping<T>(points, least).run(); };
  });
}

Cut cut_by_ours(const CutPolygon& numbers) {
  Polygon2 polygon;
  for (std::size_t i = 0; i < numbers.size(); i += 2) polygon.vertices.push_back({numbers[i], numbers[i + 1]});
  return [polygon]() -> CutTriangles { return triangulate(polygon); };
}

Tally count_of(std::string name, std::string about, std::uint32_t fault) {
  return {std::move(name), std::move(about),
          [fault](std::span<const double>, double, const Round& round, std::size_t i) -> std::uint64_t {
            return (static_cast<std::uint32_t>(round.given(i)) & fault) != 0 ? 1 : 0;
          }};
}

}  // namespace

Method cutting_method(std::string_view name, std::string_view about, std::function<Cut(const CutPolygon&)> make) {
  return {std::string(name), std::string(about),
          [make = std::move(make)](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
            return std::make_unique<CuttingRound>(questions, make);
          }};
}

Task triangulation_task() {
  Task task{"triangulation",
            "into which triangles does a polygon of 16 corners fall?",
            2 * cut_corners,
            AnswerKind::set,
            {},
            {},
            {},
            {},
            16};
  for (const PolygonFamily& family : polygon_families()) {
    std::string name = &family == polygon_families().data() ? "uniform" : family.name;
    std::ranges::replace(name, '-', '_');
    task.classes.push_back({std::move(name), family.about, [&family](std::span<double> q, Entropy& e) {
                              CutPolygon polygon{};
                              family.fill(polygon, e);
                              std::ranges::copy(polygon, q.begin());
                            }});
  }
  task.symmetries = {reordered(2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0}),
                     reordered(2, {8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7})};
  task.judge = [](std::span<const double>) { return 0.0; };
  task.tallies = {count_of("lost", "polygons of which the triangles lack a vertex", lost_vertex),
                  count_of("other area", "polygons covered by another area than theirs", other_area),
                  count_of("overlapping", "polygons whose triangles overlap", overlapping)};
  task.methods = {ears_method<float>("float32", "ear by ear, in single precision, of coordinates rounded to it"),
                  ears_method<double>("double", "ear by ear, as commonly written, no epsilon"),
                  ears_method<double>("absolute", "double, with an epsilon of 1e-9", customary_epsilon),
                  ears_method<double>("relative", "double, with an epsilon of 1e-9 of the largest coordinate",
                                      customary_epsilon, true),
                  ears_method<long double>("long-double", "the compiler's long double"),
                  cutting_method("exact", "ours, one at a time", cut_by_ours)};
  return task;
}

}  // namespace plumb::lab::trial
