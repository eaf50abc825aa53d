// Figures under rigid poses and chains: does relate say what brute force in rationals says of their exact images?  Of
// every pair of the table with straight edges, flat faces or a core and a radius, degenerate forms first.
//
// Where balls, capsules and lozenges are in it, the radius is as often as not the distance, so that they just touch.
// Cost: 0.5 ms a case, of polygons with holes a hundred times that; as many of each pair as PLUMB_POSED_CASES says, few by
// default, and of costly pairs a twentieth.
#include <gtest/gtest.h>

#include <cstdlib>

#include "certify/sanitized.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/overlap/round_oracle.hpp"

namespace plumb::pair_cases {
namespace {

using oracle::Pieces, oracle::RationalPoint, oracle::Spanned;

std::uint64_t cases_of(const PairRow& row) {
  const char* asked = std::getenv("PLUMB_POSED_CASES");
  const std::uint64_t cases = asked == nullptr ? (battery::sanitized ? 1 : 6) : std::strtoull(asked, nullptr, 10);
  return is_costly(row.a->kind) || is_costly(row.b->kind) ? (cases + 19) / 20 : cases;
}

RationalPoint point_of(const rationals::Vector& v) { return {v[0], v[1], v.size() == 3 ? v[2] : mpq_class(0)}; }

/// What the pose makes of a set: its points are moved, its directions turned.
template <class By>
Spanned image_of(const By& by, const Spanned& s) {
  const auto moved = [&](const RationalPoint& p) {
    return point_of(rigid_poses::image(by, rationals::Vector(p.begin(), p.end())));
  };
  Spanned made;
  for (const RationalPoint& p : s.points) made.points.push_back(moved(p));
  const RationalPoint origin = moved({0, 0, 0});
  for (const RationalPoint& d : s.directions) made.directions.push_back(oracle::difference(moved(d), origin));
  return made;
}

/// In space a pose of the plane turns about z.
RigidPose in_space(const RigidPose2& p) { return {{p.turn.w, 0, 0, p.turn.z}, {p.translation.x, p.translation.y, 0}}; }
RigidChain in_space(const RigidChain2& chain) {
  RigidChain made;
  for (const RigidPose2& link : chain.links) made.links.push_back(in_space(link));
  return made;
}
template <class By>
const By& in_space(const By& by) {
  return by;
}
Spanned image_of(const RigidCase& by, int dimension, const Spanned& s) {
  const auto made = [&](const auto& pose) { return image_of(in_space(pose), s); };
  return dimension == 3 ? std::visit(made, by.space) : std::visit(made, by.plane);
}

/// A figure as the brute force sees it: flat pieces, or a core with a radius.
struct Judged {
  Pieces pieces;
  mpq_class radius = 0;
  bool is_round = false;
};
template <class All>
Judged judged(All all, const AnyFigure& s, const RigidCase& by) {
  Judged made;
  made.is_round = has_core(s.row().kind);
  const Pieces pieces = made.is_round ? Pieces{{core_of(s)}, {}} : pieces_of(all, s);
  if (made.is_round) made.radius = radius_of(s);
  for (const Spanned& p : pieces.inner) made.pieces.inner.push_back(image_of(by, s.row().dimension, p));
  for (const Spanned& p : pieces.boundary) made.pieces.boundary.push_back(image_of(by, s.row().dimension, p));
  return made;
}

oracle::Cells cells_of(const Pieces& of) {
  return {{of.inner.begin(), of.inner.end()}, {of.boundary.begin(), of.boundary.end()}};
}

struct Seen {
  Answers answers;
  int touch_by_radius = 0;
};

/// More often than not a turn of small integers, so that figures come to touch and rationals stay short.
RigidCase drawn_case(Material& m) {
  using rigid_poses::TurnKind;
  if (m.below(4) == 0) return rigid_case(m);
  const auto step = [&] { return 0.5 * (static_cast<double>(m.below(9)) - 4); };
  const Rotation turn = rigid_poses::turn(m.below(2) == 0 ? TurnKind::quarter : TurnKind::pythagorean, m.entropy());
  const double x = step(), y = step(), z = step();
  const RigidPose pose{turn, {x, y, z}};
  return {pose, flat_of(pose)};
}
/// Both under one pose, under two, or one of them as it stands.
std::array<RigidCase, 2> poses_of_two(Material& m) {
  const RigidCase first = drawn_case(m), stands{RigidPose{}, RigidPose2{}};
  switch (m.below(4)) {
    case 0:
      return {first, stands};
    case 1:
      return {first, drawn_case(m)};
    default:
      return {first, first};
  }
}

/// Moves the second so that a corner of it comes upon one of the first, where doubles can say so.
void put_upon(RigidCase& by, int dimension, const Pieces& first, const Pieces& second, Material& m) {
  if (first.inner.empty() || second.inner.empty()) return;
  const auto corner = [&m](const Spanned& s) { return s.points[m.below(s.points.size())]; };
  if (first.inner[0].points.empty() || second.inner[0].points.empty()) return;
  const RationalPoint way = oracle::difference(corner(first.inner[0]), corner(second.inner[0]));
  bool is_exact = true;
  const auto moved = [&](double from, const mpq_class& by_way) {
    const mpq_class to = mpq_class(from) + by_way;
    const double nearest = to.get_d();
    is_exact = is_exact && std::isfinite(nearest) && mpq_class(nearest) == to;
    return nearest;
  };
  RigidCase made = by;
  if (auto* solid = std::get_if<RigidPose>(&made.space); solid != nullptr && dimension == 3) {
    Vector3& t = solid->translation;
    t = {moved(t.x, way[0]), moved(t.y, way[1]), moved(t.z, way[2])};
  } else if (auto* flat = std::get_if<RigidPose2>(&made.plane); flat != nullptr && dimension == 2) {
    Vector2& t = flat->translation;
    t = {moved(t.x, way[0]), moved(t.y, way[1])};
  } else {
    return;
  }
  if (is_exact) by = made;
}

template <class All>
void judge(All all, const PairRow& row, Material& m, Seen& seen) {
  const bool is_degenerate = m.below(2) == 0;
  const AnyFigure a = is_degenerate ? degenerate(*row.a, m) : figure(*row.a, m);
  AnyFigure b = m.below(4) == 0 ? degenerate(*row.b, m) : near_figure(*row.b, m);
  auto by = poses_of_two(m);
  const Judged p = judged(all, a, by[0]);
  Judged q = judged(all, b, by[1]);
  if (m.below(3) == 0) {
    put_upon(by[1], row.dimension(), p.pieces, q.pieces, m);
    q = judged(all, b, by[1]);
  }
  Relation expected{};
  if (p.is_round || q.is_round) {
    const Judged &round = q.is_round ? q : p, &other = q.is_round ? p : q;
    const oracle::RoundOracle brute(round.pieces.inner[0], other.pieces);
    if (q.is_round && brute.square() && m.below(2) == 0) {
      if (const auto root = oracle::exact_root(*brute.square()); root && *root - p.radius.get_d() >= 0) {
        b = with_radius(b, *root - p.radius.get_d());
        q.radius = radius_of(b);
      }
    }
    const mpq_class reach = p.radius + q.radius;
    expected = brute.relation(reach);
    if (reach > 0 && expected == Relation::touching) ++seen.touch_by_radius;
  } else {
    expected = oracle::relation(cells_of(p.pieces), cells_of(q.pieces));
  }
  seen.answers.add(expected);
  const query::PosedView x = by[0].posed(a.view()), y = by[1].posed(b.view());
  EXPECT_EQ(query::relate_posed("relate", x, y), expected) << row.name() << about(m, a, b);
  EXPECT_EQ(query::relate_posed("relate", y, x), expected) << "swapped: " << row.name() << about(m, a, b);
}

template <class All>
void judge_all(All all, std::uint64_t start) {
  Seen seen;
  for (const PairRow& row : pairs_of(all)) {
    const PairOracle by = oracle_of(row.a->kind, row.b->kind);
    if (!row.is_posed || (by != PairOracle::cells && by != PairOracle::core)) continue;
    for (std::uint64_t i = 0; i < cases_of(row) && !::testing::Test::HasFailure(); ++i) {
      Material m(start, i);
      judge(all, row, m, seen);
    }
    ++start;
  }
  std::printf("%d apart, %d touch, %d overlap; %d touch by a radius above zero\n", seen.answers.of(Relation::disjoint),
              seen.answers.of(Relation::touching), seen.answers.of(Relation::overlapping), seen.touch_by_radius);
  if (battery::sanitized) return;
  const auto all_answers = seen.answers.of(Relation::disjoint) + seen.answers.of(Relation::touching) +
                           seen.answers.of(Relation::overlapping);
  EXPECT_GT(seen.answers.of(Relation::touching) * 20, all_answers);
  EXPECT_GT(seen.answers.of(Relation::overlapping) * 10, all_answers);
  EXPECT_GT(seen.touch_by_radius, 0);
}

TEST(RigidJudge, PairsOfSpaceLieAsBruteForceSays) { judge_all(Space{}, 47000); }
TEST(RigidJudge, PairsOfThePlaneLieAsBruteForceSays) { judge_all(Plane{}, 48000); }

}  // namespace
}  // namespace plumb::pair_cases
