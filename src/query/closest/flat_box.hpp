// How are the features of a flat box numbered?  As those of the solid one, without the axis that has no length.
//
// The solid box has its third axis at the lower end: its edges are 0, 1, 4 and 5, its only face is number 4.
#pragma once

#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::query {

constexpr Feature of_flat_box(const Feature& f) {
  if (f.kind == FeatureKind::edge) return {FeatureKind::edge, f.index / 4 * 2 + f.index % 4};
  if (f.kind == FeatureKind::face) return {FeatureKind::face, 0};
  return f;
}
constexpr Feature of_solid_box(const Feature& f) {
  if (f.kind == FeatureKind::edge) return {FeatureKind::edge, f.index / 2 * 4 + f.index % 2};
  if (f.kind == FeatureKind::face) return {FeatureKind::face, 4};
  return f;
}

}  // namespace plumb::query
