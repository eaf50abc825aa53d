// The directions are guesses in doubles, which hold no bound; that one parts the two is a matter of exact signs.
#include "plumb/query/vclip/separating_vector.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "query/separation/corner_numbers.hpp"
#include "query/separation/proved_corners.hpp"
#include "query/vclip/checked_signs.hpp"

namespace plumb::query {
namespace vclipping {
namespace {

using arith::Plain, arith::Vec;
using VertexPair = std::array<std::uint32_t, 2>;

Plain plain(const Vector3& v) { return {v.x, v.y, v.z}; }

/// A guess: no direction where there is none, or one that overflows.
std::optional<Plain> unit(const Plain& v) {
  const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(most > 0 && std::isfinite(most))) return {};
  const Plain s{v.x / most, v.y / most, v.z / most};
  return s * (1 / std::sqrt(dot(s, s)));
}

void require_vertex(std::string_view name, const ClipView& v, std::uint32_t vertex) {
  require_faces("separating_vector", name, v);
  const std::size_t size = v.polyhedron->mesh.vertices.size();
  if (vertex < size) return;
  throw InvalidShape(std::string("separating_vector: options.vertices has vertex ")
                         .append(std::to_string(vertex))
                         .append(" of ")
                         .append(name)
                         .append(", which has ")
                         .append(std::to_string(size)));
}

class VectorSearch {
 public:
  VectorSearch(const ClipView& a, const ClipView& b, const CoreCorners& core_a, const CoreCorners& core_b,
               const VertexPair& at)
      : views_{a, b},
        solids_{a.polyhedron, b.polyhedron},
        cores_{&core_a, &core_b},
        at_(at),
        sign_("separating_vector", a, b) {}

  SeparatingVector run(const std::optional<Vector3>& start) {
    SeparatingVector r;
    const auto guess = start ? unit(plain(*start)) : unit(between<double>());
    Plain s = guess.value_or(Plain{1, 0, 0});
    std::vector<VertexPair> seen;
    while (true) {
      ++r.steps;
      climb(s);
      r.vertices = at_;
      if (parts(s)) {
        r.disjoint = true;
        r.direction = Vector3{s.x, s.y, s.z};
        return r;
      }
      const auto way = unit(between<double>());
      if (!way || std::ranges::find(seen, at_) != seen.end()) return by_search(r);
      seen.push_back(at_);
      const auto mirrored = unit(s - *way * (2 * dot(s, *way)));
      if (!mirrored) return by_search(r);
      s = *mirrored;
    }
  }

 private:
  /// From the corner of a to that of b.
  template <class T>
  [[nodiscard]] Vec<T> between() const {
    return cores_[1]->at<T>(at_[1]) - cores_[0]->at<T>(at_[0]);
  }
  /// To the farthest corner of a along s, and the least far one of b.
  void climb(const Plain& s) {
    for (const std::size_t i : {0U, 1U}) {
      const Sign wanted = i == 0 ? Sign::positive : Sign::negative;
      for (bool better = true; better;) {  // ends, for each corner is farther than the one before
        better = false;
        for (const std::uint32_t v : solids_[i]->neighbors_of(at_[i])) {
          const Sign along =
              sign_([&]<class T>() { return dot(arith::vec<T>(s), cores_[i]->at<T>(v) - cores_[i]->at<T>(at_[i])); });
          if (along == wanted) at_[i] = v, better = true;
        }
      }
    }
  }
  [[nodiscard]] bool parts(const Plain& s) {
    return sign_([&]<class T>() { return dot(arith::vec<T>(s), between<T>()); }) == Sign::positive;
  }
  SeparatingVector by_search(SeparatingVector r) {
    r.by_search = true;
    sign_.check();
    const auto proved = proved_nearest(*cores_[0], *cores_[1]);
    if (!proved) {
      r.disjoint = exact_square(views_[0], views_[1]).sign() == Sign::positive;
      return r;
    }
    r.disjoint = !proved->meets;
    if (!r.disjoint) return r;
    const ClosestCorners n = numbers_of(*cores_[0], *cores_[1], proved->corners);
    const auto s = unit(Plain{n.on_b.x - n.on_a.x, n.on_b.y - n.on_a.y, n.on_b.z - n.on_a.z});
    if (!s) return r;
    climb(*s);
    r.vertices = at_;
    if (parts(*s)) r.direction = Vector3{s->x, s->y, s->z};
    return r;
  }
  std::array<ClipView, 2> views_;
  std::array<const ConvexPolyhedron3*, 2> solids_;
  std::array<const CoreCorners*, 2> cores_;
  VertexPair at_;
  CheckedSigns sign_;
};

}  // namespace
}  // namespace vclipping

SeparatingVector separating_vector_of(const ClipView& a, const ClipView& b, const SeparatingVectorOptions& options) {
  using namespace vclipping;
  require_vertex("a", a, options.vertices[0]), require_vertex("b", b, options.vertices[1]);
  if (options.direction) require_finite_parts("separating_vector", {"options.direction"}, *options.direction);
  auto core_a = CoreCorners::of(vclipping::body_view(a)), core_b = CoreCorners::of(vclipping::body_view(b));
  bring_to_one_weight(*core_a, *core_b);
  return VectorSearch(a, b, *core_a, *core_b, options.vertices).run(options.direction);
}

}  // namespace plumb::query
