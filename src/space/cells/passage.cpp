#include "plumb/space/cells/passage.hpp"

#include <algorithm>
#include <string>

#include "arith/vec.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "space/cells/three_points.hpp"

namespace plumb {
namespace {

using arith::Vec, arith::cross, arith::dot, arith::vec;
using Exact = Vec<Rational>;

struct ExactWay {
  Exact from, along;
};

/// What of the way is somewhere, as parameters.
struct Part {
  Rational from, to;

  [[nodiscard]] bool is_empty() const { return from > to; }
  /// Leaves where above + t climb <= 0.
  void cut(const Rational& above, const Rational& climb) {
    if (climb.sign() == Sign::zero) {
      if (above.sign() == Sign::positive) from = Rational(1), to = Rational(0);
      return;
    }
    const Rational t = -above / climb;
    if (climb.sign() == Sign::positive) {
      if (t < to) to = t;
    } else {
      if (t > from) from = t;
    }
  }
};

Exact normal_of(const space::ThreePoints& plane) {
  const Exact a = vec<Rational>(plane[0]);
  return cross(vec<Rational>(plane[1]) - a, vec<Rational>(plane[2]) - a);
}

Part part_in(const ConvexPolyhedron3& cell, const ExactWay& way) {
  Part part{Rational(0), Rational(1)};
  for (std::size_t f = 0; f + 1 < cell.mesh.first.size(); ++f) {
    const auto corner = [&](std::size_t k) { return cell.mesh.vertices[cell.mesh.corners[cell.mesh.first[f] + k]]; };
    const auto plane = space::plane_of_chain(cell.mesh.first[f + 1] - cell.mesh.first[f], corner);
    const Exact outward = normal_of(plane);
    part.cut(dot(outward, way.from - vec<Rational>(plane[0])), dot(outward, way.along));
  }
  return part;
}

Part part_on(const Polygon3& polygon, const ExactWay& way) {
  Part part{Rational(0), Rational(1)};
  const auto& v = polygon.vertices;
  const auto plane = space::plane_of_chain(v.size(), [&](std::size_t k) { return v[k]; });
  const Exact normal = normal_of(plane);
  const Rational above = dot(normal, way.from - vec<Rational>(plane[0])), climb = dot(normal, way.along);
  part.cut(above, climb);
  part.cut(-above, -climb);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Exact from = vec<Rational>(v[i]), outward = cross(vec<Rational>(v[(i + 1) % v.size()]) - from, normal);
    part.cut(dot(outward, way.from - from), dot(outward, way.along));
  }
  return part;
}

/// A cell, and how it was come to.
struct Reached {
  std::uint32_t cell, before, portal;
  Rational since, until;  // from its first place on that can be come to
};

/// The chains of more and more portals, those of each number that come to a cell sooner than any of fewer.
class Chains {
 public:
  Chains(const PortalCells& rooms, const ExactWay& way, std::uint32_t cell) : rooms_(rooms), way_(way) {
    reached_.push_back({cell, 0, 0, Rational(0), part_in(rooms.cells()[cell], way).to});
  }

  /// The first that arrives, or else the one that comes farthest.
  std::uint32_t last() {
    std::uint32_t farthest = 0;
    for (std::uint32_t from = 0, to = 1; from < to; from = to, to = static_cast<std::uint32_t>(reached_.size())) {
      for (std::uint32_t i = from; i < to; ++i) {
        if (reached_[i].until > reached_[farthest].until) farthest = i;
      }
      if (reached_[farthest].until == Rational(1)) return farthest;
      for (std::uint32_t i = from; i < to; ++i) go_on(i, to);
    }
    return farthest;
  }
  [[nodiscard]] const Reached& at(std::uint32_t i) const { return reached_[i]; }

 private:
  void go_on(std::uint32_t i, std::uint32_t layer) {
    const std::uint32_t here = reached_[i].cell;
    for (const std::uint32_t portal : rooms_.portals_of(here)) {
      Part through = part_on(rooms_.portals()[portal].polygon, way_);
      if (reached_[i].since > through.from) through.from = reached_[i].since;
      if (reached_[i].until < through.to) through.to = reached_[i].until;
      if (through.is_empty()) continue;
      add({rooms_.beyond(portal, here), i, portal, through.from, Rational(0)}, layer);
    }
  }
  void add(Reached r, std::uint32_t layer) {
    for (std::uint32_t k = 0; k < reached_.size(); ++k) {
      if (reached_[k].cell != r.cell) continue;
      if (reached_[k].since <= r.since) return;
      r.until = reached_[k].until;
      if (k < layer) continue;
      reached_[k] = std::move(r);
      return;
    }
    r.until = part_in(rooms_.cells()[r.cell], way_).to;
    reached_.push_back(std::move(r));
  }

  const PortalCells& rooms_;
  const ExactWay& way_;
  std::vector<Reached> reached_;
};

}  // namespace

Passage passage(const PortalCells& rooms, std::uint32_t cell, const Segment3& segment) {
  rooms.require_cell("passage", cell);
  figure::require_finite_parts<Point3, Point3>("passage", {"segment.a", "segment.b"}, segment.a, segment.b);
  if (!contains(rooms.cells()[cell], segment.a)) {
    throw InvalidShape("passage: the segment begins outside cell " + std::to_string(cell));
  }
  Passage p{{}, cell, true, Rational(1)};
  if (contains(rooms.cells()[cell], segment.b)) return p;
  const Exact from = vec<Rational>(segment.a);
  const ExactWay way{from, vec<Rational>(segment.b) - from};
  Chains chains(rooms, way, cell);
  std::uint32_t last = chains.last();
  p.cell = chains.at(last).cell;
  p.until = chains.at(last).until;
  p.arrives = p.until == Rational(1);
  for (; last != 0; last = chains.at(last).before) p.portals.push_back(chains.at(last).portal);
  std::reverse(p.portals.begin(), p.portals.end());
  return p;
}

void PortalObjects::require_held(std::string_view function, std::uint32_t handle) const {
  if (handle < objects_.size() && objects_[handle].cell != no_cell) return;
  throw Error("PortalObjects::" + std::string(function) + ": handle " + std::to_string(handle) +
              " holds no object; it was removed, or never given");
}

std::uint32_t PortalObjects::insert(const Point3& place) {
  const std::vector<std::uint32_t> cells = rooms_->cells_holding(place);
  if (cells.empty()) throw InvalidShape("PortalObjects::insert: the place is in no cell");
  std::uint32_t handle = 0;
  if (free_.empty()) {
    handle = static_cast<std::uint32_t>(objects_.size());
    objects_.push_back({place, cells[0]});
  } else {
    handle = free_.back();
    free_.pop_back();
    objects_[handle] = {place, cells[0]};
  }
  objects_in_[cells[0]].push_back(handle);
  return handle;
}

void PortalObjects::remove(std::uint32_t handle) {
  require_held("remove", handle);
  std::erase(objects_in_[objects_[handle].cell], handle);
  objects_[handle].cell = no_cell;
  free_.push_back(handle);
}

Passage PortalObjects::move(std::uint32_t handle, const Point3& to) {
  require_held("move", handle);
  Object& object = objects_[handle];
  Passage p = passage(*rooms_, object.cell, {object.place, to});
  if (!p.arrives) return p;
  if (p.cell != object.cell) {
    std::erase(objects_in_[object.cell], handle);
    objects_in_[p.cell].push_back(handle);
  }
  object = {to, p.cell};
  return p;
}

std::uint32_t PortalObjects::cell_of(std::uint32_t handle) const {
  require_held("cell_of", handle);
  return objects_[handle].cell;
}
const Point3& PortalObjects::place_of(std::uint32_t handle) const {
  require_held("place_of", handle);
  return objects_[handle].place;
}
std::span<const std::uint32_t> PortalObjects::objects_in(std::uint32_t cell) const {
  rooms_->require_cell("PortalObjects::objects_in", cell);
  return objects_in_[cell];
}

}  // namespace plumb
