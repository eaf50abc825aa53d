#include "plumb/world/clashes.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "space/bvh/parts.hpp"
#include "world/clash_found.hpp"
#include "world/clash_instances.hpp"
#include "world/grown_box.hpp"

namespace plumb {
namespace {

using world::FoundClash, world::PlacedPair, world::PlacedShape;

/// The box of all its vertices, grown on all sides; a mesh without triangles has none.
std::optional<Aabb3> grown_box(const TriangleMesh& mesh, double by) {
  if (mesh.triangles.empty() || mesh.vertices.empty()) return {};
  Aabb3 box{mesh.vertices[0], mesh.vertices[0]};
  for (const Point3& p : mesh.vertices) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  if (by == 0) return box;
  return world::grown(box, by);
}

Clash turned_round(Clash clash) {
  if (clash.inner) clash.inner = 1 - *clash.inner;
  if (clash.depth) {
    const Vector3& d = clash.depth->direction;
    clash.depth->direction = {-d.x, -d.y, -d.z};
  }
  for (TrianglePair& p : clash.meeting) std::swap(p.a, p.b);
  std::ranges::sort(clash.meeting, {}, [](const TrianglePair& p) { return std::pair(p.a, p.b); });
  return clash;
}

/// Two parts in the order in which they are asked, and as whose image.
struct Asked {
  std::uint32_t a, b;
  bool turned;
  std::optional<double> clearance;
  std::size_t question;
};

}  // namespace

std::vector<AskedPair> pairs_in_reach(std::span<const TriangleMesh> parts, double reach) {
  std::vector<Aabb3> boxes;
  std::vector<std::uint32_t> numbers;
  const double half = reach / 2 > 0 ? reach / 2 : reach;  // what halving the least double loses is made up for below
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    if (const auto box = grown_box(parts[i], half)) {
      boxes.push_back(*box);
      numbers.push_back(i);
    }
  }
  std::vector<AskedPair> pairs;
  for (const BoxPair& p : overlapping_pairs(boxes))
    pairs.push_back({std::min(numbers[p.a], numbers[p.b]), std::max(numbers[p.a], numbers[p.b]), {}});
  std::ranges::sort(pairs, {}, [](const AskedPair& p) { return std::pair(p.a, p.b); });
  return pairs;
}

Clashes find_clashes(std::span<const TriangleMesh> parts, std::span<const AskedPair> pairs,
                     const ClashesOptions& options) {
  const std::vector<PlacedShape> shapes = world::placed_shapes(parts);
  std::map<std::pair<PlacedPair, std::optional<double>>, std::size_t> known;
  std::vector<Asked> all, questions;
  std::vector<std::uint8_t> is_used(parts.size());
  for (const AskedPair& p : pairs) {
    Asked asked{p.a, p.b, world::comes_after(parts[p.a], parts[p.b]), p.clearance ? p.clearance : options.clearance, 0};
    if (asked.turned) std::swap(asked.a, asked.b);
    const auto [at, is_new] =
        known.try_emplace({world::placed_pair(shapes[asked.a], shapes[asked.b]), asked.clearance}, questions.size());
    asked.question = at->second;
    all.push_back(asked);
    if (!is_new) continue;
    questions.push_back(asked);
    is_used[p.a] = is_used[p.b] = 1;
  }
  std::vector<std::unique_ptr<ClashPart>> made(parts.size());
  const std::size_t steps = parts.size() + questions.size();
  const auto share_of = [&](std::size_t before, std::size_t of) {
    return options.progress ? Progress([&options, before, of, steps](double share) {
      return options.progress((static_cast<double>(before) + share * static_cast<double>(of)) /
                              static_cast<double>(steps));
    })
                            : Progress();
  };
  space::for_parts("find_clashes", options.execution, share_of(0, parts.size()), parts.size(), [&](std::size_t i) {
    if (is_used[i] == 0) return;
    // The mesh is the caller's, who keeps it as long as this lasts.
    const std::shared_ptr<const TriangleMesh> seen(std::shared_ptr<void>(), &parts[i]);
    made[i] = std::make_unique<ClashPart>(seen, Execution::serial);
  });
  std::vector<FoundClash> answers(questions.size());
  space::for_parts(
      "find_clashes", options.execution, share_of(parts.size(), questions.size()), questions.size(),
      [&](std::size_t q) {
        const Asked& asked = questions[q];
        answers[q] = world::find_clash_and_place(*made[asked.a], *made[asked.b], {asked.clearance, options.measure});
      });
  Clashes result{{}, pairs.size(), questions.size()};
  for (const Asked& asked : all) {
    const FoundClash& answer = answers[asked.question];
    if (answer.clash.kind == ClashKind::apart) continue;
    Clash clash = answer.clash;
    const bool is_of_other = asked.turned && answer.at.kind == world::PlaceKind::nearest;
    clash.place = is_of_other ? world::place_of(parts[asked.b], parts[asked.a],
                                                {world::PlaceKind::nearest, answer.at.b, answer.at.a})
                              : world::place_of(parts[asked.a], parts[asked.b], answer.at);
    if (asked.turned)
      result.found.push_back({asked.b, asked.a, turned_round(std::move(clash))});
    else
      result.found.push_back({asked.a, asked.b, std::move(clash)});
  }
  std::ranges::sort(result.found, {}, [](const PartClash& p) { return std::pair(p.a, p.b); });
  return result;
}

Clashes find_clashes(std::span<const TriangleMesh> parts, const ClashesOptions& options) {
  return find_clashes(parts, pairs_in_reach(parts, std::max(0.0, options.clearance.value_or(0))), options);
}

}  // namespace plumb
