#include "query/time_of_impact/flat_features.hpp"

#include "plumb/arith/big.hpp"

namespace plumb::query {
namespace {

using FlatPlace = Vec3<BigDyadic>;

const FlatPlace& edge_from(const FlatFeatures& a, std::size_t edge) {
  return a.body.vertices[a.body.edges[edge].ends[0]];
}
const FlatPlace& edge_to(const FlatFeatures& a, std::size_t edge) {
  return a.body.vertices[a.body.edges[edge].ends[1]];
}

/// On which side of an edge is a place?
Sign side_of_edge(const FlatFeatures& a, std::size_t edge, const FlatPlace& p) {
  const FlatPlace& from = edge_from(a, edge);
  return cross(edge_to(a, edge) - from, p - from).z.sign();
}
bool on_edge(const FlatFeatures& a, std::size_t edge, const FlatPlace& p) {
  return side_of_edge(a, edge, p) == Sign::zero &&
         dot(p - edge_from(a, edge), p - edge_to(a, edge)).sign() != Sign::positive;
}
bool same_place(const FlatPlace& p, const FlatPlace& q) {
  const FlatPlace d = p - q;
  return d.x.sign() == Sign::zero && d.y.sign() == Sign::zero;
}
/// Are the ends of f's edge strictly on both sides of e's?
bool parts_ends(const FlatFeatures& e, std::size_t i, const FlatFeatures& f, std::size_t j) {
  const Sign from = side_of_edge(e, i, edge_from(f, j)), to = side_of_edge(e, i, edge_to(f, j));
  return from != Sign::zero && from == -to;
}

}  // namespace

FlatFeatures::FlatFeatures(MovingBody<BigDyadic> given)
    : body(std::move(given)),
      whole(body.vertices.size() == 1 ? body.vertex_features[0]
            : body.faces.empty()      ? body.edges[0].feature
                                      : Feature{FeatureKind::face, 0}) {}

void add_meeting_features(const FlatFeatures& a, const FlatFeatures& b, std::vector<MeetingFeatures>& to) {
  if (a.body.swept || b.body.swept) return;  // there a vertex is no point
  const auto &vertices_a = a.body.vertices, &vertices_b = b.body.vertices;
  const auto &features_a = a.body.vertex_features, &features_b = b.body.vertex_features;
  for (std::size_t i = 0; i < vertices_a.size(); ++i) {
    for (std::size_t j = 0; j < vertices_b.size(); ++j) {
      if (same_place(vertices_a[i], vertices_b[j])) to.push_back({features_a[i], features_b[j]});
    }
    for (std::size_t j = 0; j < b.body.edges.size(); ++j) {
      if (on_edge(b, j, vertices_a[i])) to.push_back({features_a[i], b.body.edges[j].feature});
    }
  }
  for (std::size_t i = 0; i < a.body.edges.size(); ++i) {
    for (std::size_t j = 0; j < vertices_b.size(); ++j) {
      if (on_edge(a, i, vertices_b[j])) to.push_back({a.body.edges[i].feature, features_b[j]});
    }
    for (std::size_t j = 0; j < b.body.edges.size(); ++j) {
      if (parts_ends(a, i, b, j) && parts_ends(b, j, a, i))
        to.push_back({a.body.edges[i].feature, b.body.edges[j].feature});
    }
  }
}

}  // namespace plumb::query
