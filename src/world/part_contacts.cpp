#include "world/part_contacts.hpp"

#include <algorithm>

#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "arith/vec.hpp"
#include "world/grown_box.hpp"

namespace plumb::world {
namespace {

bool may_have_contact(const AnyFigure& figure) { return query::is_body_kind(figure.kind()); }
/// contact() refuses such of these as are not convex.
bool is_polygonal(const AnyFigure& figure) {
  return query::is_one_of(figure.kind(), {FigureKind::polygon, FigureKind::quadrilateral});
}

std::optional<ContactManifold> contact_of_figures(const AnyFigure& a, const AnyFigure& b, double margin) {
  if (!may_have_contact(a) || !may_have_contact(b)) return {};
  if (!is_polygonal(a) && !is_polygonal(b)) return contact(a, b, {.margin = margin});
  try {
    return contact(a, b, {.margin = margin});
  } catch (const InvalidShape&) {  // it is sound, as it is in a world, but not convex
    return {};
  }
}

/// Has it an inside, for certain?  Of such bodies contact() tells the relation that relate() does: those that need not
/// move to be parted have no inner point in common.
bool has_inside(const AnyFigure& figure) {
  if (const auto* ball = get_if<Sphere3>(figure)) return ball->radius > 0;
  if (const auto* capsule = get_if<Capsule3>(figure)) return capsule->radius > 0;
  if (const auto* box = get_if<Aabb3>(figure)) {
    return box->min.x < box->max.x && box->min.y < box->max.y && box->min.z < box->max.z;
  }
  const auto* box = get_if<Obb3>(figure);
  if (box == nullptr || !(box->half.x > 0 && box->half.y > 0 && box->half.z > 0)) return false;
  const auto axis = [&](std::size_t k) { return arith::vec<Running>(box->axes[k]); };
  return certain_sign(dot(cross(axis(0), axis(1)), axis(2))) != 0;
}

/// Each figure of a part that is near to a box: itself, or its triangles there.
template <class Work>
void for_figures(const Placed& part, const Aabb3& near, const Work& work) {
  if (const auto* figure = std::get_if<AnyFigure>(&part)) return work(*figure, 0);
  const PlacedMesh& mesh = std::get<PlacedMesh>(part);
  for (const std::uint32_t t : mesh.near(near)) work(mesh.triangle(t), t);
}

}  // namespace

std::optional<Relation> add_contacts(const WorldPair& pair, const WorldBody& a, const WorldBody& b,
                                     std::vector<WorldContact>& to) {
  const double margin = a.options.margin + b.options.margin;
  const auto tell = [&](const BodyPart& of_a, const BodyPart& of_b, std::optional<ContactManifold> m) {
    if (m) to.push_back({pair.id_a, pair.id_b, pair.a, pair.b, of_a, of_b, *std::move(m)});
  };
  if (a.placed.size() == 1 && b.placed.size() == 1) {
    const auto *p = std::get_if<AnyFigure>(&a.placed[0]), *q = std::get_if<AnyFigure>(&b.placed[0]);
    if (p != nullptr && q != nullptr) {
      auto m = contact_of_figures(*p, *q, margin);
      const Relation relation = m ? m->relation : Relation::disjoint;
      tell({}, {}, std::move(m));
      return has_inside(*p) && has_inside(*q) ? std::optional(relation) : std::nullopt;
    }
  }
  const auto first = static_cast<std::ptrdiff_t>(to.size());
  for (std::uint32_t i = 0; i < a.placed.size(); ++i) {
    for (std::uint32_t j = 0; j < b.placed.size(); ++j) {
      const Aabb3 near_b = grown(box_of(b.placed[j]), margin);
      for_figures(a.placed[i], near_b, [&](const AnyFigure& p, std::uint32_t of_a) {
        for_figures(b.placed[j], grown(box_of(p), margin), [&](const AnyFigure& q, std::uint32_t of_b) {
          tell({i, of_a}, {j, of_b}, contact_of_figures(p, q, margin));
        });
      });
    }
  }
  std::sort(to.begin() + first, to.end(), [](const WorldContact& x, const WorldContact& y) {
    return std::tie(x.part_a, x.part_b) < std::tie(y.part_a, y.part_b);
  });
  return {};
}

}  // namespace plumb::world
