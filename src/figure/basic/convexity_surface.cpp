#include <algorithm>
#include <array>

#include "figure/basic/chain_convexity.hpp"
#include "figure/basic/mesh_input.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "figure/basic/surface_proof.hpp"

namespace plumb {
namespace {

/// Seen from the middle o of a tetrahedron a, b, c, d, through the vertex e: is the point g to the left of f, around
/// the line from o to e?  For a viewer on the far side of e, in steps of less than half a turn.
struct LeftAroundLine {
  static constexpr std::string_view name = "left_around_line";
  static constexpr int points = 7;
  static constexpr int dimension = 3;

  template <class T>
  constexpr auto operator()(const std::array<T, 21>& p) const {
    const auto out = [&p](std::size_t axis) {  // four times from o to e
      const auto along = [&](std::size_t point) { return p[12 + axis] - p[3 * point + axis]; };
      return (along(0) + along(1)) + (along(2) + along(3));
    };
    const auto from_e = [&p](std::size_t point, std::size_t axis) { return p[3 * point + axis] - p[12 + axis]; };
    const auto minor = [&](std::size_t i, std::size_t j) {
      return from_e(5, i) * from_e(6, j) - from_e(5, j) * from_e(6, i);
    };
    return out(0) * minor(1, 2) + out(1) * minor(2, 0) + out(2) * minor(0, 1);
  }
};

class SurfaceProof {
 public:
  explicit SurfaceProof(const PolygonMesh& mesh) : mesh_(mesh), faces_{mesh} {}

  SurfaceConvexity run() {
    result_.strictly = true;
    if (find_tetrahedron() && use_all_vertices() && check_faces() && pair_edges() && join_faces() && bend_outward() &&
        face_outward() && wind_once()) {
      return result_;
    }
    result_.strictly = false;
    return result_;
  }

  [[nodiscard]] std::vector<std::uint32_t> across() const {
    std::vector<std::uint32_t> across;
    across.reserve(twin_.size());
    for (const std::uint32_t corner : twin_) across.push_back(face_of_[corner]);
    return across;
  }

 private:
  using Index = std::uint32_t;
  [[nodiscard]] const Point3& at(Index vertex) const { return mesh_.vertices[vertex]; }
  [[nodiscard]] Index vertex_of(Index corner) const { return mesh_.corners[corner]; }
  [[nodiscard]] Index next(Index corner) const {
    const Index face = face_of_[corner];
    return corner + 1 == mesh_.first[face + 1] ? mesh_.first[face] : corner + 1;
  }
  [[nodiscard]] Index previous(Index corner) const {
    const Index face = face_of_[corner];
    return (corner == mesh_.first[face] ? mesh_.first[face + 1] : corner) - 1;
  }

  bool fail(SurfaceFlaw flaw, Index face, Index other_face, Index vertex, Index other_vertex) {
    result_ = {flaw, face, other_face, vertex, other_vertex, false};
    return false;
  }

  /// Four vertices that are not in a plane: their middle is inside, if there is an inside.
  bool find_tetrahedron() {
    const PlaneOfPoints plane = plane_of_points(mesh_.vertices);
    if (plane.dimension < 3) return fail(SurfaceFlaw::no_volume, 0, 0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i) tetrahedron_[i] = static_cast<Index>(plane.span[i]);
    tetrahedron_[3] = static_cast<Index>(plane.off);
    return true;
  }

  bool use_all_vertices() {
    std::vector<bool> used(mesh_.vertices.size());
    for (const Index v : mesh_.corners) used[v] = true;
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused == used.end()) return true;
    return fail(SurfaceFlaw::unused_vertex, 0, 0, static_cast<Index>(unused - used.begin()), 0);
  }

  bool check_faces() {
    std::vector<Point2> flat;
    face_of_.reserve(mesh_.corners.size());
    for (Index f = 0; f < faces_.size(); ++f) {
      const auto corners = faces_[f];
      face_of_.insert(face_of_.end(), corners.size(), f);
      const auto corner_at = [&](std::size_t k) -> const Point3& { return at(corners[k]); };
      const PlaneOfPoints plane = plane_of_points(corners.size(), corner_at);
      if (plane.dimension == 3) return fail(SurfaceFlaw::face_not_planar, f, 0, corners[plane.off], 0);
      if (plane.dimension < 2) return fail(SurfaceFlaw::face_not_convex, f, 0, 0, 0);
      const auto [i, j, k] = plane.span;
      spans_.push_back({corners[i], corners[j], corners[k]});
      if (corners.size() == 3) continue;
      const Look look = look_at_plane(corner_at(i), corner_at(j), corner_at(k));
      flat.clear();
      bool repeated = corner_at(0) == corner_at(corners.size() - 1);
      for (std::size_t c = 0; c < corners.size(); ++c) {
        flat.push_back(projected(look, corner_at(c)));
        repeated = repeated || (c > 0 && corner_at(c) == corner_at(c - 1));
      }
      const PolygonConvexity said = chain_convexity(flat);
      if (!said.is_convex() || repeated) return fail(SurfaceFlaw::face_not_convex, f, 0, 0, 0);
      result_.strictly = result_.strictly && said.kind == PolygonKind::strictly_convex;
    }
    return true;
  }

  /// Each edge is to be passed twice, both ways.
  bool pair_edges() {
    struct Use {
      std::uint64_t edge;
      Index corner;
    };
    std::vector<Use> uses;
    uses.reserve(mesh_.corners.size());
    for (Index c = 0; c < mesh_.corners.size(); ++c) {
      const std::uint64_t a = vertex_of(c), b = vertex_of(next(c));
      uses.push_back({std::min(a, b) << 32 | std::max(a, b), c});
    }
    std::sort(uses.begin(), uses.end(),
              [](const Use& l, const Use& r) { return l.edge < r.edge || (l.edge == r.edge && l.corner < r.corner); });
    twin_.resize(uses.size());
    for (std::size_t k = 0; k < uses.size();) {
      std::size_t end = k + 1;
      while (end < uses.size() && uses[end].edge == uses[k].edge) ++end;
      const Index c = uses[k].corner, d = uses[end - 1].corner;
      if (end - k != 2 || vertex_of(c) == vertex_of(d))
        return fail(SurfaceFlaw::open_edge, face_of_[c], 0, vertex_of(c), vertex_of(next(c)));
      twin_[c] = d;
      twin_[d] = c;
      k = end;
    }
    return true;
  }

  bool join_faces() {
    std::vector<bool> reached(faces_.size());
    std::vector<Index> open{0};
    reached[0] = true;
    while (!open.empty()) {
      const Index f = open.back();
      open.pop_back();
      for (Index c = mesh_.first[f]; c < mesh_.first[f + 1]; ++c) {
        const Index g = face_of_[twin_[c]];
        if (reached[g]) continue;
        reached[g] = true;
        open.push_back(g);
      }
    }
    const auto apart = std::find(reached.begin(), reached.end(), false);
    if (apart == reached.end()) return true;
    return fail(SurfaceFlaw::several_pieces, 0, static_cast<Index>(apart - reached.begin()), 0, 0);
  }

  /// Positive for a point below the face.
  [[nodiscard]] Sign below(Index face, Index vertex) const {
    const auto [a, b, c] = spans_[face];
    return orient3d(at(a), at(b), at(c), at(vertex));
  }

  [[nodiscard]] bool all_face_inward() const {
    for (Index f = 0; f < faces_.size(); ++f) {
      for (const Index v : tetrahedron_) {
        if (below(f, v) == Sign::positive) return false;
      }
    }
    return true;
  }

  bool fail_outside_in(SurfaceFlaw flaw, Index face, Index other_face, Index vertex, Index other_vertex) {
    return all_face_inward() ? fail(SurfaceFlaw::inside_out, 0, 0, 0, 0)
                             : fail(flaw, face, other_face, vertex, other_vertex);
  }

  /// Of the face across a ridge all corners that are not on the ridge lie on one side; the first that is off the plane
  /// tells.
  bool bend_outward() {
    for (Index c = 0; c < mesh_.corners.size(); ++c) {
      const Index f = face_of_[c], g = face_of_[twin_[c]];
      if (f > g) continue;
      Sign side = Sign::zero;
      for (Index k = next(next(twin_[c])); k != twin_[c] && side == Sign::zero; k = next(k))
        side = below(f, vertex_of(k));
      if (side == Sign::negative)
        return fail_outside_in(SurfaceFlaw::concave_ridge, f, g, vertex_of(c), vertex_of(next(c)));
      if (side == Sign::zero) result_.strictly = false;
    }
    return true;
  }

  bool face_outward() {
    for (Index f = 0; f < faces_.size(); ++f) {
      for (const Index v : tetrahedron_) {
        if (below(f, v) == Sign::negative) return fail_outside_in(SurfaceFlaw::seen_from_behind, f, 0, v, 0);
      }
    }
    return true;
  }

  /// Around each vertex, by the edges that leave it, counterclockwise: each is at most half a turn from the one before.
  bool wind_once() {
    std::vector<bool> seen(mesh_.corners.size());
    const auto& [p, q, r, s] = tetrahedron_;
    for (Index start = 0; start < mesh_.corners.size(); ++start) {
      if (seen[start]) continue;
      const Index v = vertex_of(start), origin = vertex_of(next(start));
      bool upper = true;  // in the half turn that begins at the first edge
      int turns = 0;
      Index c = start;
      do {  // twin and previous are one to one, so that it comes back to where it began
        seen[c] = true;
        c = twin_[previous(c)];
        const Sign side =
            sign_of(LeftAroundLine{}, at(p), at(q), at(r), at(s), at(v), at(origin), at(vertex_of(next(c))));
        const bool was_upper = upper;
        upper = side == Sign::zero ? !upper : side == Sign::positive;
        turns += !was_upper && upper;
      } while (c != start);
      if (turns != 1) return fail(SurfaceFlaw::winds_twice, face_of_[start], 0, v, 0);
    }
    return true;
  }

  const PolygonMesh& mesh_;
  PolygonFaces faces_;
  SurfaceConvexity result_;
  std::array<Index, 4> tetrahedron_{};
  std::vector<Index> face_of_;               // of each corner
  std::vector<std::array<Index, 3>> spans_;  // of each face, three vertices that span its plane, counterclockwise
  std::vector<Index> twin_;                  // of each corner, that from which the edge runs back
};

}  // namespace

SurfaceConvexity prove_convex(const PolygonMesh& mesh, std::vector<std::uint32_t>* across) {
  SurfaceProof proof(mesh);
  const SurfaceConvexity result = proof.run();
  if (across != nullptr && result.is_convex()) *across = proof.across();
  return result;
}

SurfaceConvexity convexity(const PolygonMesh& mesh) {
  require_mesh("convexity", mesh);
  return prove_convex(mesh);
}

SurfaceConvexity convexity(const TriangleMesh& mesh) {
  require_mesh("convexity", mesh);
  return prove_convex(polygon_mesh(mesh));
}

bool is_convex(const PolygonMesh& mesh) { return convexity(mesh).is_convex(); }
bool is_convex(const TriangleMesh& mesh) { return convexity(mesh).is_convex(); }

std::string describe(const SurfaceConvexity& c) {
  const auto with = [](std::string_view words, std::uint32_t number) {
    return std::string(words).append(std::to_string(number));
  };
  const std::string face = with("face ", c.face), vertex = with("vertex ", c.vertex);
  const std::string edge = with("the edge from vertex ", c.vertex).append(with(" to vertex ", c.other_vertex));
  switch (c.flaw) {
    case SurfaceFlaw::none:
      return {};
    case SurfaceFlaw::no_volume:
      return "all vertices lie in one plane; at least a tetrahedron is wanted";
    case SurfaceFlaw::unused_vertex:
      return std::string(vertex).append(" belongs to no face; leave it out");
    case SurfaceFlaw::face_not_planar:
      return std::string(face).append(" is not planar: ").append(vertex).append(" is off its plane; triangulate it");
    case SurfaceFlaw::face_not_convex:
      return std::string(face).append(" is not a convex polygon of distinct corners that has an area");
    case SurfaceFlaw::open_edge:
      return std::string(edge).append(" of ").append(face).append(
          " is not shared with just one other face that passes it the other way");
    case SurfaceFlaw::several_pieces:
      return std::string(face).append(with(" and face ", c.other_face)).append(" are not joined by faces across edges");
    case SurfaceFlaw::inside_out:
      return "the faces are clockwise seen from outside; reverse them";
    case SurfaceFlaw::concave_ridge:
      return with("the ridge between face ", c.face)
          .append(with(" and face ", c.other_face))
          .append(", ")
          .append(edge)
          .append(", is concave");
    case SurfaceFlaw::seen_from_behind:
      return std::string(vertex).append(" lies above ").append(face).append("; all must be on or below every face");
    case SurfaceFlaw::winds_twice:
      return std::string("the faces around ").append(vertex).append(" go around it more than once");
  }
  return {};
}

}  // namespace plumb
