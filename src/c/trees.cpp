#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "c/handles.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/ray/inside.hpp"
#include "plumb/space/ray/mesh_ray.hpp"

using namespace plumb;
using c::guarded, c::items, c::need;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

plumb_pairs* told(const std::vector<TrianglePair>& pairs) {
  auto out = std::make_unique<plumb_pairs>();
  for (const TrianglePair& p : pairs) {
    out->numbers.insert(out->numbers.end(), {p.a, p.b});
    out->relations.push_back(static_cast<std::int8_t>(p.relation));
  }
  return out.release();
}

plumb_pairs* told(const std::vector<BoxPair>& pairs) {
  auto out = std::make_unique<plumb_pairs>();
  for (const BoxPair& p : pairs) out->numbers.insert(out->numbers.end(), {p.a, p.b});
  return out.release();
}

void need_dimension(int dimension) {
  if (dimension != 2 && dimension != 3)
    throw c::InvalidArgument("dimension is " + std::to_string(dimension) + "; it is 2 or 3");
}

}  // namespace

extern "C" {

plumb_status plumb_bvh_create(const plumb_mesh* mesh, plumb_bvh** bvh) {
  return guarded("plumb_bvh_create", [&] {
    need(mesh, "mesh");
    need(bvh, "bvh");
    *bvh = new plumb_bvh{build_bvh(mesh->mesh)};
  });
}

void plumb_bvh_destroy(plumb_bvh* bvh) { delete bvh; }

plumb_status plumb_bvh_first_hits(const plumb_bvh* bvh, const double* origins, const double* directions,
                                  std::size_t count, std::int64_t* triangles, double* t, double* points) {
  return guarded("plumb_bvh_first_hits", [&] {
    need(bvh, "bvh");
    need(triangles, count, "triangles");
    const auto from = items<Point3>(origins, count, "origins");
    const auto along = items<Vector3>(directions, count, "directions");
    std::vector<AnyRay> rays;
    rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) rays.emplace_back(Ray3{from[i], along[i]});
    std::vector<std::optional<NumberedHit>> found(count);
    first_hit(bvh->tree, rays, found);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& hit = found[i];
      triangles[i] = hit ? std::int64_t{hit->index} : -1;
      if (t != nullptr) t[i] = hit ? hit->hit.t : infinity;
      if (points == nullptr) continue;
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      const Point3 p = hit ? hit->hit.point : Point3{none, none, none};
      std::memcpy(points + 3 * i, &p, sizeof p);
    }
  });
}

plumb_status plumb_bvh_locate(const plumb_bvh* bvh, const double* points, std::size_t count, std::int8_t* locations) {
  return guarded("plumb_bvh_locate", [&] {
    need(bvh, "bvh");
    need(locations, count, "locations");
    std::vector<Location> found(count);
    locate(bvh->tree, items<Point3>(points, count, "points"), found);
    std::ranges::transform(found, locations, [](Location l) { return static_cast<std::int8_t>(l); });
  });
}

plumb_status plumb_bvh_closest(const plumb_bvh* bvh, const double* points, std::size_t count, std::int64_t* triangles,
                               double* distances, double* nearest) {
  return guarded("plumb_bvh_closest", [&] {
    need(bvh, "bvh");
    need(triangles, count, "triangles");
    std::vector<ClosestOnMesh> found(count);
    closest_on_mesh(bvh->tree, items<Point3>(points, count, "points"), found);
    for (std::size_t i = 0; i < count; ++i) {
      triangles[i] = found[i].triangle;
      if (distances != nullptr) distances[i] = found[i].distance;
      if (nearest != nullptr) std::memcpy(nearest + 3 * i, &found[i].point, sizeof(Point3));
    }
  });
}

plumb_status plumb_bvh_distance(const plumb_bvh* a, const plumb_bvh* b, double* distance) {
  return guarded("plumb_bvh_distance", [&] {
    need(a, "a");
    need(b, "b");
    need(distance, "distance");
    *distance = plumb::distance(a->tree, b->tree);
  });
}

plumb_status plumb_bvh_intersecting_pairs(const plumb_bvh* a, const plumb_bvh* b, const plumb_progress* progress,
                                          plumb_pairs** pairs) {
  return guarded("plumb_bvh_intersecting_pairs", [&] {
    need(a, "a");
    need(pairs, "pairs");
    const PairOptions options{.progress = c::progress_of(progress)};
    *pairs = told(b == nullptr ? intersecting_pairs(a->tree, options) : intersecting_pairs(a->tree, b->tree, options));
  });
}

plumb_status plumb_overlapping_pairs(const double* boxes, std::size_t count, int dimension, plumb_pairs** pairs) {
  return guarded("plumb_overlapping_pairs", [&] {
    need(pairs, "pairs");
    need_dimension(dimension);
    *pairs = told(dimension == 2 ? overlapping_pairs(items<Aabb2>(boxes, count, "boxes"))
                                 : overlapping_pairs(items<Aabb3>(boxes, count, "boxes")));
  });
}

plumb_status plumb_pairs_of(const plumb_pairs* pairs, const std::uint32_t** numbers, const std::int8_t** relations,
                            std::size_t* count) {
  return guarded("plumb_pairs_of", [&] {
    need(pairs, "pairs");
    if (numbers != nullptr) *numbers = pairs->numbers.data();
    if (relations != nullptr) *relations = pairs->relations.empty() ? nullptr : pairs->relations.data();
    if (count != nullptr) *count = pairs->numbers.size() / 2;
  });
}

void plumb_pairs_destroy(plumb_pairs* pairs) { delete pairs; }

plumb_status plumb_points_create(const double* points, std::size_t count, int dimension, plumb_points** tree) {
  return guarded("plumb_points_create", [&] {
    need(tree, "tree");
    need_dimension(dimension);
    if (dimension == 2) {
      *tree = new plumb_points{build_kd_tree(items<Point2>(points, count, "points"))};
    } else {
      *tree = new plumb_points{build_kd_tree(items<Point3>(points, count, "points"))};
    }
  });
}

void plumb_points_destroy(plumb_points* tree) { delete tree; }

plumb_status plumb_points_nearest(const plumb_points* tree, const double* queries, std::size_t count, std::size_t k,
                                  std::int64_t* indices, double* distances) {
  return guarded("plumb_points_nearest", [&] {
    need(tree, "tree");
    need(indices, count * k, "indices");
    std::visit(
        [&]<class Point>(const KdTree<Point>& of) {
          const auto asked = items<Point>(queries, count, "queries");
          const std::size_t there = std::min(k, std::size_t{of.count});
          std::vector<NearestPoint> found(count * there);
          if (there != 0) nearest(of, asked, there, std::span(found));
          for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t m = 0; m < k; ++m) {
              const bool is_there = m < there;
              indices[i * k + m] = is_there ? std::int64_t{found[i * there + m].index} : -1;
              if (distances != nullptr) distances[i * k + m] = is_there ? found[i * there + m].distance : infinity;
            }
          }
        },
        tree->tree);
  });
}

plumb_status plumb_points_within(const plumb_points* tree, const double* query, double radius,
                                 int (*take)(std::uint32_t index, void* user), void* user) {
  return guarded("plumb_points_within", [&] {
    need(tree, "tree");
    need(query, "query");
    if (take == nullptr) throw c::InvalidArgument("take is NULL");
    std::visit(
        [&]<class Point>(const KdTree<Point>& of) {
          for (const std::uint32_t i : within(of, items<Point>(query, 1, "query")[0], radius))
            if (take(i, user) == 0) return;
        },
        tree->tree);
  });
}

}  // extern "C"
