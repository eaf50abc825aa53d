// Rays as others shoot them: plain doubles as commonly written, and CGAL's Epick.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

/// Moller and Trumbore 1997, with an epsilon for parallel rays; t where it hits.
std::optional<double> plain_hit(const Ray3& ray, const Triangle3& triangle);
std::optional<double> plain_hit(const Segment3& segment, const Triangle3& triangle);
/// The quadratic.
std::optional<double> plain_hit(const Ray3& ray, const Sphere3& sphere);
/// Three slabs, with divisions.
std::optional<double> plain_hit(const Ray3& ray, const Aabb3& box);

bool plain_hits(const Ray3& ray, const Triangle3& triangle);
bool plain_hits(const Segment3& segment, const Triangle3& triangle);
bool plain_hits(const Ray3& ray, const Sphere3& sphere);
bool plain_hits(const Ray3& ray, const Aabb3& box);

/// The nearest of many, one after the other.
std::optional<std::uint32_t> plain_first_hit(const Ray3& ray, std::span<const Triangle3> triangles);

/// CGAL's do_intersect, and intersection in doubles, of its exact predicates' kernel.
bool cgal_hits(const Ray3& ray, const Triangle3& triangle);
bool cgal_hits(const Segment3& segment, const Triangle3& triangle);
bool cgal_hits(const Ray3& ray, const Aabb3& box);

}  // namespace plumb::bench
