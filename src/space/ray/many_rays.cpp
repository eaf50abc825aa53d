// Many rays: blocks of them, each ray by itself.
#include <algorithm>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "space/bvh/blocks.hpp"
#include "space/bvh/parts.hpp"

namespace plumb {
namespace {

constexpr std::size_t rays_of_block = 256;

/// out[i] = answer(i).
template <class Answer, class Out>
void answer_all(const char* function, std::span<const AnyRay> rays, std::span<Out> out, const ManyRays& options,
                const Answer& answer) {
  if (out.size() != rays.size()) {
    throw UnequalLengths(std::string(function)
                             .append(": out has ")
                             .append(std::to_string(out.size()))
                             .append(" items, rays has ")
                             .append(std::to_string(rays.size())));
  }
  const std::size_t parts = space::blocks_of(rays.size(), rays_of_block);
  space::for_parts(function, options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t from = part * rays_of_block, to = std::min(rays.size(), from + rays_of_block);
    for (std::size_t i = from; i < to; ++i) out[i] = answer(rays[i]);
  });
}

}  // namespace

void first_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::optional<NumberedHit>> out,
                const ManyRays& options) {
  answer_all("first_hits", rays, out, options, [&](const AnyRay& ray) { return first_hit(ray, bvh, options.rule); });
}
void first_triangles(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::uint32_t> out,
                     const ManyRays& options) {
  answer_all("first_triangles", rays, out, options,
             [&](const AnyRay& ray) { return first_triangle(ray, bvh, options.rule).value_or(no_triangle); });
}
void hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::uint8_t> out, const ManyRays& options) {
  answer_all("hits", rays, out, options,
             [&](const AnyRay& ray) { return static_cast<std::uint8_t>(hits(ray, bvh, options.rule) ? 1 : 0); });
}
void ordered_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::vector<NumberedHit>> out,
                  const ManyRays& options) {
  answer_all("ordered_hits", rays, out, options,
             [&](const AnyRay& ray) { return ordered_hits(ray, bvh, options.rule); });
}
void count_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::size_t> out, const ManyRays& options) {
  answer_all("count_hits", rays, out, options, [&](const AnyRay& ray) { return count_hits(ray, bvh, options.rule); });
}

}  // namespace plumb
