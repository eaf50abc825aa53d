#include "plumb/query/ray/batch.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "figure/basic/mesh_input.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/ray/batch_lanes.hpp"
#include "query/ray/box_lanes.hpp"
#include "query/ray/numbers.hpp"
#include "query/ray/triangle_hit.hpp"

namespace plumb {
namespace query {
namespace {

constexpr std::size_t rays_chunk = 512;

struct Chunk {
  std::array<std::uint8_t, rays_chunk> told;
  std::array<double, rays_chunk> least, most;
};

/// Calls visit(i, told, least, most) for every triangle that is hit, in turn; what lanes do not tell is asked exactly.
template <class Visit>
void visit_hits(std::string_view function, const AnyRay& ray, const TriangleBatch& many, HitRule rule, Visit visit) {
  require_ray(function, ray);
  const BatchRay lanes = batch_ray(ray);
  Chunk answers;
  for (std::size_t from = 0; from < many.size(); from += rays_chunk) {
    const std::size_t n = std::min(rays_chunk, many.size() - from);
    std::array<const double*, 9> at{};
    for (std::size_t k = 0; k < 9; ++k) at[k] = many.numbers(k) + from;
    ask_lanes(lanes, at.data(), n, {answers.told.data(), answers.least.data(), answers.most.data()});
    for (std::size_t i = 0; i < n; ++i) {
      if (answers.told[i] == 0) continue;
      if (answers.told[i] == 1 || hits(ray, many[from + i], rule))
        visit(static_cast<std::uint32_t>(from + i), answers.least[i], answers.most[i]);
    }
  }
}

void require_length(std::size_t out, std::size_t many) {
  if (out == many) return;
  throw UnequalLengths(std::string("hits: out has ")
                           .append(std::to_string(out))
                           .append(" items, many has ")
                           .append(std::to_string(many)));
}

struct Near {
  std::uint32_t index;
  double least;
};

std::uint32_t nearest_of(const AnyRay& ray, const TriangleBatch& many, HitRule rule, const std::vector<Near>& all) {
  const auto decided = [&](const Near& n) {
    const Triangle3 triangle = many[n.index];
    return DecidedTriangle{triangle, *decide_hit(ray, triangle, rule)};
  };
  if (all.size() == 1) return all.front().index;
  std::uint32_t first = all.front().index;
  DecidedTriangle best = decided(all.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    const DecidedTriangle other = decided(all[i]);
    if (compare_hits(ray, other, best) == Sign::negative) first = all[i].index, best = other;
  }
  return first;
}

}  // namespace
}  // namespace query

using namespace query;

void hits(const AnyRay& ray, const TriangleBatch& many, std::span<std::uint8_t> out, HitRule rule) {
  require_length(out.size(), many.size());
  std::fill(out.begin(), out.end(), std::uint8_t{0});
  visit_hits("hits", ray, many, rule, [&](std::uint32_t i, double, double) { out[i] = 1; });
}

void hits(const AnyRay& ray, const BoxBatch& many, std::span<std::uint8_t> out) {
  require_length(out.size(), many.size());
  require_ray("hits", ray);
  const auto& [x, y, z] = ray.origin;
  const auto& e = ray.end;
  const BatchRay r = batch_ray(ray);
  const BoxBatchRay lanes{{x, y, z},
                          {r.direction[0], r.direction[1], r.direction[2]},
                          {std::min(x, e.x), std::min(y, e.y), std::min(z, e.z)},
                          {std::max(x, e.x), std::max(y, e.y), std::max(z, e.z)},
                          r.begins,
                          r.ends};
  std::array<const double*, 6> at{};
  for (std::size_t k = 0; k < 6; ++k) at[k] = many.numbers(k);
  if (has_no_direction(ray)) {
    std::fill(out.begin(), out.end(), std::uint8_t{2});
  } else {
    ask_box_lanes(lanes, at.data(), out.size(), out.data());
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] != 2) continue;
    const Aabb3 box{{at[0][i], at[1][i], at[2][i]}, {at[3][i], at[4][i], at[5][i]}};
    out[i] = hits(ray, box) ? 1 : 0;
  }
}

std::vector<std::uint32_t> all_hits(const AnyRay& ray, const TriangleBatch& many, HitRule rule,
                                    std::vector<std::uint32_t> rows) {
  rows.clear();
  visit_hits("all_hits", ray, many, rule, [&](std::uint32_t i, double, double) { rows.push_back(i); });
  return rows;
}

std::optional<NumberedHit> first_hit(const AnyRay& ray, const TriangleBatch& many, HitRule rule) {
  // Those that may be the first, as far as doubles tell.
  std::vector<Near> near;
  double nearest_end = std::numeric_limits<double>::infinity();
  visit_hits("first_hit", ray, many, rule, [&](std::uint32_t i, double least, double most) {
    if (least > nearest_end) return;
    nearest_end = std::min(nearest_end, most);
    near.push_back({i, least});
  });
  std::erase_if(near, [&](const Near& n) { return n.least > nearest_end; });
  if (near.empty()) return {};
  const std::uint32_t best = nearest_of(ray, many, rule, near);
  return NumberedHit{best, *first_hit(ray, many[best], rule)};
}

std::optional<NumberedHit> first_hit(const AnyRay& ray, const TriangleMesh& mesh, HitRule rule) {
  require_mesh("first_hit", mesh);
  return first_hit(ray, triangle_batch(mesh), rule);
}

bool hits(const AnyRay& ray, const TriangleMesh& mesh, HitRule rule) {
  require_mesh("hits", mesh);
  return std::ranges::any_of(mesh.triangles, [&](const auto& corners) {
    const auto& [a, b, c] = corners;
    return hits(ray, Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, rule);
  });
}

}  // namespace plumb
