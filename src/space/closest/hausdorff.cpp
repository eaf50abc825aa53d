// Branch and bound over pieces of a's triangles, those that may reach farthest first.
//
// The distance from a convex set is convex: over a piece, that from any one triangle of b is largest at a corner, and
// is no less than that from b.  So the best of a few triangles bounds a piece from above, and each of its points bounds
// the whole from below.  A corner is an exact point of a's triangle, of which a double is known and how far off it is.
#include "plumb/space/closest/hausdorff.hpp"

#include <limits>
#include <queue>
#include <string>

#include "plumb/figure/containment/contains.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/hausdorff_tolerance.hpp"
#include "space/closest/near_sources.hpp"
#include "space/closest/nearby_corner.hpp"
#include "space/closest/numbered_triangles.hpp"
#include "space/closest/piece_cut.hpp"
#include "space/closest/rounded_images.hpp"

namespace plumb {
namespace space {
namespace {

constexpr double beyond = std::numeric_limits<double>::infinity();

/// A part of a triangle of a.
struct Piece {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t from;     // the triangle's number
  std::uint32_t nearest;  // a triangle of b from which no point of the piece is farther than `most`
  double most;
  std::uint8_t crossings = 0;  // so many of the last cuts were at borders
  bool middle_known = false;
};

/// Then an edge is halved, so that pieces become small.
constexpr std::uint8_t most_crossings = 4;

struct NotAsFar {
  bool operator()(const Piece& x, const Piece& y) const {
    return x.most != y.most ? x.most < y.most : x.corners > y.corners;
  }
};

class FarthestSearch {
 public:
  /// Of the work that progress is told of, the part between two shares is done here.
  FarthestSearch(const char* function, const Bvh& a, const Bvh& b, const HausdorffOptions& options, double done_before,
                 double done_after)
      : function_(function),
        b_(b),
        as_(a),
        bs_(b),
        options_(options),
        done_before_(done_before),
        done_after_(done_after),
        extent_(std::max(as_.extent(), bs_.extent())) {
    ask_vertices(a);
  }

  /// Makes `known`, of distances that count as well, that of all.
  void run(HausdorffDistance& known, bool of_b) {
    for (std::uint32_t i = 0; i < as_.size(); ++i) {
      for (const std::uint32_t v : as_.corners(i)) offer(known, corners_[corner_of_vertex_[v]], i, of_b);
    }
    for (std::uint32_t i = 0; i < as_.size(); ++i) {
      const auto [u, v, w] = as_.corners(i);
      Piece piece{{corner_of_vertex_[u], corner_of_vertex_[v], corner_of_vertex_[w]}, i, 0, beyond};
      if (i < bs_.size()) bound_by(piece, i);  // a guess: the other mesh may be this one, changed a little
      bound_by_corners(piece);
      push(known, piece);
    }
    known.most = std::max(known.most, bound_of_all(known, of_b));
    if (known.of_b == of_b) sharpen(known);
    known.is_within = is_near_enough(known.least, known.most);
    tell(1);
  }

 private:
  void ask_vertices(const Bvh& a) {
    const std::span<const Point3> vertices = a.vertices.view();
    constexpr std::uint32_t none = ~std::uint32_t{0};
    corner_of_vertex_.assign(vertices.size(), none);
    for (std::uint32_t i = 0; i < as_.size(); ++i) {
      for (const std::uint32_t v : as_.corners(i)) {
        if (corner_of_vertex_[v] != none) continue;
        corner_of_vertex_[v] = static_cast<std::uint32_t>(corners_.size());
        corners_.push_back({vertices[v], 0, 0, 0});
      }
    }
    constexpr std::size_t part_size = 64;
    const std::size_t parts = blocks_of(corners_.size(), part_size);
    Progress half;
    if (options_.progress) {
      half = [this](double share) {
        tell(share / 2);
        return true;
      };
    }
    for_parts(function_, options_.execution, half, parts, [&](std::size_t part) {
      const std::size_t to = std::min(corners_.size(), (part + 1) * part_size);
      for (std::size_t i = part * part_size; i < to; ++i) corners_[i] = asked(corners_[i].at, 0);
    });
  }

  /// Asks pieces until the one that may reach farthest is near enough; says how far that reaches.
  double bound_of_all(HausdorffDistance& known, bool of_b) {
    for (std::size_t pieces = 0;; ++pieces) {
      if (later_.empty() || !(later_.top().most > known.least)) return known.least;
      Piece piece = later_.top();
      const bool nothing_larger = known.least == std::numeric_limits<double>::max();
      if (pieces == options_.most_pieces || nothing_larger || is_near_enough(known.least, piece.most))
        return piece.most;
      if (pieces % 256 == 255)
        tell(0.5 + 0.5 * static_cast<double>(pieces) / static_cast<double>(options_.most_pieces));
      later_.pop();
      if (!piece.middle_known) {
        ask_middle(known, piece, of_b);
        push(known, piece);
      } else if (!split(known, piece, of_b)) {
        return piece.most;
      }
    }
  }

  [[nodiscard]] bool is_near_enough(double least, double most) const {
    return space::is_near_enough(options_, extent_, {least, most});
  }

  void tell(double share) const {
    if (!options_.progress || options_.progress(done_before_ + share * (done_after_ - done_before_))) return;
    throw Cancelled(std::string(function_) + ": cancelled by its progress function");
  }

  [[nodiscard]] NearbyCorner asked(const Point3& p, double off) const {
    const ClosestOnMesh near = *closest_on_mesh(b_, p);
    return {p, off, near.triangle, near.distance};
  }

  /// Every point of a is a lower bound.
  static void offer(HausdorffDistance& known, const NearbyCorner& corner, std::uint32_t from, bool of_b) {
    const double least = difference_below(step_below(corner.distance), corner.off);
    if (!(least > known.least)) return;
    known.least = least;
    known.of_b = of_b, known.point = corner.at, known.from = from, known.to = corner.nearest;
  }

  /// No less than the distance of the exact point from this triangle of b.
  [[nodiscard]] double distance_above(const NearbyCorner& corner, std::uint32_t triangle, const Triangle3& t) const {
    const double d = triangle == corner.nearest ? corner.distance : plumb::distance(corner.at, t);
    return sum_above(d == 0 && contains(t, corner.at) ? 0 : step_above(d), corner.off);
  }

  void bound_by(Piece& piece, std::uint32_t triangle) const {
    const Triangle3 t = bs_[triangle];
    double most = 0;
    for (const std::uint32_t c : piece.corners) {
      most = std::max(most, distance_above(corners_[c], triangle, t));
      if (!(most < piece.most)) return;
    }
    piece.most = most;
    piece.nearest = triangle;
  }

  void bound_by_corners(Piece& piece) const {
    const auto& [u, v, w] = piece.corners;
    const std::uint32_t first = corners_[u].nearest, second = corners_[v].nearest, third = corners_[w].nearest;
    bound_by(piece, first);
    if (second != first) bound_by(piece, second);
    if (third != first && third != second) bound_by(piece, third);
  }

  void push(const HausdorffDistance& known, const Piece& piece) {
    if (piece.most > known.least) later_.push(piece);
  }

  void ask_middle(HausdorffDistance& known, Piece& piece, bool of_b) const {
    const auto& [u, v, w] = piece.corners;
    const NearbyCorner near = corner_between(corners_[u], corner_between(corners_[v], corners_[w], 0.5), 0.5);
    const NearbyCorner middle = asked(near.at, near.off);
    offer(known, middle, piece.from, of_b);
    bound_by(piece, middle.nearest);
    piece.middle_known = true;
  }

  /// In two; false where doubles do not tell the cut from an end of the edge.
  bool split(HausdorffDistance& known, const Piece& piece, bool of_b) {
    const auto& [first, second, third] = piece.corners;
    const std::array places{corners_[first].at, corners_[second].at, corners_[third].at};
    std::optional<PieceCut> crossing;  // where halves would have to become small, for the bound is far off
    if (piece.crossings < most_crossings && piece.most > 4 * known.least) {
      crossing = border_crossing(places, bs_[piece.nearest]);
    }
    const auto [i, part_of_edge] = crossing ? *crossing : halving(places);
    const std::uint8_t crossings = crossing ? static_cast<std::uint8_t>(piece.crossings + 1) : std::uint8_t{0};
    const std::uint32_t u = piece.corners[i], v = piece.corners[(i + 1) % 3], w = piece.corners[(i + 2) % 3];
    const NearbyCorner near = corner_between(corners_[u], corners_[v], part_of_edge);
    if (near.at == corners_[u].at || near.at == corners_[v].at) return false;
    const auto middle = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back(asked(near.at, near.off));
    offer(known, corners_.back(), piece.from, of_b);
    for (Piece part : {Piece{{u, middle, w}, piece.from, piece.nearest, piece.most, crossings},
                       Piece{{middle, v, w}, piece.from, piece.nearest, piece.most, crossings}}) {
      bound_by(part, piece.nearest);
      bound_by_corners(part);
      push(known, part);
    }
    return true;
  }

  /// The distance of a corner, where rounding has not made it larger, is known to the last bit.
  void sharpen(HausdorffDistance& known) const {
    const Triangle3 from = as_[known.from], to = bs_[known.to];
    const Point3& p = known.point;
    if (p != from.a && p != from.b && p != from.c) return;
    const double d = plumb::distance(p, to);
    if (d > known.least && d < beyond && compare(exact_distance(p, to), d) != Sign::negative) known.least = d;
  }

  const char* function_;
  const Bvh& b_;
  NumberedTriangles as_, bs_;
  const HausdorffOptions& options_;
  double done_before_, done_after_, extent_;
  std::vector<NearbyCorner> corners_;
  std::vector<std::uint32_t> corner_of_vertex_;
  std::priority_queue<Piece, std::vector<Piece>, NotAsFar> later_;
};

void require_hausdorff(const char* function, const Bvh& a, const Bvh& b, const HausdorffOptions& options) {
  const std::string name(function);
  if (a.triangles.empty()) throw InvalidShape(name + ": a is empty; give one triangle at least");
  if (b.triangles.empty()) throw InvalidShape(name + ": b is empty; give one triangle at least");
  const auto require = [&](const char* option, double x) {
    if (x >= 0 && x < beyond) return;
    throw InvalidShape(name + ": options." + option + " is " + std::to_string(x) +
                       "; give a number that is not below 0");
  };
  require("absolute", options.absolute), require("relative", options.relative);
  require("of_size", options.of_size);
}

/// ask(a, b, options) of the meshes as they stand, or of their rounded images.
template <class Ask>
HausdorffDistance ask_standing(const char* function, const BvhView& a, const BvhView& b,
                               const HausdorffOptions& options, const Ask& ask) {
  const AskedPair pair(function, a, b);
  require_hausdorff(function, pair.a.bvh, pair.b.bvh, options);
  return pair.stand() ? ask(pair.a.bvh, pair.b.bvh, options) : of_images(pair.a, pair.b, options, ask);
}

}  // namespace
}  // namespace space

HausdorffDistance hausdorff_from(const BvhView& a, const BvhView& b, const HausdorffOptions& options) {
  return space::ask_standing("hausdorff_from", a, b, options,
                             [](const Bvh& x, const Bvh& y, const HausdorffOptions& o) {
                               HausdorffDistance known{-1, 0, false, false, {}, 0, 0};
                               space::FarthestSearch("hausdorff_from", x, y, o, 0, 1).run(known, false);
                               return known;
                             });
}

HausdorffDistance hausdorff_distance(const BvhView& a, const BvhView& b, const HausdorffOptions& options) {
  return space::ask_standing("hausdorff_distance", a, b, options,
                             [](const Bvh& x, const Bvh& y, const HausdorffOptions& o) {
                               HausdorffDistance known{-1, 0, false, false, {}, 0, 0};
                               space::FarthestSearch("hausdorff_distance", x, y, o, 0, 0.5).run(known, false);
                               space::FarthestSearch("hausdorff_distance", y, x, o, 0.5, 1).run(known, true);
                               return known;
                             });
}

}  // namespace plumb
