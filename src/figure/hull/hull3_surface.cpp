#include "figure/hull/hull3_surface.hpp"

namespace plumb::figure::hull3 {

int Surface::exact_side(Id face, const Point3& p) const {
  const auto& v = faces_[face].vertex;
  const Point3 &a = point(v[0]), &b = point(v[1]), &c = point(v[2]);
  return static_cast<int>(decide<predicates::Orient3d>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z}));
}

Id Surface::make_face(Id a, Id b, Id c) {
  Id id;
  if (free_.empty()) {
    id = static_cast<Id>(faces_.size());
    faces_.emplace_back();
    planes_.emplace_back();
  } else {
    id = free_.back();
    free_.pop_back();
    faces_[id] = Face{};
  }
  faces_[id].vertex = {a, b, c};
  planes_[id] = FacePlane(PlaneSide(point(a), point(b), point(c)), widths_);
  return id;
}

void Surface::widen(const Extents& extents) {
  widths_ = {extents.max.x - extents.min.x, extents.max.y - extents.min.y, extents.max.z - extents.min.z};
  for (Id f = 0; f < faces_.size(); ++f) {
    const auto& v = faces_[f].vertex;
    if (faces_[f].alive()) planes_[f] = FacePlane(PlaneSide(point(v[0]), point(v[1]), point(v[2])), widths_);
  }
}

void Surface::start(const std::array<Id, 4>& simplex) {
  auto [a, b, c, d] = simplex;
  const Point3 &p = point(a), &q = point(b), &r = point(c), &s = point(d);
  const Sign sign = decide<predicates::Orient3d>({p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z, s.x, s.y, s.z});
  if (sign == Sign::negative) std::swap(b, c);  // d below abc
  const std::array<Id, 4> face{make_face(a, b, c), make_face(b, a, d), make_face(c, b, d), make_face(a, c, d)};
  for (Id i = 0; i < 3; ++i) {
    join(3 * face[0] + i, 3 * face[i + 1]);
    join(3 * face[i + 1] + 2, 3 * face[(i + 1) % 3 + 1] + 1);
  }
}

std::span<const Id> Surface::cone(Id apex) {
  made_.clear();
  for (const Id behind : horizon_) {
    const Id face = make_face(end_of(behind), start_of(behind), apex);
    join(3 * face, behind);
    made_.push_back(face);
  }
  for (std::size_t i = 0; i < made_.size(); ++i) {
    join(3 * made_[i] + 1, 3 * made_[i + 1 == made_.size() ? 0 : i + 1] + 2);
  }
  return made_;
}

void Surface::drop_visible() {
  for (const Id face : visible_) {
    faces_[face].vertex[0] = none;
    free_.push_back(face);
  }
}

}  // namespace plumb::figure::hull3
