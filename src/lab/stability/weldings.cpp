// Vertices that lie within a length of one another become one: who leaves some apart, who loses others, and whose result
// hangs on the order of the file.  Distances are judged in GMP's rationals.
#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "lab/stability/experiment.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/surface/repair/weld.hpp"

namespace plumb::lab::stability {
namespace {

constexpr double tolerance = 0x1p-10;
constexpr std::size_t vertices_of_cloud = 24;

using Cloud = std::vector<Point3>;
/// Each vertex becomes the one of this number.
using Into = std::vector<std::uint32_t>;

mpq_class exact_square(const Point3& p, const Point3& q) {
  const mpq_class x = mpq_class(p.x) - mpq_class(q.x), y = mpq_class(p.y) - mpq_class(q.y),
                  z = mpq_class(p.z) - mpq_class(q.z);
  return x * x + y * y + z * z;
}

template <class Key, class KeyOf>
Into first_of_key(const Cloud& cloud, KeyOf key_of) {
  std::map<Key, std::uint32_t> first;
  Into into;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) into.push_back(first.emplace(key_of(cloud[i]), i).first->second);
  return into;
}

/// Cells as wide as the tolerance: what rounds to the same one is one.
Into by_grid(const Cloud& cloud) {
  return first_of_key<std::array<double, 3>>(cloud, [](const Point3& p) {
    return std::array{std::round(p.x / tolerance), std::round(p.y / tolerance), std::round(p.z / tolerance)};
  });
}

/// Equal bits are one vertex; a tolerance it has none.
Into by_hashing(const Cloud& cloud) {
  return first_of_key<std::array<std::uint64_t, 3>>(cloud, [](const Point3& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                      std::bit_cast<std::uint64_t>(p.z)};
  });
}

template <class T>
bool are_near(const Point3& p, const Point3& q) {
  const T x = T(p.x) - T(q.x), y = T(p.y) - T(q.y), z = T(p.z) - T(q.z);
  return x * x + y * y + z * z <= T(tolerance) * T(tolerance);
}

/// Each in the order of the file becomes the first that is near.
Into by_first_come(const Cloud& cloud) {
  Into into;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    std::uint32_t k = 0;
    while (k < i && !(into[k] == k && are_near<double>(cloud[k], cloud[i]))) ++k;
    into.push_back(k);
  }
  return into;
}

/// Sorted by x, compared as floats with those before until x is too far.
Into by_sorting(const Cloud& cloud) {
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return static_cast<float>(cloud[i].x); });
  Into into(order.begin(), order.end());
  std::iota(into.begin(), into.end(), 0U);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i; k-- > 0;) {
      const std::uint32_t v = order[i], w = order[k];
      if (static_cast<float>(cloud[v].x) - static_cast<float>(cloud[w].x) > static_cast<float>(tolerance)) break;
      if (into[w] != w || !are_near<float>(cloud[v], cloud[w])) continue;
      into[v] = w;
      break;
    }
  }
  return into;
}

template <WeldRule rule>
Into by_ours(const Cloud& cloud) {
  return find_weld({cloud, {}}, {.tolerance = tolerance, .rule = rule}).into;
}

struct WeldingWay {
  std::string name;
  Into (*weld)(const Cloud& cloud);
  bool exact = false;
  bool keeps_near = true;  // promises that no vertex moves farther than the tolerance
};

const std::vector<WeldingWay>& welding_ways() {
  static const std::vector<WeldingWay> all{{"grid", by_grid},
                                           {"hashing", by_hashing},
                                           {"sorted", by_sorting},
                                           {"first-come", by_first_come},
                                           {"exact", by_ours<WeldRule::clusters>, true},
                                           {"exact, chains", by_ours<WeldRule::chains>, true, false}};
  return all;
}

/// Which vertices short steps connect, by numbers of groups.
std::vector<std::uint32_t> connected(const Cloud& cloud) {
  std::vector<std::uint32_t> group(cloud.size());
  std::iota(group.begin(), group.end(), 0U);
  const mpq_class most = mpq_class(tolerance) * mpq_class(tolerance);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (group[i] == group[k] || exact_square(cloud[i], cloud[k]) > most) continue;
      const std::uint32_t from = group[i], to = group[k];
      std::ranges::replace(group, from, to);
    }
  }
  return group;
}

/// The groups by their points, whatever their numbers.
std::multiset<std::multiset<std::array<double, 3>>> groups_of(const Cloud& cloud, const Into& into) {
  std::map<std::uint32_t, std::multiset<std::array<double, 3>>> by_first;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    by_first[into[i]].insert({cloud[i].x + 0.0, cloud[i].y + 0.0, cloud[i].z + 0.0});
  std::multiset<std::multiset<std::array<double, 3>>> all;
  for (auto& [first, group] : by_first) all.insert(std::move(group));
  return all;
}

using FillCloud = void (*)(Cloud& cloud, Entropy& entropy);

Point3 any_place(Entropy& entropy) {
  return {unit_coordinate(entropy), unit_coordinate(entropy), unit_coordinate(entropy)};
}

/// Pairs of points at about the tolerance, along an axis or not.
void fill_pairs(Cloud& cloud, Entropy& entropy) {
  while (cloud.size() < vertices_of_cloud) {
    const Point3 p = any_place(entropy);
    Point3 q = p;
    const double by = tolerance * (entropy.below(3) == 0 ? 0.5 : 1) + static_cast<double>(entropy.within(2)) * 0x1p-53;
    (entropy.below(2) == 0 ? q.x : entropy.below(2) == 0 ? q.y : q.z) += by;
    cloud.push_back(p), cloud.push_back(q);
  }
}

/// The vertices of triangles that are written each with its own, with errors of ulps.
void fill_copies(Cloud& cloud, Entropy& entropy) {
  while (cloud.size() < vertices_of_cloud) {
    const auto at = [&] { return 0.1 * static_cast<double>(entropy.within(20)); };
    const Point3 p{at(), at(), at()};
    for (int copy = 0; copy < 2; ++copy) {
      const auto off = [&] { return static_cast<double>(entropy.within(2)) * 0x1p-52; };
      cloud.push_back({p.x + off(), p.y + off(), p.z + off()});
    }
  }
}

/// Steps of three quarters of the tolerance, one behind the other.
void fill_chains(Cloud& cloud, Entropy& entropy) {
  while (cloud.size() < vertices_of_cloud) {
    Point3 p = any_place(entropy);
    for (int step = 0; step < 6; ++step) {
      cloud.push_back(p);
      p.x += 0.75 * tolerance;
    }
  }
}

/// The pairs, a hundred thousand units from the origin.
void fill_far(Cloud& cloud, Entropy& entropy) {
  fill_pairs(cloud, entropy);
  for (Point3& p : cloud) p = {p.x + 100'000, p.y + 100'000, p.z + 100'000};
}

/// Equal points, some with 0.0 and some with -0.0.
void fill_zeros(Cloud& cloud, Entropy& entropy) {
  while (cloud.size() < vertices_of_cloud) {
    const auto zero = [&] { return entropy.below(2) == 0 ? 0.0 : -0.0; };
    const auto x = static_cast<double>(entropy.within(9));
    cloud.push_back({x, zero(), zero()});
  }
}

Findings welded_clouds(FillCloud fill, const Settings& settings) {
  Findings findings;
  const std::vector<Count> none{{"pairs within the tolerance, far from all else, that were left apart"},
                                {"vertices lost to one that no short steps lead to"},
                                {"vertices that moved farther than the tolerance"},
                                {"clouds whose groups hang on the order of the vertices"}};
  for (const WeldingWay& way : welding_ways()) findings.outcomes.push_back({way.name, none, way.exact});
  const mpq_class most = mpq_class(tolerance) * mpq_class(tolerance);
  for (std::uint64_t i = 0, n = settings.quick ? 30 : 1000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    Cloud cloud;
    fill(cloud, entropy);
    const std::vector<std::uint32_t> group = connected(cloud);
    std::vector<std::size_t> order(cloud.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t k = 1; k < order.size(); ++k) std::swap(order[k], order[entropy.below(k + 1)]);
    Cloud shuffled;
    for (const std::size_t k : order) shuffled.push_back(cloud[k]);
    for (std::size_t m = 0; m < welding_ways().size(); ++m) {
      const WeldingWay& way = welding_ways()[m];
      std::vector<Count>& counts = findings.outcomes[m].counts;
      const Into into = way.weld(cloud);
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
            const auto scene = [&](std::string name, std::string about, FillCloud fill) {
              return Scene{std::move(name), std::move(about), [=] { return welded_clouds(fill, settings); }};
            };
            return std::vector{
                scene("pairs", "pairs of vertices at half the tolerance, or at it but for ulps", fill_pairs),
                scene("copies", "vertices that are written twice, with errors of ulps", fill_copies),
                scene("chains", "rows of vertices in steps below the tolerance", fill_chains),
                scene("far", "the pairs, a hundred thousand units from the origin", fill_far),
                scene("zeros", "equal vertices, with 0.0 and -0.0", fill_zeros)};
          }};
}

}  // namespace plumb::lab::stability
