// Which vertices are one, as steps of at most a length join them?
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <tuple>

#include "lab/crowd/crowds.hpp"
#include "lab/crowd/weld_ways.hpp"
#include "lab/trial/float_methods.hpp"
#include "plumb/surface/repair/weld.hpp"

namespace plumb::lab::trial {
namespace {

constexpr std::size_t welding_numbers = 3 * weld_vertices;
using Welder = WeldInto (*)(const WeldCloud& cloud);

WeldCloud cloud_in(std::span<const double> q) {
  WeldCloud cloud;
  for (std::size_t i = 0; i < welding_numbers; i += 3) cloud.push_back({q[i], q[i + 1], q[i + 2]});
  return cloud;
}

/// The pairs of vertices that are one, by their places in the order of coordinates: so the order of the file does not
/// count.
Pairs joined_pairs(const WeldCloud& cloud, const WeldInto& into) {
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t v) {
    const Point3& p = cloud[v];
    return std::tuple(p.x, p.y, p.z, std::signbit(p.x), std::signbit(p.y), std::signbit(p.z));
  });
  Pairs pairs;
  for (std::uint32_t i = 0; i < order.size(); ++i)
    for (std::uint32_t k = i + 1; k < order.size(); ++k)
      if (into[order[i]] == into[order[k]]) pairs.push_back({i, k});
  return pairs;
}

Pairs truly_joined(std::span<const double> q) {
  const WeldCloud cloud = cloud_in(q);
  return joined_pairs(cloud, connected_in_truth(cloud));
}

class WeldingRound final : public Round {
 public:
  WeldingRound(std::span<const double> questions, Welder weld) : weld_(weld) {
    for (std::size_t i = 0; i < questions.size(); i += welding_numbers)
      clouds_.push_back(cloud_in(questions.subspan(i, welding_numbers)));
    found_.resize(clouds_.size());
  }
  void answer() override { std::ranges::transform(clouds_, found_.begin(), weld_); }
  [[nodiscard]] double given(std::size_t i) const override { return as_answer(given_pairs(i)); }
  [[nodiscard]] Pairs given_pairs(std::size_t i) const override { return joined_pairs(clouds_[i], found_[i]); }

 private:
  const Welder weld_;
  std::vector<WeldCloud> clouds_;
  std::vector<WeldInto> found_;
};

Method welding_method(std::string_view name, std::string_view about, Welder weld) {
  return {std::string(name), std::string(about),
          [weld](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
            return std::make_unique<WeldingRound>(questions, weld);
          }};
}

WeldInto as_chains(const WeldCloud& cloud) {
  return find_weld({cloud, {}}, {.tolerance = weld_tolerance, .rule = WeldRule::chains}).into;
}

std::vector<std::size_t> every_fifth() {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < weld_vertices; ++i) order.push_back(5 * i % weld_vertices);
  return order;
}

std::vector<std::size_t> backward() {
  std::vector<std::size_t> order;
  for (std::size_t i = weld_vertices; i-- > 0;) order.push_back(i);
  return order;
}

}  // namespace

Task welding_task() {
  Task task{"welding",
            "which of 24 vertices are one, joined by steps of at most 2^-10?",
            welding_numbers,
            AnswerKind::set,
            {},
            {},
            {},
            {},
            16};
  for (const WeldFamily& family : weld_families()) {
    const bool is_harmless = &family == weld_families().data();
    task.classes.push_back(
        {is_harmless ? "uniform" : family.name, family.about, [&family](std::span<double> q, Entropy& e) {
           WeldCloud cloud;
           family.fill(cloud, e);
           for (std::size_t i = 0; i < q.size(); i += 3)
             q[i] = cloud[i / 3].x, q[i + 1] = cloud[i / 3].y, q[i + 2] = cloud[i / 3].z;
         }});
  }
  task.symmetries = {reordered(3, backward()), reordered(3, every_fifth())};
  task.judge = [](std::span<const double> q) { return as_answer(truly_joined(q)); };
  task.tallies = {{"false pairs", "pairs of vertices that are joined, and that no such steps lead between",
                   [](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return count_lacking(round.given_pairs(i), truly_joined(q));
                   }},
                  {"missed pairs", "pairs of vertices that are left apart, and that such steps lead between",
                   [](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return count_lacking(truly_joined(q), round.given_pairs(i));
                   }}};
  task.methods = {welding_method("float32", "along x, compared in single precision with those before", by_sorting),
                  welding_method("double", "every pair compared in doubles", by_each_pair<double>),
                  welding_method("grid", "rounded to multiples of the tolerance", by_grid),
                  welding_method("hashing", "equal bits", by_hashing),
                  welding_method("first-come", "each to the first of the file that is near", by_first_come),
                  welding_method("exact", "ours, by the rule of chains", as_chains)};
  return task;
}

}  // namespace plumb::lab::trial
