#include "query/contact/clipped_features.hpp"

namespace plumb::query::touching {

FoundCorners found_corners(const SeenFeature& a, const SeenFeature& b, const Sides& on_a, const Sides& on_b) {
  FoundCorners found;
  for (std::size_t j = 0; j < b.size() && (a.size() > 1 || b.size() == 1); ++j) {
    const auto p = on_a.place(j);
    if (!p) continue;
    const bool both = p->kind == FeatureKind::vertex;
    found.push_back({both ? CornerKind::both_vertices : CornerKind::vertex_of_b,
                     static_cast<Index>(both ? p->index : 0),
                     static_cast<Index>(j),
                     {a.at(*p), b.vertex(j)}});
  }
  for (std::size_t i = 0; i < a.size() && b.size() > 1; ++i) {
    const auto p = on_b.place(i);
    if (!p) continue;
    const bool both = p->kind == FeatureKind::vertex;
    if (both && a.size() > 1) continue;  // named before
    found.push_back({both ? CornerKind::both_vertices : CornerKind::vertex_of_a,
                     static_cast<Index>(i),
                     static_cast<Index>(both ? p->index : 0),
                     {a.vertex(i), b.at(*p)}});
  }
  if (!on_a.has_outer() || !on_b.has_outer()) return found;  // no edge leaves the other feature
  for (std::size_t i = 0; i < a.edges(); ++i) {
    const std::size_t next = i + 1 == a.size() ? 0 : i + 1;
    for (std::size_t j = 0; j < b.edges(); ++j) {
      const std::size_t after = j + 1 == b.size() ? 0 : j + 1;
      const auto differ = [](Sign s, Sign t) { return s != Sign::zero && s == -t; };
      if (!differ(on_a(i, j), on_a(i, after)) || !differ(on_b(j, i), on_b(j, next))) continue;
      found.push_back({CornerKind::edges, static_cast<Index>(i), static_cast<Index>(j), {a.f.edges[i], b.f.edges[j]}});
    }
  }
  return found;
}

}  // namespace plumb::query::touching
