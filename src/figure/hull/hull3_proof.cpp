#include "figure/hull/hull3_proof.hpp"

#include <algorithm>

namespace plumb::figure::hull3 {

Checked::Checked(const Hull3& of, std::span<const Point3> input, const HullOptions& how)
    : hull(of), points(input), options(how) {
  check_lists();
  face_of.resize(hull.corners.size());
  spanned.resize(hull.face_count());
  for (Index f = 0; f < hull.face_count(); ++f) {
    std::fill(face_of.begin() + hull.first[f], face_of.begin() + hull.first[f + 1], f);
    check_face(f);
  }
  match_edges();
}

void Checked::check_lists() const {
  const auto& [dimension, vertices, corners, first] = hull;
  require(!first.empty() && first.front() == 0 && std::ranges::is_sorted(first) && first.back() == corners.size(),
          "the list `first` does not divide the corners");
  require(std::ranges::adjacent_find(vertices, std::greater_equal<>()) == vertices.end(),
          "the vertices are not ascending");
  require(vertices.empty() || vertices.back() < points.size(), "a vertex names no point");
  std::vector<unsigned char> is_vertex(points.size(), 0);
  for (const Index v : vertices) is_vertex[v] = 1;
  std::array<Index, 2> before{};
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    require(face.size() >= 3 && (face.size() == 3 || !options.triangulate), "face ", f, " has ", face.size(),
            " corners");
    for (const Index c : face) {
      require(c < points.size() && is_vertex[c] != 0, "face ", f, " has a corner that is no vertex");
      is_vertex[c] = 2;
    }
    require(std::ranges::min(face) == face[0], "face ", f, " does not start at its smallest index");
    const std::array<Index, 2> key{face[0], face[1]};
    require(f == 0 || before < key, "face ", f, " is out of order");
    before = key;
  }
  for (const Index v : vertices) {
    require(dimension < 2 || is_vertex[v] == 2 || (options.all_boundary_points && !options.triangulate), "vertex ", v,
            " is a corner of no face");
  }
}

bool goes_around_once(std::span<const Point2> loop, bool straight) {
  const std::size_t n = loop.size();
  std::size_t turns = 0, reversals = 0;
  const auto comes_first = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 &a = loop[i], &b = loop[(i + 1) % n], &c = loop[(i + 2) % n];
    if (a == b) return false;
    const Sign s = sign_of(predicates::Orient2d{}, a, b, c);
    if (s == Sign::negative || (s == Sign::zero && !straight)) return false;
    turns += s == Sign::positive ? 1 : 0;
    const bool reverses = comes_first(a, b) != comes_first(b, c);
    if (reverses && s == Sign::zero) return false;
    reversals += reverses ? 1 : 0;
  }
  return turns >= 3 && reversals == 2;
}

void Checked::check_face(Index f) {
  const auto face = hull.face(f);
  const std::size_t n = face.size();
  std::size_t i = 0;  // the first corner at which it turns
  const auto corner = [&](std::size_t k) { return face[k % n]; };
  while (i < n && collinear(points[corner(i)], points[corner(i + 1)], points[corner(i + 2)])) ++i;
  require(i < n, "face ", f, " lies on a line");
  spanned[f] = {corner(i), corner(i + 1), corner(i + 2)};
  for (std::size_t k = 0; k < n; ++k) {
    const bool may_be_straight = n > 3 && options.all_boundary_points;
    if (may_be_straight && collinear(points[corner(k + n - 1)], points[face[k]], points[corner(k + 1)])) continue;
    bend.push_back(hull.first[f] + static_cast<Index>(k));
  }
  first_bend.push_back(static_cast<Index>(bend.size()));
  if (n == 3) return;
  const Look look = look_at_plane(points[spanned[f][0]], points[spanned[f][1]], points[spanned[f][2]]);
  std::vector<Point2> loop;
  for (const Index c : face) {
    require(side(f, points[c]) == Sign::zero, "face ", f, " is not planar");
    loop.push_back(projected(look, points[c]));
  }
  if (sign_of(predicates::Orient2d{}, loop[i], loop[(i + 1) % n], loop[(i + 2) % n]) == Sign::negative) {
    std::ranges::reverse(loop);
  }
  require(goes_around_once(loop, options.all_boundary_points), "face ", f, " is not convex");
}

void Checked::match_edges() {
  struct Edge {
    std::uint64_t key;
    Index corner;
  };
  std::vector<Edge> edges(hull.corners.size());
  const auto key = [&](Index a, Index b) { return std::uint64_t{a} << 32 | b; };
  for (Index c = 0; c < edges.size(); ++c) edges[c] = {key(hull.corners[c], hull.corners[next(c)]), c};
  std::ranges::sort(edges, {}, &Edge::key);
  const auto twice = std::ranges::adjacent_find(edges, {}, &Edge::key);
  require(twice == edges.end(), "two faces have the same edge in the same direction, and one is face ",
          twice == edges.end() ? 0 : face_of[twice->corner]);
  twin.assign(edges.size(), ~Index{0});
  flat.assign(edges.size(), 0);
  for (Index c = 0; c < edges.size(); ++c) {
    const std::uint64_t back = key(hull.corners[next(c)], hull.corners[c]);
    const auto found = std::ranges::lower_bound(edges, back, {}, &Edge::key);
    if (found != edges.end() && found->key == back) twin[c] = found->corner;
    require(twin[c] != ~Index{0} || hull.dimension < 3, "the edge from point ", hull.corners[c], " to point ",
            hull.corners[next(c)], " has a face on one side only");
  }
}

}  // namespace plumb::figure::hull3
