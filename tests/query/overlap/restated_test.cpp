// Slabs and boxes by width or center against every kind: as generated sets in rationals, as the figures that say the same,
// and where an end is no double.
#include "plumb/query/overlap/restated.hpp"

#include <gmock/gmock.h>

#include "plumb/figure/containment/contains.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_oracle.hpp"
#include "query/convex/flat_set.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::pair_cases {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct RestatedSeen {
  Answers answers;
  int inexact = 0, held = 0, asked = 0;
};

/// Ends of a set along a normal, so that slabs touch it.
template <class Vector, class Shape>
double some_end(Material& m, const Vector& n, const Shape& s) {
  if constexpr (query::FlatFigure<Shape>) {
    if (const query::FlatSet set = query::flat_set(query::view_of(s)); !set.points.empty() && m.below(2) == 0) {
      const auto c = coordinates(n);
      mpq_class at = 0;
      const auto& p = set.points[m.below(set.points.size())];
      for (std::size_t k = 0; k < c.size(); ++k) at += mpq_class(c[k]) * p[k];
      if (std::isfinite(at.get_d())) return at.get_d();
    }
  }
  return m.number();
}

template <class Slab, class Shape>
void expect_slab(RestatedSeen& seen, std::uint64_t start) {
  shape_cases::on_shapes(start, battery::sanitized ? 4 : 16, [&](Material& m) {
    const Shape s = figure<Shape>(m);
    Slab slab{m.shape<Slab>().normal, 0, 0};
    slab.min = some_end(m, slab.normal, s);
    slab.max = m.below(4) == 0 ? slab.min : some_end(m, slab.normal, s);
    if (slab.min > slab.max && m.below(4) != 0) std::swap(slab.min, slab.max);
    const query::SaidType<Slab> region{{query::lower_side(slab), query::upper_side(slab)}};
    const std::string about = std::string(name_of(figure_kind<Shape>)) + m.about(slab, s);
    Relation told{};
    try {
      told = relate(slab, s);
    } catch (const InvalidShape&) {
      return;
    }
    seen.answers.add(told);
    EXPECT_EQ(relate(s, slab), told) << about;
    EXPECT_EQ(intersects(slab, s), told != Relation::disjoint) << about;
    if constexpr (query::FlatFigure<Shape>) {
      EXPECT_EQ(told, oracle::relation(oracle::cells(region), oracle::cells(s))) << about;
    } else if constexpr (RelatedPair<query::SaidType<Slab>, Shape>) {
      EXPECT_EQ(told, relate(region, s)) << about;
    } else {  // a cylinder or cone: from where it is in the slab's way
      const Relation up = relate(query::upper_side(slab), s), down = relate(query::lower_side(slab), s);
      EXPECT_EQ(told != Relation::disjoint,
                slab.min <= slab.max && up != Relation::disjoint && down != Relation::disjoint)
          << about;
    }
    if constexpr (query::HoldsRestated<Slab, Shape>) {
      const bool held = contains(slab, s);
      ++seen.asked, seen.held += held ? 1 : 0;
      EXPECT_EQ(held, contains(query::lower_side(slab), s) && contains(query::upper_side(slab), s)) << about;
    }
    if constexpr (query::HoldsRestated<Shape, Slab>) {
      try {
        EXPECT_EQ(contains(s, slab), contains(s, region)) << about;
      } catch (const InvalidShape&) {  // an outer polygon that is not convex
      }
    }
  });
}

template <class Slab, class All>
RestatedSeen expect_slabs(std::uint64_t start) {
  RestatedSeen seen;
  const auto on_all = [&]<class... S>(Types<S...>) { (expect_slab<Slab, S>(seen, start++), ...); };
  on_all(All{});
  std::printf("%d slabs: %d touch, %d overlap; %d of %d hold\n", seen.answers.all(),
              seen.answers.of(Relation::touching), seen.answers.of(Relation::overlapping), seen.held, seen.asked);
  EXPECT_GT(seen.answers.of(Relation::touching) * 12, seen.answers.all());
  EXPECT_GT(seen.answers.of(Relation::disjoint) * 12, seen.answers.all());
  EXPECT_GT(seen.held * 40, seen.asked);
  return seen;
}

TEST(RestatedPairs, SlabsOfSpace) { expect_slabs<Slab3, Space>(5201); }
TEST(RestatedPairs, SlabsOfThePlane) { expect_slabs<Slab2, Plane>(5301); }

/// The corners of a box by its widths or by its center, in rationals.
template <class Box>
query::FlatSet corners_of_box(const Box& box) {
  const auto exact = [](const auto& v) { return query::Exact3{v.x, v.y, v.z}; };
  query::FlatSet set;
  for (unsigned corner = 0; corner < 8; ++corner) {
    query::Exact3 p;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool upper = (corner >> k & 1) != 0;
      if constexpr (requires { box.center; }) {
        const mpq_class half = abs(exact(box.half)[k]);
        p[k] = exact(box.center)[k] + (upper ? half : mpq_class(-half));
      } else {
        p[k] = exact(box.min)[k] + (upper ? mpq_class(abs(exact(box.widths)[k])) : mpq_class(0));
      }
    }
    set.points.push_back(p);
  }
  return set;
}

template <class Box, class Shape>
void expect_box(RestatedSeen& seen, std::uint64_t start) {
  shape_cases::on_shapes(start, battery::sanitized ? 4 : 12, [&](Material& m) {
    const Box box = m.shape<Box>();
    const Shape s = near_figure<Shape>(m);
    const std::string about = std::string(name_of(figure_kind<Shape>)) + m.about(box, s);
    const auto held = query::box_in_doubles("test", box);
    seen.inexact += held ? 0 : 1;
    const Relation told = relate(box, s);
    seen.answers.add(told);
    EXPECT_EQ(relate(s, box), told) << about;
    EXPECT_EQ(intersects(s, box), told != Relation::disjoint) << about;
    // Independent of doubles: the box as what generates it.
    const query::FlatSet set = corners_of_box(box);
    if constexpr (query::FlatFigure<Shape>) {
      if (!query::is_polygon(query::view_of(s))) {
        EXPECT_EQ(told, query::relate(set, query::flat_set(query::view_of(s)))) << about;
      }
    }
    if (held) {
      EXPECT_EQ(told, relate(*held, s)) << about;
    }
    if constexpr (query::HoldsRestated<Box, Shape>) {
      const bool holds = contains(box, s);
      ++seen.asked, seen.held += holds ? 1 : 0;
      if (held) {
        EXPECT_EQ(holds, contains(*held, s)) << about;
      }
    }
  });
}

template <class Box>
void expect_boxes(std::uint64_t start) {
  RestatedSeen seen;
  const auto on_all = [&]<class... S>(Types<S...>) {
    const auto one = [&]<class Shape>(const Shape*) {
      if constexpr (query::RelatesRestated<Box, Shape>) expect_box<Box, Shape>(seen, start);
      ++start;
    };
    (one(static_cast<const S*>(nullptr)), ...);
  };
  on_all(Space{});
  std::printf("%d boxes, %d without ends in doubles: %d touch, %d overlap; %d of %d hold\n", seen.answers.all(),
              seen.inexact, seen.answers.of(Relation::touching), seen.answers.of(Relation::overlapping), seen.held,
              seen.asked);
  EXPECT_GT(seen.inexact * 80, seen.answers.all());
  EXPECT_GT(seen.answers.of(Relation::disjoint) * 20, seen.answers.all());
  EXPECT_GT(seen.answers.of(Relation::overlapping) * 20, seen.answers.all());
}

TEST(RestatedPairs, BoxesByWidth) { expect_boxes<AabbWidths3>(5401); }
TEST(RestatedPairs, BoxesByCenter) { expect_boxes<AabbCenter3>(5501); }

TEST(RestatedPairs, NoEndIsRounded) {
  // 1 + 2^-60 is no double: what begins at 1 overlaps, though the rounded box only touches it.
  const AabbWidths3 wide{{0, 0, 0}, {1, 1, 1}}, wider{{1, 0, 0}, {0x1p-60, 1, 1}};
  EXPECT_EQ(relate(wide, wider), Relation::touching);
  const Aabb3 from_one{{1, 0, 0}, {2, 1, 1}};
  EXPECT_EQ(relate(wider, from_one), Relation::overlapping);
  EXPECT_EQ(relate(AabbCenter3{{1, 0, 0}, {0x1p-60, 1, 1}}, from_one), Relation::overlapping);
  EXPECT_EQ(relate(wider, AabbCenter3{{1, 0, 0}, {0x1p-60, 1, 1}}), Relation::overlapping);
  EXPECT_TRUE(contains(AabbCenter3{{1, 0.5, 0.5}, {0x1p-60, 0.5, 0.5}}, wider));
  EXPECT_FALSE(contains(wider, AabbCenter3{{1, 0.5, 0.5}, {0x1p-60, 0.5, 0.5}}));
  EXPECT_EQ(relate(Slab3{{1, 0, 0}, 0, 1}, wider), Relation::touching);
  EXPECT_EQ(relate(AabbCenter3{{-1, 0, 0}, {1 + 0x1p-60, 1, 1}}, Point3{0, 0, 0}), Relation::touching);
  EXPECT_EQ(relate(AabbWidths3{{1, 0, 0}, {-0x1p-60, 0, 0}}, from_one), Relation::touching);  // of widths the magnitude
  EXPECT_EQ(relate(wider, wider), Relation::overlapping);
}

TEST(RestatedPairs, SlabsThatAreNone) {
  const Sphere3 ball{{0, 0, 0}, 1};
  EXPECT_EQ(relate(Slab3{{0, 0, 1}, 1, 0}, ball), Relation::disjoint);
  EXPECT_EQ(relate(Slab3{{0, 0, 0}, -1, 1}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Slab3{{0, 0, 0}, 1, 2}, ball), Relation::disjoint);
  EXPECT_EQ(relate(Slab3{{0, 0, 2}, 2, 2}, ball), Relation::touching);
  EXPECT_EQ(relate(Slab3{{0, 0, 1}, 1, 1}, Cylinder3{{0, 0, 0}, {0, 0, 1}, 1}), Relation::touching);
  EXPECT_EQ(relate(Slab3{{0, 0, 1}, 0, 1}, Slab3{{0, 0, -2}, -4, -2}), Relation::touching);
  EXPECT_TRUE(contains(Slab3{{0, 0, 1}, -1, 1}, Slab3{{0, 0, -2}, -2, 1}));
  // Two squares that meet at a corner within the slab: its inside meets neither.
  const Polygon2 bow{{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}};
  EXPECT_EQ(relate(Slab2{{1, 0}, 0.5, 1.5}, bow), Relation::overlapping);
  EXPECT_THAT(
      [&] {
        (void)relate(Slab3{{0, 0, 1}, std::nan(""), 1}, ball);
      },
      ThrowsMessage<NonFinite>(HasSubstr("relate: slab.min is nan")));
  EXPECT_THAT(
      [&] {
        (void)intersects(AabbWidths3{{0, 0, 0}, {1, INFINITY, 1}}, ball);
      },
      ThrowsMessage<NonFinite>(HasSubstr("intersects: box.widths.y is inf")));
}

}  // namespace
}  // namespace plumb::pair_cases
