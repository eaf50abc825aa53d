#include "plumb/world/gpu_filter.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "world/gpu/canvas.hpp"
#include "world/gpu/cells.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::Canvas;
using world::CellRange;
using world::CellView;
using world::DrawnShape;
using world::RangeSpan;

int bits_of(std::uint32_t resolution) {
  if (resolution < 16 || resolution > 1024 || !std::has_single_bit(resolution)) {
    throw Error("GpuFilter: the resolution is " + std::to_string(resolution) +
                "; it must be a power of two from 16 to 1024");
  }
  return std::countr_zero(resolution);
}

/// What both have, in which any common point lies.
Aabb3 common(const Aabb3& a, const Aabb3& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

struct Scene {
  std::vector<std::vector<world::Placed>> placed;
  std::vector<DrawnShape> shapes;

  explicit Scene(std::span<const AnyBody> bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      world::about([&] { return "GpuFilter: body " + std::to_string(i); },
                   [&] {
                     placed.push_back(world::placed_parts(bodies[i]));
                     shapes.push_back(world::drawn_shape(placed.back()));
                     return 0;
                   });
    }
  }
  [[nodiscard]] std::vector<BoxPair> box_pairs() const {
    std::vector<Aabb3> boxes;
    for (const DrawnShape& s : shapes) boxes.push_back(s.box);
    std::vector<BoxPair> pairs = overlapping_pairs(boxes);
    std::ranges::sort(pairs);
    return pairs;
  }
  [[nodiscard]] Relation relation(const BoxPair& p) const { return world::relation_of_parts(placed[p.a], placed[p.b]); }
};

template <class Draw>
RangeSpan drawn(std::vector<CellRange>& ranges, const Draw& draw) {
  const std::size_t first = ranges.size();
  draw(ranges);
  return {first, ranges.size() - first};
}

}  // namespace

struct GpuFilter::State {
  explicit State(const GpuFilterOptions& options) : pixel_bits(bits_of(options.resolution)), canvas(pixel_bits) {}

  /// Leaves of the set those that one axis does not show alone.
  void look_along(std::size_t axis, const Scene& scene, std::vector<std::uint32_t>& set) {
    Aabb3 box = scene.shapes[set[0]].box;
    for (const std::uint32_t i : set) box = world::joined(box, scene.shapes[i].box);
    const CellView view(box, box, axis, pixel_bits);
    std::vector<CellRange> ranges;
    std::vector<RangeSpan> spans;
    for (const std::uint32_t i : set)
      spans.push_back(drawn(ranges, [&](auto& to) { view.draw_faces(scene.shapes[i], 0, to); }));
    canvas.upload(ranges);
    std::size_t query = 0;
    for (const bool from_behind : {false, true}) {
      for (const bool backward : {false, true}) {
        canvas.clear_depths();
        for (std::size_t k = 0; k < set.size(); ++k) {
          const RangeSpan& body = spans[backward ? set.size() - 1 - k : k];
          canvas.ask_depths(body, query++, from_behind);
          canvas.draw_depths(body, from_behind);
        }
      }
    }
    const std::vector<bool> is_behind = canvas.read(query);
    counts.queries += query;
    ++counts.readbacks;
    std::vector<std::uint32_t> left;
    const std::size_t n = set.size();
    for (std::size_t k = 0; k < n; ++k) {
      const bool in_front = !is_behind[k] && !is_behind[n + (n - 1 - k)];
      const bool at_the_back = !is_behind[2 * n + k] && !is_behind[3 * n + (n - 1 - k)];
      if (!in_front && !at_the_back) left.push_back(set[k]);
    }
    set = std::move(left);
  }

  std::vector<std::uint32_t> colliding_set(const Scene& scene) {
    std::vector<std::uint32_t> set(scene.shapes.size());
    for (std::size_t i = 0; i < set.size(); ++i) set[i] = static_cast<std::uint32_t>(i);
    for (std::size_t before = set.size() + 1; set.size() < before && !set.empty();) {
      before = set.size();
      for (std::size_t axis = 0; axis < 3 && !set.empty(); ++axis) look_along(axis, scene, set);
    }
    counts.in_set = set.size();
    return set;
  }

  /// Which of these, at most as many as there are tiles, may meet by a view along the axis?
  std::vector<bool> ask_batch(std::size_t axis, const Scene& scene, std::span<const BoxPair> pairs) {
    struct Drawn {
      RangeSpan faces_a, faces_b, edges_a, edges_b;
    };
    std::vector<CellRange> ranges(1);  // that which a whole tile is drawn by
    std::vector<Drawn> parts(pairs.size());
    const auto shape_a = [&](std::size_t i) -> const DrawnShape& { return first_of(scene, pairs[i]); };
    const auto shape_b = [&](std::size_t i) -> const DrawnShape& { return second_of(scene, pairs[i]); };
    std::vector<CellView> views;
    for (const BoxPair& p : pairs) {
      const Aabb3 &a = scene.shapes[p.a].box, &b = scene.shapes[p.b].box;
      views.emplace_back(common(a, b), world::joined(a, b), axis, pixel_bits);
    }
    const auto both_surfaces = [&](std::size_t i) { return shape_a(i).is_surface; };  // a solid comes first
    const auto both_solids = [&](std::size_t i) { return !shape_b(i).is_surface; };
    // All of one kind stand together, so that one draw has them.
    const auto gather = [&](const auto& is_wanted, RangeSpan Drawn::*part, const auto& draw) {
      return drawn(ranges, [&](auto& to) {
        for (std::size_t i = 0; i < pairs.size(); ++i)
          if (is_wanted(i)) parts[i].*part = drawn(to, [&](auto& into) { draw(i, into); });
      });
    };
    const auto faces_of = [&](const auto& shape) {
      return [&, shape](std::size_t i, auto& to) { views[i].draw_faces(shape(i), std::int32_t(i), to); };
    };
    const auto edges_of = [&](const auto& shape) {
      return [&, shape](std::size_t i, auto& to) { views[i].draw_edges(shape(i), std::int32_t(i), to); };
    };
    const auto not_both_surfaces = [&](std::size_t i) { return !both_surfaces(i); };
    const auto mixed = [&](std::size_t i) { return !both_surfaces(i) && !both_solids(i); };
    const RangeSpan solids_a = gather(not_both_surfaces, &Drawn::faces_a, faces_of(shape_a));
    const RangeSpan solids_b = gather(both_solids, &Drawn::faces_b, faces_of(shape_b));
    gather(mixed, &Drawn::faces_b, faces_of(shape_b));
    const RangeSpan surfaces_a = gather(both_surfaces, &Drawn::faces_a, faces_of(shape_a));
    const RangeSpan surfaces_b = gather(both_surfaces, &Drawn::faces_b, faces_of(shape_b));
    gather(both_surfaces, &Drawn::edges_a, edges_of(shape_a));
    gather(both_surfaces, &Drawn::edges_b, edges_of(shape_b));

    canvas.upload(ranges);
    std::vector<std::size_t> asker;  // of each query
    if (solids_a.count != 0) {
      canvas.clear_spans();
      canvas.draw_spans(solids_a, Canvas::Side::a);
      canvas.draw_spans(solids_b, Canvas::Side::b);
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (both_surfaces(i) || parts[i].faces_a.count == 0 || parts[i].faces_b.count == 0) continue;
      if (both_solids(i)) canvas.ask_spans(std::int32_t(i), asker.size());
      if (!both_solids(i)) canvas.ask_ranges_in_spans(parts[i].faces_b, asker.size());
      asker.push_back(i);
    }
    const auto ask_surfaces = [&](const RangeSpan& faces, RangeSpan Drawn::*edges) {
      if (faces.count == 0) return;
      canvas.clear_slices();
      canvas.draw_slices(faces);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!both_surfaces(i) || (parts[i].*edges).count == 0) continue;
        canvas.ask_ranges_in_slices(parts[i].*edges, asker.size());
        asker.push_back(i);
      }
    };
    ask_surfaces(surfaces_a, &Drawn::edges_b);
    ask_surfaces(surfaces_b, &Drawn::edges_a);
    const std::vector<bool> met = canvas.read(asker.size());
    counts.queries += asker.size();
    ++counts.readbacks;
    std::vector<bool> may(pairs.size());
    for (std::size_t q = 0; q < asker.size(); ++q)
      if (met[q]) may[asker[q]] = true;
    return may;
  }

  std::vector<BoxPair> left_of(const Scene& scene, std::span<const BoxPair> pairs) {
    counts.asked = pairs.size();
    std::vector<BoxPair> left(pairs.begin(), pairs.end());
    const auto batch = static_cast<std::size_t>(canvas.tiles());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<BoxPair> kept;
      for (std::size_t first = 0; first < left.size(); first += batch) {
        const std::span now = std::span(left).subspan(first, std::min(batch, left.size() - first));
        const std::vector<bool> may = ask_batch(axis, scene, now);
        for (std::size_t i = 0; i < now.size(); ++i)
          if (may[i]) kept.push_back(now[i]);
      }
      left = std::move(kept);
    }
    counts.kept = left.size();
    return left;
  }

  std::vector<BoxPair> pairs_left(const Scene& scene) {
    std::vector<bool> is_in(scene.shapes.size());
    for (const std::uint32_t i : colliding_set(scene)) is_in[i] = true;
    std::vector<BoxPair> pairs = scene.box_pairs();
    std::erase_if(pairs, [&](const BoxPair& p) { return !is_in[p.a] || !is_in[p.b]; });
    return left_of(scene, pairs);
  }

  static const DrawnShape& first_of(const Scene& scene, const BoxPair& p) {
    return scene.shapes[scene.shapes[p.a].is_surface ? p.b : p.a];
  }
  static const DrawnShape& second_of(const Scene& scene, const BoxPair& p) {
    return scene.shapes[scene.shapes[p.a].is_surface ? p.a : p.b];
  }

  int pixel_bits;
  Canvas canvas;
  GpuFilterCounts counts{};
};

GpuFilter::GpuFilter(const GpuFilterOptions& options) : state_(std::make_unique<State>(options)) {}
GpuFilter::GpuFilter(GpuFilter&&) noexcept = default;
GpuFilter& GpuFilter::operator=(GpuFilter&&) noexcept = default;
GpuFilter::~GpuFilter() = default;

const std::string& GpuFilter::renderer() const { return state_->canvas.renderer(); }
const GpuFilterCounts& GpuFilter::counts() const { return state_->counts; }

std::vector<std::uint32_t> GpuFilter::may_collide(std::span<const AnyBody> bodies) {
  const Scene scene(bodies);
  const Canvas::Use use(state_->canvas);
  state_->counts = {};
  return state_->colliding_set(scene);
}

std::vector<BoxPair> GpuFilter::may_meet(std::span<const AnyBody> bodies, std::span<const BoxPair> pairs) {
  const Scene scene(bodies);
  for (const BoxPair& p : pairs) {
    if (p.a >= bodies.size() || p.b >= bodies.size())
      throw Error("GpuFilter: a pair names body " + std::to_string(std::max(p.a, p.b)) + " of " +
                  std::to_string(bodies.size()));
  }
  const Canvas::Use use(state_->canvas);
  state_->counts = {};
  return state_->left_of(scene, pairs);
}

std::vector<BoxPair> GpuFilter::may_meet(std::span<const AnyBody> bodies) {
  const Scene scene(bodies);
  const Canvas::Use use(state_->canvas);
  state_->counts = {};
  return state_->pairs_left(scene);
}

std::vector<MeetingBodies> GpuFilter::meeting(std::span<const AnyBody> bodies) {
  const Scene scene(bodies);
  const Canvas::Use use(state_->canvas);
  state_->counts = {};
  std::vector<MeetingBodies> found;
  for (const BoxPair& p : state_->pairs_left(scene))
    if (const Relation r = scene.relation(p); r != Relation::disjoint) found.push_back({p.a, p.b, r});
  return found;
}

}  // namespace plumb
