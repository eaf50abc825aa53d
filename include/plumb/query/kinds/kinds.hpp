// Which functions of other people's can be held against the exact answer?  The kinds of questions, by name.
//
//   orient2d orient3d incircle insphere                 double f(const double a[3], ...): its sign counts
//   segment-segment segment-segment-3d triangle-triangle box-box obb-obb
//                                                       int f(const double a[9], const double b[9])
//   ray-triangle                    int f(const double ray[6], const double triangle[9], double* t)
//   ray-mesh                        int f(const double ray[6], const double* vertices, size_t n,
//                                         const size_t* triangles, size_t m, double* t)
//   point-in-polygon                int f(const double p[2], const double* vertices, size_t n)
//   point-in-polyhedron             int f(const double p[3], const double* vertices, size_t n,
//                                         const size_t* triangles, size_t m)
//   convex-distance                 double f(const double* a, size_t n, const double* b, size_t m)
//   hull                            size_t f(const double* points, size_t n, size_t* triangles, size_t capacity)
//
// Laws: those of degenerate/kind.hpp; figures are closed sets, and degenerate ones the sets they are.
// Source: RTCD 11.
// Cost: a table.  Nothing is searched.
#pragma once

#include <span>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

std::span<const Kind> kinds();

/// The signs of all other predicates (certify/catalog.hpp), by their names: double f(const double a[3], ...).
std::span<const Kind> predicate_kinds();

/// Of both; nullptr where there is none of that name.
const Kind* find_kind(std::string_view name);

/// Throws Error, which lists the names there are.
const Kind& kind_named(std::string_view name);

}  // namespace plumb::degenerate
