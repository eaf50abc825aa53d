// Do the figures of a case meet, by linear programs in rationals?  What the tests of kinds share.
//
// Laws: exact for all finite doubles; nothing is shared with the library but its shapes.
// Cost: that of query/overlap/rational_relation.hpp.
#pragma once

#include "plumb/degenerate/kind.hpp"
#include "query/kinds/foreign_functions.hpp"
#include "query/overlap/rational_relation.hpp"

namespace plumb::kind_judges {

namespace foreign = plumb_test::foreign;
using degenerate::Kind;
using oracle::RationalPoint, oracle::Spanned;
using Given = std::span<const double>;

inline RationalPoint at(Given q, std::size_t i) { return {mpq_class(q[i]), mpq_class(q[i + 1]), mpq_class(q[i + 2])}; }

inline Spanned spanned(Given q, std::size_t first, std::size_t points) {
  Spanned all;
  for (std::size_t i = 0; i < points; ++i) all.points.push_back(at(q, first + 3 * i));
  return all;
}

inline Spanned flat_segment(Given q, std::size_t first) {
  const auto corner = [&](std::size_t i) { return RationalPoint{mpq_class(q[i]), mpq_class(q[i + 1]), 0}; };
  return {{corner(first), corner(first + 2)}, {}};
}

inline bool meet_by_program(const Kind& kind, Given q, bool inside = false) {
  const auto meet = [inside](const Spanned& a, const Spanned& b) {
    const Relation relation = oracle::relation(a, b);
    return inside ? relation == Relation::overlapping : relation != Relation::disjoint;
  };
  if (kind.name == "segment-segment") return meet(flat_segment(q, 0), flat_segment(q, 4));
  if (kind.name == "segment-segment-3d") return meet(spanned(q, 0, 2), spanned(q, 6, 2));
  if (kind.name == "triangle-triangle") return meet(spanned(q, 0, 3), spanned(q, 9, 3));
  if (kind.name == "box-box") {
    const auto box = [&](std::size_t i) {
      return oracle::spanned(Aabb3{{q[i], q[i + 1], q[i + 2]}, {q[i + 3], q[i + 4], q[i + 5]}});
    };
    return meet(box(0), box(6));
  }
  return meet(oracle::spanned(foreign::oriented_box(q.data())), oracle::spanned(foreign::oriented_box(&q[15])));
}

}  // namespace plumb::kind_judges
