// Vertices that lie within a length of one another become one: who leaves some apart, who loses others, and whose result
// hangs on the order of the file.  Distances are judged in GMP's rationals.
#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "lab/crowd/weld_ways.hpp"
#include "lab/stability/experiment.hpp"
#include "plumb/surface/repair/weld.hpp"

namespace plumb::lab::stability {
namespace {

using trial::weld_tolerance;
using trial::WeldCloud;
using trial::WeldInto;

mpq_class exact_square(const Point3& p, const Point3& q) {
  const mpq_class x = mpq_class(p.x) - mpq_class(q.x), y = mpq_class(p.y) - mpq_class(q.y),
                  z = mpq_class(p.z) - mpq_class(q.z);
  return x * x + y * y + z * z;
}

template <WeldRule rule>
WeldInto by_ours(const WeldCloud& cloud) {
  return find_weld({cloud, {}}, {.tolerance = weld_tolerance, .rule = rule}).into;
}

struct WeldingWay {
  std::string name;
  WeldInto (*weld)(const WeldCloud& cloud);
  bool exact = false;
  bool keeps_near = true;  // promises that no vertex moves farther than the tolerance
};

const std::vector<WeldingWay>& welding_ways() {
  static const std::vector<WeldingWay> all{{"grid", trial::by_grid},
                                           {"hashing", trial::by_hashing},
                                           {"sorted", trial::by_sorting},
                                           {"first-come", trial::by_first_come},
                                           {"exact", by_ours<WeldRule::clusters>, true},
                                           {"exact, chains", by_ours<WeldRule::chains>, true, false}};
  return all;
}

/// The groups by their points, whatever their numbers.
std::multiset<std::multiset<std::array<double, 3>>> groups_of(const WeldCloud& cloud, const WeldInto& into) {
  std::map<std::uint32_t, std::multiset<std::array<double, 3>>> by_first;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    by_first[into[i]].insert({cloud[i].x + 0.0, cloud[i].y + 0.0, cloud[i].z + 0.0});
  std::multiset<std::multiset<std::array<double, 3>>> all;
  for (auto& [first, group] : by_first) all.insert(std::move(group));
  return all;
}

Findings welded_clouds(const trial::WeldFamily& family, const Settings& settings) {
  Findings findings;
  const std::vector<Count> none{{"pairs within the tolerance, far from all else, that were left apart"},
                                {"vertices lost to one that no short steps lead to"},
                                {"vertices that moved farther than the tolerance"},
                                {"clouds whose groups hang on the order of the vertices"}};
  for (const WeldingWay& way : welding_ways()) findings.outcomes.push_back({way.name, none, way.exact});
  const mpq_class most = mpq_class(weld_tolerance) * mpq_class(weld_tolerance);
  for (std::uint64_t i = 0, n = settings.quick ? 30 : 1000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    WeldCloud cloud;
    family.fill(cloud, entropy);
    const std::vector<std::uint32_t> group = trial::connected_in_truth(cloud);
    std::vector<std::size_t> order(cloud.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t k = 1; k < order.size(); ++k) std::swap(order[k], order[entropy.below(k + 1)]);
    WeldCloud shuffled;
    for (const std::size_t k : order) shuffled.push_back(cloud[k]);
    for (std::size_t m = 0; m < welding_ways().size(); ++m) {
      const WeldingWay& way = welding_ways()[m];
      std::vector<Count>& counts = findings.outcomes[m].counts;
      const WeldInto into = way.weld(cloud);
      for (std::uint32_t v = 0; v < cloud.size(); ++v) {
        ++counts[1].of;
        counts[1].failures += group[v] != group[into[v]];
        if (way.keeps_near) {
          ++counts[2].of;
          counts[2].failures += exact_square(cloud[v], cloud[into[v]]) > most;
        }
        if (std::ranges::count(group, group[v]) != 2) continue;
        const auto other =
            std::ranges::find_if(group, [&](const std::uint32_t& g) { return g == group[v] && &g != &group[v]; });
        const auto w = static_cast<std::uint32_t>(other - group.begin());
        if (w < v) continue;
        ++counts[0].of;
        counts[0].failures += into[v] != into[w];
      }
      ++counts[3].of;
      counts[3].failures += groups_of(cloud, into) != groups_of(shuffled, way.weld(shuffled));
    }
  }
  return findings;
}

}  // namespace

Experiment welding_experiment() {
  return {"welding", "which vertices become one, and does the order of the file matter?", "RTCD 12.1.1",
          [](const Settings& settings) {
            std::vector<Scene> scenes;
            for (const trial::WeldFamily& family : trial::weld_families())
              scenes.push_back({family.name, family.about, [=] { return welded_clouds(family, settings); }});
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
