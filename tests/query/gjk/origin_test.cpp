// Statements about the origin: which bounds were derived, and does each world tell what is so?
#include "query/gjk/origin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/body/told_alike.hpp"
#include "query/gjk/nearest_statement.hpp"

namespace plumb::query {
namespace {

using namespace gjk_origin;

template <class Statement, class... Input>
void expect_bounds_of(const char* name, const Statement& statement, const Input&... input) {
  const std::vector<std::string> bounds = judged_bounds(statement, input...);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, statement, input...));
}

TEST(GjkOrigin, DerivedBoundsAreAsRecordedAndProved) {
  const arith::Plain n{1, 2, 0.5};
  const Point3 v{1, 2, 3}, p{0.25, -1, 2};
  expect_bounds_of("gjk_ahead", Ahead{}, n, v, p);
  const std::array<Point3, 2> all{v, {5, 6, 7}};
  const std::array<std::uint32_t, 2> of{0, 1};
  expect_bounds_of("gjk_are_ahead", AreAhead{}, n, all.data(), std::span<const std::uint32_t>(of), p);
  const Point3 o{0, 0, 0};
  const std::array<Point3, 4> at_origin{o, o, o, o};
  expect_bounds_of("gjk_around_origin", IsAroundOrigin{},
                   Pairs{{{{3, 0, -1}, {-2, 2, -1}, {-2, -2, -1}, {0, 0, 5}}}, at_origin});
}

TEST(GjkNearest, DerivedBoundsAreAsRecordedAndProved) {
  // Of a triangle above the origin, and of the origin itself with one point beneath it.
  const std::array<Point3, 4> above{{{2, 0, 1}, {-1, 2, 1}, {-1, -2, 1}, {0, 0, 3}}};
  const std::array<Point3, 4> beneath{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, -1}}};
  const std::array<std::uint32_t, 3> three{0, 1, 2}, one{0, 0, 0};
  const auto asked = [](const std::array<Point3, 4>& of, std::span<const std::uint32_t> in_plane) {
    return Asked{of.data(), {}, 4, in_plane};
  };
  const Asked b = asked(beneath, std::span(one).first(1));
  expect_bounds_of("gjk_nearest3", AreNearest<3>{}, Pairs{above, beneath}, asked(above, three), b);
  const std::array<Point3, 4> edge{{{1, 0, 1}, {-1, 0, 1}, {0, 1, 2}, {0, 0, 3}}};
  expect_bounds_of("gjk_nearest2", AreNearest<2>{}, Pairs{edge, beneath}, asked(edge, std::span(three).first(2)), b);
  const std::array<Point3, 4> corner{{{0, 0, 1}, {1, 0, 2}, {-1, 0, 2}, {0, 0, 3}}};
  expect_bounds_of("gjk_nearest1", AreNearest<1>{}, Pairs{corner, beneath}, asked(corner, std::span(three).first(1)),
                   b);
}

constexpr std::array<std::uint32_t, 3> first_three{0, 1, 2};

/// Is the origin in the hull of these corners of the difference, which are independent, and of which there are no others?
template <int count>
struct HoldOrigin {
  static constexpr int highest = AreNearest<count, false>::highest;
  static constexpr Scales scales = AreNearest<count, false>::scales;
  template <class W>
  bool operator()(W& w, const Pairs& p) const {
    const auto in_plane = std::span(first_three).first(count);
    return AreNearest<count, false>{}(w, p, Asked{p.a.data(), {}, count, in_plane},
                                      Asked{p.b.data(), {}, count, in_plane})
        .meets;
  }
};

TEST(GjkOrigin, EachWorldTellsWhatIsSo) {
  std::array<int, 2> held{};
  for (const FamilyInfo& info : families) {
    int sure = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      Entropy entropy(71, i);
      const std::vector<Point3> c = points3(info.family, Degeneracy::coplanar, 5, entropy);
      // Corners less the last of them: a tetrahedron of differences, which holds the origin where the corners' holds that.
      const Point3 o = c[4];
      const std::string about = std::string(info.name) + ", replay: " + std::to_string(i);
      const Pairs pairs{{c[0], c[1], c[2], c[3]}, {o, o, o, o}};
      const std::array signs{orient3d(o, c[1], c[2], c[3]), orient3d(c[0], o, c[2], c[3]),
                             orient3d(c[0], c[1], o, c[3]), orient3d(c[0], c[1], c[2], o)};
      const bool is_around =
          signs[0] != Sign::zero && signs[1] == signs[0] && signs[2] == signs[0] && signs[3] == signs[0];
      sure += told(IsAroundOrigin{}, is_around, about, pairs);
      if (info.family == Family::extreme) continue;  // distances that round to zero
      // The middle of an edge, where it is a double, is held by it.
      const Point3 middle{std::midpoint(c[0].x, c[1].x), std::midpoint(c[0].y, c[1].y), std::midpoint(c[0].z, c[1].z)};
      const Point3 inner{std::midpoint(middle.x, c[2].x), std::midpoint(middle.y, c[2].y),
                         std::midpoint(middle.z, c[2].z)};
      for (const Point3& at : {o, middle, inner}) {
        const Pairs from{{c[0], c[1], c[2], c[3]}, {at, at, at, at}};
        const bool on_edge = distance(Segment3{c[0], c[1]}, at) == 0;
        if (c[0] != c[1]) told(HoldOrigin<2>{}, on_edge, about, from);
        const bool is_flat = distance(Line3{c[0], {c[1].x - c[0].x, c[1].y - c[0].y, c[1].z - c[0].z}}, c[2]) == 0;
        if (info.family == Family::grid && !is_flat && c[0] != c[1]) {
          const bool on_face = distance(Triangle3{c[0], c[1], c[2]}, at) == 0;
          told(HoldOrigin<3>{}, on_face, about, from);
          held[1] += on_face ? 1 : 0;
        }
        held[0] += on_edge ? 1 : 0;
      }
    }
    const bool is_plain = info.family == Family::uniform || info.family == Family::float32;
    EXPECT_GE(sure, is_plain ? 99 : 0) << info.name;
  }
  EXPECT_GE(held[0], 20);
  EXPECT_GE(held[1], 20);
}

Asked asked_of(const std::array<Point3, 4>& corners, std::span<const std::uint32_t> in_plane) {
  return {corners.data(), {}, 4, in_plane};
}

TEST(GjkOrigin, DoublesTellInPromisedShare) {
  const auto at = [](const auto& x, std::size_t k) { return Point3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
  expect_share<9>("gjk_ahead", Ahead{}, [&](const auto& ask, const auto& x) {
    ask(arith::Plain{x[0], x[1], x[2]}, at(x, 1), at(x, 2));
  });
  expect_share<15>("gjk_are_ahead", AreAhead{}, [&](const auto& ask, const auto& x) {
    const std::array all{at(x, 1), at(x, 2), at(x, 3)};
    ask(arith::Plain{x[0], x[1], x[2]}, all.data(), std::span<const std::uint32_t>(first_three), at(x, 4));
  });
  const auto pairs = [&](const auto& x) {
    const Point3 o = at(x, 4);
    return Pairs{{at(x, 0), at(x, 1), at(x, 2), at(x, 3)}, {o, o, o, o}};
  };
  const auto draw = [&](const auto& ask, const auto& x) { ask(pairs(x)); };
  expect_share<15>("gjk_around_origin", IsAroundOrigin{}, draw);
  const auto nearest = [&]<std::size_t count>() {
    return [&](const auto& ask, const auto& x) {
      const Pairs p = pairs(x);
      const auto in_plane = std::span(first_three).first(count);
      ask(p, asked_of(p.a, in_plane), asked_of(p.b, in_plane));
    };
  };
  expect_share<15>("gjk_nearest1", AreNearest<1>{}, nearest.operator()<1>());
  expect_share<15>("gjk_nearest2", AreNearest<2>{}, nearest.operator()<2>());
  expect_share<15>("gjk_nearest3", AreNearest<3>{}, nearest.operator()<3>());
}

arith::Plain plain(const Point3& p) { return {p.x, p.y, p.z}; }
Sign sign_of_number(double x) { return static_cast<Sign>((x > 0) - (x < 0)); }

TEST(GjkOrigin, MutantsOfPlanesAreNoticed) {
  using mutants::unnoticed, mutants::Draw, mutants::told, mutants::World;
  struct Drawn {
    arith::Plain n;
    std::array<Point3, 3> v;
    Point3 p;
  };
  const auto draw = [](Draw& d) {
    return Drawn{{d.number(), d.number(), d.number()}, {d.point(), d.point(), d.point()}, d.point()};
  };
  const auto ahead = [](const Drawn& x, std::size_t k) { return dot(x.n, plain(x.v[k])) - dot(x.n, plain(x.p)); };
  mutants::expect_noticed("gjk_ahead", unnoticed(
                                           draw, [](const Drawn& x) { return told<World>(Ahead{}, x.n, x.v[0], x.p); },
                                           [&](const Drawn& x) { return sign_of_number(ahead(x, 0)); }));
  mutants::expect_noticed(
      "gjk_are_ahead",
      unnoticed(
          draw, [](const Drawn& x) { return told<World>(AreAhead{}, x.n, x.v.data(), std::span(first_three), x.p); },
          [&](const Drawn& x) { return ahead(x, 0) > 0 && ahead(x, 1) > 0 && ahead(x, 2) > 0; }));
}

/// Corners around a point, which now and then is in the middle of two or three of them; all of them in one plane, too.
Pairs drawn_pairs(mutants::Draw& d) {
  const Point3 o = d.point();
  std::array<Point3, 4> c{d.point(), d.point(), d.point(), d.point()};
  const double kind = d.positive();
  if (kind == 2) c[1] = {2 * o.x - c[0].x, 2 * o.y - c[0].y, 2 * o.z - c[0].z};
  if (kind == 3) {
    const double part = d.positive();  // of c[2] on the other side
    c[2] = {o.x + (2 * o.x - c[0].x - c[1].x) * part, o.y + (2 * o.y - c[0].y - c[1].y) * part,
            o.z + (2 * o.z - c[0].z - c[1].z) * part};
  }
  return {c, {o, o, o, o}};
}
TEST(GjkOrigin, MutantsAreNoticed) {
  using mutants::unnoticed, mutants::told, mutants::World;
  mutants::expect_noticed("gjk_around_origin",
                          unnoticed(
                              drawn_pairs, [](const Pairs& p) { return told<World>(IsAroundOrigin{}, p); },
                              [](const Pairs& p) {
                                const auto& c = p.a;
                                const Point3& o = p.b[0];
                                const std::array signs{orient3d(o, c[1], c[2], c[3]), orient3d(c[0], o, c[2], c[3]),
                                                       orient3d(c[0], c[1], o, c[3]), orient3d(c[0], c[1], c[2], o)};
                                return signs[0] != Sign::zero && signs[1] == signs[0] && signs[2] == signs[0] &&
                                       signs[3] == signs[0];
                              }));
}

/// By the weights of the nearest point of their plane, solved of its normal equations; of numbers that doubles hold.
template <int count>
bool are_nearest(const Pairs& p) {
  const auto difference = [&](std::size_t i) { return plain(p.a[i]) - plain(p.b[i]); };
  const arith::Plain d = difference(0), u = difference(1) - d, v = difference(2) - d;
  double whole = 1, of_u = 0, of_v = 0;
  if constexpr (count == 2) whole = dot(u, u), of_u = -dot(d, u);
  if constexpr (count == 3) {
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), du = dot(d, u), dv = dot(d, v);
    whole = uu * vv - uv * uv, of_u = dv * uv - du * vv, of_v = du * uv - dv * uu;
    if (of_v <= 0) return false;
  }
  if (count > 1 && (of_u <= 0 || whole - of_u - of_v <= 0)) return false;
  const arith::Plain nearest = d * whole + u * of_u + v * of_v;
  for (std::size_t i = count; i < 4; ++i) {
    if (dot(plain(p.a[i]) - plain(p.a[0]), nearest) <= 0 || dot(plain(p.b[i]) - plain(p.b[0]), nearest) >= 0)
      return false;
  }
  return dot(nearest, nearest) > 0;
}
template <int count>
std::string unnoticed_of_nearest() {
  return mutants::unnoticed(
      [](mutants::Draw& d) {
        // Hulls that are apart as a rule, so that a corner, an edge or a face of their difference is nearest.
        Pairs p{{d.point(), d.point(), d.point(), d.point()}, {d.point(), d.point(), d.point(), d.point()}};
        const double away = 2 * d.positive();
        for (std::size_t i = 0; i < 4; ++i)
          p.a[i].x += away, p.b[i].y -= i < count ? 0 : away, p.a[i].z += i < count ? 0 : 4;
        return p;
      },
      [](const Pairs& p) {
        const auto in_plane = std::span(first_three).first(count);
        return mutants::told<mutants::World>(AreNearest<count>{}, p, asked_of(p.a, in_plane), asked_of(p.b, in_plane));
      },
      are_nearest<count>);
}
TEST(GjkNearest, MutantsAreNoticed) {
  mutants::expect_noticed("gjk_nearest1", unnoticed_of_nearest<1>());
  mutants::expect_noticed("gjk_nearest2", unnoticed_of_nearest<2>());
  mutants::expect_noticed("gjk_nearest3", unnoticed_of_nearest<3>());
}

}  // namespace
}  // namespace plumb::query
