// Does each form of a box hold the others, as tightly as doubles can?
#include "plumb/figure/aabb/box_forms.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "figure/basic/shape_cases.hpp"
#include "figure/containment/exact_locations.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

using exact::Rational;
using shape_cases::Material, shape_cases::on_shapes;

struct Ends {
  std::array<Rational, 3> min, max;
};
Ends ends(const exact::Coordinates& min, const exact::Coordinates& max) {
  return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}};
}
Ends ends(const Aabb3& b) { return ends(exact::of(b.min), exact::of(b.max)); }
Ends ends(const AabbWidths3& b) {
  return ends(exact::of(b.min), exact::combination(exact::of(b.min), 1, exact::magnitudes(exact::of(b.widths))));
}
Ends ends(const AabbCenter3& b) {
  const auto half = exact::magnitudes(exact::of(b.half));
  return ends(exact::combination(exact::of(b.center), -1, half), exact::combination(exact::of(b.center), 1, half));
}

bool empty(const Ends& e) { return e.min[0] > e.max[0] || e.min[1] > e.max[1] || e.min[2] > e.max[2]; }

double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// The nearest double at most x, at least x.
bool is_lower(double d, const Rational& x) {
  const double next = std::nextafter(d, std::numeric_limits<double>::infinity());
  return d <= x && (std::isinf(next) || !(next <= x));
}
bool is_upper(double d, const Rational& x) { return is_lower(-d, -x); }

struct Count {
  std::uint64_t converted = 0, exact = 0, refused = 0;
};

template <class Box>
void is_tight(const Box& from, const AabbWidths3& to, Count& count, const std::string& place) {
  const Ends e = ends(from), made = ends(to);
  const std::array min{to.min.x, to.min.y, to.min.z}, widths{to.widths.x, to.widths.y, to.widths.z};
  bool same = true;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(is_lower(min[i], e.min[i])) << place;
    EXPECT_TRUE(is_upper(widths[i], e.max[i] - Rational(min[i]))) << place;
    same = same && made.min[i] == e.min[i] && made.max[i] == e.max[i];
  }
  count.exact += same ? 1 : 0;
}
template <class Box>
void is_tight(const Box& from, const Aabb3& to, Count& count, const std::string& place) {
  const Ends e = ends(from);
  const std::array min{to.min.x, to.min.y, to.min.z}, max{to.max.x, to.max.y, to.max.z};
  bool same = true;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(is_lower(min[i], e.min[i])) << place;
    EXPECT_TRUE(is_upper(max[i], e.max[i])) << place;
    same = same && min[i] == e.min[i] && max[i] == e.max[i];
  }
  count.exact += same ? 1 : 0;
}
template <class Box>
void is_tight(const Box& from, const AabbCenter3& to, Count& count, const std::string& place) {
  const Ends e = ends(from), made = ends(to);
  const std::array center{to.center.x, to.center.y, to.center.z}, half{to.half.x, to.half.y, to.half.z};
  bool same = true;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(made.min[i] <= e.min[i] && e.max[i] <= made.max[i]) << place;
    const auto need = [&](double c) {  // the half extent that this center needs
      return std::max(Rational(Rational(c) - e.min[i]), Rational(e.max[i] - Rational(c)));
    };
    EXPECT_TRUE(is_upper(half[i], need(center[i]))) << place;
    if (center[i] != std::numeric_limits<double>::max() && center[i] != -std::numeric_limits<double>::max()) {
      EXPECT_LE(need(center[i]), need(below(center[i]))) << place;
      EXPECT_LE(need(center[i]), need(-below(-center[i]))) << place;
    }
    same = same && made.min[i] == e.min[i] && made.max[i] == e.max[i];
  }
  count.exact += same ? 1 : 0;
}

template <class Box, class Convert>
Count hold(Convert convert) {
  Count count;
  on_shapes(61, 3000, [&](Material& m) {
    const auto box = m.shape<Box>();
    try {
      const auto to = convert(box);
      ++count.converted;
      is_tight(box, to, count, m.about(box, to));
    } catch (const InvalidShape&) {
      EXPECT_TRUE(empty(ends(box))) << m.about(box);
      ++count.refused;
    } catch (const BeyondDoubles&) {
      ++count.refused;
    }
  });
  EXPECT_GT(count.converted, 2000u);
  EXPECT_GT(count.exact, 1000u);
  return count;
}

TEST(BoxForms, HoldTheBoxAndNoMoreThanDoublesForce) {
  const auto widths = [](const auto& b) { return to_aabb_widths(b); };
  const auto center = [](const auto& b) { return to_aabb_center(b); };
  const auto corners = [](const auto& b) { return to_aabb(b); };
  std::uint64_t rounded = 0, refused = 0;
  for (const Count& c : {hold<Aabb3>(widths), hold<Aabb3>(center), hold<AabbWidths3>(corners),
                         hold<AabbWidths3>(center), hold<AabbCenter3>(corners), hold<AabbCenter3>(widths)}) {
    EXPECT_LT(c.exact, c.converted) << "some must be rounded";
    rounded += c.converted - c.exact;
    refused += c.refused;
  }
  EXPECT_GT(rounded, 500u);
  EXPECT_GT(refused, 100u);
}

TEST(BoxForms, KeepTheirOwnForm) {
  on_shapes(62, 1000, [](Material& m) {
    const auto box = m.shape<Aabb3>();
    EXPECT_EQ(to_aabb(box), box);
    const auto magnitudes = [](const Vector3& v) { return Vector3{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; };
    const auto widths = m.shape<AabbWidths3>();
    EXPECT_EQ(to_aabb_widths(widths), (AabbWidths3{widths.min, magnitudes(widths.widths)})) << m.about(widths);
    const auto center = m.shape<AabbCenter3>();
    EXPECT_EQ(to_aabb_center(center), (AabbCenter3{center.center, magnitudes(center.half)})) << m.about(center);
  });
}

TEST(BoxForms, AtTheEndsOfTheDoubles) {
  constexpr double most = std::numeric_limits<double>::max();
  const Aabb3 everything{{-most, -most, -most}, {most, most, most}};
  EXPECT_EQ(to_aabb_center(everything), (AabbCenter3{{0, 0, 0}, {most, most, most}}));
  EXPECT_THROW(to_aabb_widths(everything), BeyondDoubles);
  EXPECT_EQ(to_aabb(to_aabb_center(everything)), everything);
  EXPECT_THROW(to_aabb(AabbWidths3{{most, 0, 0}, {most, 0, 0}}), BeyondDoubles);
  const AabbCenter3 least = to_aabb_center(Aabb3{{0, 0, 0}, {0x1p-1074, 0, 0}});
  EXPECT_EQ(least.half.x, 0x1p-1074) << "half of the least double is rounded up";
  EXPECT_EQ(to_aabb_widths(Aabb3{{1, 0, 0}, {1, 0, 0}}), (AabbWidths3{{1, 0, 0}, {0, 0, 0}}));
}

TEST(BoxForms, RefuseWhatIsNoBoxInThatForm) {
  try {
    to_aabb_center(Aabb3{{0, 2, 0}, {1, 1, 1}});
    ADD_FAILURE() << "nothing is refused";
  } catch (const InvalidShape& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("to_aabb_center: box.min.y is above box.max"));
  }
  EXPECT_THROW(to_aabb_widths(Aabb3{{0, 2, 0}, {1, 1, 1}}), InvalidShape);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(to_aabb(Aabb3{{0, nan, 0}, {1, 1, 1}}), NonFinite);
  EXPECT_THROW(to_aabb(AabbWidths3{{0, 0, 0}, {1, nan, 1}}), NonFinite);
  EXPECT_THROW(to_aabb_widths(AabbCenter3{{0, 0, 0}, {1, nan, 1}}), NonFinite);
  EXPECT_THROW(to_aabb_center(Aabb3{{0, 2, nan}, {1, 1, 1}}), NonFinite);
}

}  // namespace
}  // namespace plumb
