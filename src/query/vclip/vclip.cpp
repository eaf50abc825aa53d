#include "plumb/query/vclip/vclip.hpp"

#include <string>

#include "arith/big_rounding.hpp"
#include "arith/exact_number.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error.hpp"
#include "query/body/vectors.hpp"
#include "query/separation/corner_numbers.hpp"
#include "query/separation/proved_corners.hpp"
#include "query/vclip/clip_input.hpp"
#include "query/vclip/guessed_start.hpp"
#include "query/vclip/nearest_features.hpp"

namespace plumb::query {
namespace vclipping {
namespace {

/// Does the walk come back?  Its last state is compared with one of before, ever farther back: Brent's cycle finding.
class CycleFinder {
 public:
  explicit CycleFinder(const MeshFeaturePair& start) : kept_(start) {}
  bool comes_back(const MeshFeaturePair& now) {
    if (now == kept_) return true;
    if (++since_ == keep_at_) kept_ = now, since_ = 0, keep_at_ *= 2;
    return false;
  }

 private:
  MeshFeaturePair kept_;
  std::size_t since_ = 0, keep_at_ = 1;
};

Feature feature_of(const Solid& s, const MeshFeature& f) {
  if (f.kind == FeatureKind::vertex) return {f.kind, s.vertex(f.corner)};
  if (f.kind == FeatureKind::edge) return {f.kind, std::min(f.corner, s.twin(f.corner))};
  return {f.kind, s.face_of(f.corner)};
}

/// The feature that has the corners alone, by one of those of the feature that the walk ended at.
MeshFeature needed_part(const Solid& s, const MeshFeature& f, const DifferenceCorners& corners, std::size_t which) {
  const NamedCorners all = named(corners, which);
  if (f.kind == FeatureKind::vertex || all.size == 3 || (f.kind == FeatureKind::edge && all.size == 2)) return f;
  const std::uint32_t face = s.face_of(f.corner);
  const auto is_named = [&](std::uint32_t c) { return std::ranges::find(all.all(), s.vertex(c)) != all.all().end(); };
  for (std::uint32_t c = s.mesh().first[face]; c < s.mesh().first[face + 1]; ++c) {
    if (all.size == 1 && is_named(c)) return {FeatureKind::vertex, c};
    if (all.size == 2 && is_named(c) && is_named(s.next(c, face))) return {FeatureKind::edge, c};
  }
  return f;  // two corners of a face across it
}

/// A point over a weight.
template <class T>
struct WeightedPoint {
  Vec<T> at;
  T whole;
};

/// Pairs of doubles answer where they leave one double, integers otherwise.
template <class Make>
Point3 rounded_once(const CoreCorners& core, const Make& make) {
  const WeightedPoint<Ball> near = make.template operator()<Ball>();
  const auto part = [&](const Ball& x) { return quotient(x, near.whole).nearest(); };
  if (const auto x = part(near.at.x), y = part(near.at.y), z = part(near.at.z); x && y && z)
    return told(Point3{*x, *y, *z});
  const WeightedPoint<BigDyadic> p = make.template operator()<BigDyadic>();
  const BigDyadic whole = p.whole * core.scale<BigDyadic>();
  const auto rounded = [&](const BigDyadic& x) { return rounded_quotient(Rounding::nearest, x, whole); };
  return told(Point3{rounded(p.at.x), rounded(p.at.y), rounded(p.at.z)});
}

Point3 rounded_vertex(const Solid& s, std::uint32_t corner) {
  return rounded_once(s.core(), [&]<class T>() { return WeightedPoint<T>{s.place<T>(corner), T(1.0)}; });
}

/// Where the edge crosses the plane of the face; of one that runs within it where it comes in above the face.
Point3 crossing(const Solid& of_edge, std::uint32_t edge, const Solid& of_face, std::uint32_t face,
                const std::optional<VoronoiPlane>& entry) {
  const std::uint32_t head = of_edge.next(edge);
  const bool within =
      proved_sign([&]<class T>() {
        return of_face.height(face, of_edge.place<T>(edge)) - of_face.height(face, of_edge.place<T>(head));
      }) == Sign::zero;
  if (within && !entry) return rounded_vertex(of_edge, edge);
  return rounded_once(of_edge.core(), [&]<class T>() {
    const auto value = [&](const Vec<T>& y) { return within ? entry->value(of_face, y) : of_face.height(face, y); };
    const Vec<T> from = of_edge.place<T>(edge), to = of_edge.place<T>(head);
    const T p = value(from), q = value(to);
    return WeightedPoint<T>{to * p - from * q, p - q};
  });
}

void require_start(std::string_view name, const ClipView& v, const MeshFeature& start) {
  require_faces("vclip", name, v);
  const auto& corners = v.polyhedron->mesh.corners;
  if (start.corner < corners.size() && start.kind != FeatureKind::interior) return;
  throw InvalidShape(std::string("vclip: start.")
                         .append(name)
                         .append(" is corner ")
                         .append(std::to_string(start.corner))
                         .append(" of the mesh; give a vertex, an edge or a face by one of its ")
                         .append(std::to_string(corners.size())));
}

/// By the exact search, of any two.
VClipResult by_search(const ClipView& a, const ClipView& b, VClipResult r) {
  r.by_search = true;
  if (a.pose.stands() && b.pose.stands()) {
    r.closest = closest_points_of(view_of(*a.polyhedron), view_of(*b.polyhedron));
  } else {
    r.closest = posed_closest_points({view_of(*a.polyhedron), a.pose}, {view_of(*b.polyhedron), b.pose});
  }
  r.squared_distance = exact_square(a, b);
  r.meet = r.squared_distance->sign() == Sign::zero;
  return r;
}

}  // namespace

}  // namespace vclipping

VClipResult vclip_of(const ClipView& a, const ClipView& b, const VClipOptions& options) {
  using namespace vclipping;
  const MeshFeaturePair given = options.start.value_or(MeshFeaturePair{});
  require_start("a", a, given.a), require_start("b", b, given.b);
  CheckedSigns sign("vclip", a, b);
  const Sign turn_a = turn_of(a), turn_b = turn_of(b);
  auto core_a = CoreCorners::of(vclipping::body_view(a)), core_b = CoreCorners::of(vclipping::body_view(b));
  bring_to_one_weight(*core_a, *core_b);
  VClipResult r;
  r.at = given;
  if (turn_a == Sign::zero || turn_b == Sign::zero) {
    bodies_of("vclip", vclipping::body_view(a), vclipping::body_view(b));
    return by_search(a, b, r);
  }
  const Solid solid_a(*a.polyhedron, *core_a, turn_a == Sign::negative),
      solid_b(*b.polyhedron, *core_b, turn_b == Sign::negative);
  const MeshFeaturePair start = options.start ? given : guessed_start(solid_a, solid_b);
  Walk walk(solid_a, solid_b, start, sign);
  CycleFinder cycle(start);
  Outcome outcome = Outcome::moved;
  while (true) {
    if (options.history != nullptr) options.history->push_back(walk.pair());
    outcome = walk.step();
    r.at = walk.pair();
    if (outcome != Outcome::moved) break;
    ++r.steps;
    if (cycle.comes_back(r.at)) return by_search(a, b, r);
  }
  r.closest.feature_a = feature_of(solid_a, r.at.a), r.closest.feature_b = feature_of(solid_b, r.at.b);
  if (outcome == Outcome::nearest) {
    r.at = without_bounded_faces(solid_a, solid_b, r.at, sign);
    const auto corners = corners_of_features(solid_a, solid_b, r.at, sign);
    const FeaturesProved proved = corners ? prove_features(solid_a, solid_b, r.at, *corners) : FeaturesProved{};
    if (!proved.holds) return by_search(a, b, r);
    r.meet = proved.meet;
    const ClosestCorners n = numbers_of(*core_a, *core_b, *corners);
    r.closest = {n.on_a, n.on_b, n.distance, feature_of(solid_a, needed_part(solid_a, r.at.a, *corners, 0)),
                 feature_of(solid_b, needed_part(solid_b, r.at.b, *corners, 1))};
    if (options.squared_distance) r.squared_distance = exact_number(square_of(*core_a, *core_b, *corners));
    return r;
  }
  r.meet = true;
  if (outcome == Outcome::holds_vertex) {
    r.closest.on_a = r.at.a.kind == FeatureKind::vertex ? rounded_vertex(solid_a, r.at.a.corner)
                                                        : rounded_vertex(solid_b, r.at.b.corner);
  } else {
    r.closest.on_a = r.at.a.kind == FeatureKind::edge
                         ? crossing(solid_a, r.at.a.corner, solid_b, solid_b.face_of(r.at.b.corner), walk.entry())
                         : crossing(solid_b, r.at.b.corner, solid_a, solid_a.face_of(r.at.a.corner), walk.entry());
  }
  r.closest.on_b = r.closest.on_a;
  if (options.squared_distance) r.squared_distance = Rational(0.0);
  return r;
}

}  // namespace plumb::query
