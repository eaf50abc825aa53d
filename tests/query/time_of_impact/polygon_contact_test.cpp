// Straight motions of tetrahedra, rectangles, lozenges and polygons against all that moves: against the oracle in
// rationals, as the triangles that polygons are cut into, under poses and where both move, and where they pass holes.
#include <gmock/gmock.h>

#include <variant>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "query/time_of_impact/translating_cases.hpp"
#include "query/time_of_impact/translating_truth.hpp"

namespace plumb {
namespace {

using query::PosedMotion, query::PosedView;
using shape_cases::Material;
using testing::HasSubstr;
using testing::ThrowsMessage;
using translating_cases::Draw, translating_cases::Numbers;
namespace oracle = translating_oracle;

using AnyShape = std::variant<Tetrahedron3, Rectangle3, Lozenge3, Point3, Segment3, Triangle3, Aabb3, Obb3,
                              ConvexPolyhedron3, Sphere3, Capsule3, Plane3>;
constexpr std::size_t of_these = 3;  // which translating_contact.hpp does not take

AnyShape shape_of(std::size_t kind) {
  AnyShape s;
  const auto make = [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((kind == I ? (void)s.emplace<I>() : void()), ...);
  };
  make(std::make_index_sequence<std::variant_size_v<AnyShape>>{});
  return s;
}

struct AnyMover {
  AnyShape shape;
  Vector3 by;

  static AnyMover drawn(Draw& draw, std::size_t kind) {
    AnyMover m{shape_of(kind), {}};
    std::visit([&](auto& s) { draw.fill(s); }, m.shape);
    m.by = draw.motion();
    return m;
  }
  [[nodiscard]] PosedMotion motion(const Pose* pose = nullptr) const {
    return {{std::visit([](const auto& s) { return query::view_of(s); }, shape), pose}, by};
  }
  [[nodiscard]] oracle::Mover mover() const {
    return {std::visit([](const auto& s) { return oracle::body(s); }, shape), oracle::vector(by)};
  }
};

oracle::Answers answers(const PosedMotion& a, const PosedMotion& b) {
  return {posed_contact_time(a, b), posed_contact(a, b), posed_contact(b, a), posed_bodies_meet(a, b),
          posed_bodies_meet(b, a)};
}

const Feature inside{FeatureKind::interior, 0};
/// Of a polygon that only touches, a vertex may be inside of the other.
bool is_inside(const Contact& c) { return c.feature_a == inside && c.feature_b == inside; }
const Pose quarter{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {3, 0, -1}};  // with which small whole numbers stay exact
Vector3 turned(const Vector3& v) { return {-2 * v.y, 2 * v.x, 2 * v.z}; }
Vector3 sum(const Vector3& v, const Vector3& w) { return {v.x + w.x, v.y + w.y, v.z + w.z}; }

/// Neither a common pose nor a common motion changes what is told; and it starts inside where they overlap.
void expect_laws(const std::string& about, const PosedMotion& a, const PosedMotion& b, Draw& draw,
                 const std::optional<Contact>& contact) {
  const Relation start = query::relate_posed("test", a.figure, b.figure);
  EXPECT_EQ(start == Relation::overlapping, contact && is_inside(*contact)) << about;
  const Vector3 also = draw.motion(), by_a = turned(sum(a.by, also)), by_b = turned(sum(b.by, also));
  const PosedMotion c{{a.figure.figure, &quarter}, by_a}, d{{b.figure.figure, &quarter}, by_b};
  EXPECT_EQ(posed_contact(c, d), contact) << about;
}

#if defined(PLUMB_LONG_TESTS)
constexpr std::uint64_t numbers_of_cases = 3000;
#else
const std::uint64_t numbers_of_cases = battery::sanitized ? 36 : 144;
#endif

TEST(PolytopeContact, IsTrueOfAnyNumbers) {
  oracle::Told told;
  for (std::uint64_t i = 0; i < numbers_of_cases; ++i) {
    Entropy entropy(6100, i);
    const auto numbers = static_cast<Numbers>(i % 5);
    Draw draw(entropy, numbers);
    const AnyMover a = AnyMover::drawn(draw, i / 5 % of_these),
                   b = AnyMover::drawn(draw, entropy.below(std::variant_size_v<AnyShape>));
    const std::string about = "index " + std::to_string(i);
    const oracle::Answers says = answers(a.motion(), b.motion());
    oracle::check_truth(about, a.mover(), b.mover(), says, told);
    if (numbers == Numbers::integers) expect_laws(about, a.motion(), b.motion(), draw, says.contact);
    if (HasFailure()) return;
  }
  const int few = static_cast<int>(numbers_of_cases / 12);
  EXPECT_GT(told.never, few);
  EXPECT_GT(told.at_start, few);
  EXPECT_GT(told.later, few);
  EXPECT_GT(told.irrational, few / 4);
}

double whole(Material& m, std::size_t most) {
  return static_cast<double>(m.below(2 * most + 1)) - static_cast<double>(most);
}

/// A polygon of the plane of two whole vectors, and triangles that make it up.
struct Cut {
  std::vector<Point2> outer, hole;
  std::vector<std::array<Point2, 3>> triangles;
};
const std::vector<Cut>& cuts() {
  static const std::vector<Cut> all{
      {{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}},
       {},
       {{{{0, 0}, {4, 0}, {2, 1}}}, {{{4, 0}, {4, 4}, {2, 1}}}, {{{0, 0}, {2, 1}, {0, 4}}}}},
      {{{0, 0}, {6, 0}, {6, 6}, {0, 6}},
       {{1, 1}, {1, 5}, {5, 5}, {5, 1}},
       {{{{0, 0}, {6, 0}, {5, 1}}},
        {{{0, 0}, {5, 1}, {1, 1}}},
        {{{6, 0}, {6, 6}, {5, 5}}},
        {{{6, 0}, {5, 5}, {5, 1}}},
        {{{6, 6}, {0, 6}, {1, 5}}},
        {{{6, 6}, {1, 5}, {5, 5}}},
        {{{0, 6}, {0, 0}, {1, 1}}},
        {{{0, 6}, {1, 1}, {1, 5}}}}},
      {{{0, 0}, {3, 0}, {3, 0}, {1, 3}}, {}, {{{{0, 0}, {3, 0}, {1, 3}}}}},
      {{{0, 0}, {2, 0}, {5, 0}}, {}, {{{{0, 0}, {2, 0}, {5, 0}}}}},
      // Edges that bound no inside: a spike, a chain there and back, and a hole of one.
      {{{0, 0}, {4, 0}, {9, 0}, {4, 0}, {0, 3}}, {}, {{{{0, 0}, {4, 0}, {0, 3}}}, {{{4, 0}, {9, 0}, {9, 0}}}}},
      {{{0, 0}, {4, 0}, {4, 5}, {4, 0}}, {}, {{{{0, 0}, {4, 0}, {4, 0}}}, {{{4, 0}, {4, 5}, {4, 5}}}}},
      {{{0, 0}, {3, 0}, {0, 3}}, {{4, 4}, {6, 5}, {4, 4}}, {{{{0, 0}, {3, 0}, {0, 3}}}, {{{4, 4}, {6, 5}, {6, 5}}}}}};
  return all;
}

struct MovingPolygon {
  MovingPolygon(HoledPolygon3 p, std::vector<Triangle3> of, const Vector3& motion)
      : polygon(std::move(p)), triangles(std::move(of)), by(motion) {}
  explicit MovingPolygon(Material& m) : by{whole(m, 2), whole(m, 2), whole(m, 2)} {
    const Cut& cut = cuts()[m.below(cuts().size())];
    const Point3 o{whole(m, 2), whole(m, 2), whole(m, 2)};
    const Vector3 u{whole(m, 1), whole(m, 1), whole(m, 1)}, v{whole(m, 1), whole(m, 1), whole(m, 1)};
    const auto place = [&](const Point2& p) {
      return Point3{o.x + p.x * u.x + p.y * v.x, o.y + p.x * u.y + p.y * v.y, o.z + p.x * u.z + p.y * v.z};
    };
    for (const Point2& p : cut.outer) polygon.outer.vertices.push_back(place(p));
    if (!cut.hole.empty()) polygon.holes.resize(1);
    for (const Point2& p : cut.hole) polygon.holes[0].vertices.push_back(place(p));
    for (const auto& [a, b, c] : cut.triangles) triangles.push_back({place(a), place(b), place(c)});
  }
  [[nodiscard]] PosedMotion motion() const { return {{query::view_of(polygon)}, by}; }
  [[nodiscard]] PosedMotion motion(const Triangle3& part) const { return {{query::view_of(part)}, by}; }

  /// The features, a face as the triangles.
  [[nodiscard]] std::vector<std::pair<Feature, oracle::Body>> features() const {
    std::vector<std::pair<Feature, oracle::Body>> all;
    std::uint32_t first = 0;
    const auto add = [&](const Polygon3& chain) {
      const auto n = static_cast<std::uint32_t>(chain.vertices.size());
      for (std::uint32_t i = 0; i < n; ++i) {
        all.push_back({{FeatureKind::vertex, first + i}, oracle::body(chain.vertices[i])});
        all.push_back(
            {{FeatureKind::edge, first + i}, oracle::body(Segment3{chain.vertices[i], chain.vertices[(i + 1) % n]})});
      }
      first += n;
    };
    add(polygon.outer);
    for (const Polygon3& hole : polygon.holes) add(hole);
    for (const Triangle3& t : triangles) all.push_back({{FeatureKind::face, 0}, oracle::body(t)});
    return all;
  }

  HoledPolygon3 polygon{};
  std::vector<Triangle3> triangles{};
  Vector3 by;
};

std::optional<Root> earlier(std::optional<Root> a, const std::optional<Root>& b) {
  return b && (!a || *b < *a) ? b : a;
}

struct PolygonsSeen {
  int cases = 0, met = 0, faces = 0, later = 0;
};

/// What is told of a body or polygon and a polygon, if the first of their triangles meet then.
std::optional<Contact> expect_as_pieces(const std::string& about, const PosedMotion& a, const PosedMotion& b,
                                        const std::optional<Root>& wanted, PolygonsSeen& seen) {
  const oracle::Answers says = answers(a, b);
  ++seen.cases;
  EXPECT_EQ(says.time.has_value(), wanted.has_value()) << about;
  EXPECT_EQ(says.contact.has_value(), wanted.has_value()) << about;
  EXPECT_TRUE(says.meet == wanted.has_value() && says.meet_swapped == says.meet) << about;
  if (!says.time || !wanted || !says.contact) return {};
  ++seen.met;
  EXPECT_TRUE(*says.time == *wanted) << about << says.time->rounded() << " " << wanted->rounded();
  EXPECT_EQ(says.contact->time, wanted->rounded(Rounding::down) + 0.0) << about;
  EXPECT_TRUE(says.of_swapped && says.of_swapped->time == says.contact->time) << about;
  const Relation at_start = query::relate_posed("test", a.figure, b.figure);
  EXPECT_EQ(at_start == Relation::overlapping, is_inside(*says.contact)) << about;
  EXPECT_EQ(at_start != Relation::disjoint, *says.time == Root(0)) << about;
  seen.faces += says.contact->feature_b == Feature{FeatureKind::face, 0} ? 1 : 0;
  seen.later += says.contact->time > 0 ? 1 : 0;
  return says.contact;
}

/// Those told meet at that time, and no lower ones do.
void expect_lowest(const std::string& about, const AnyMover& a, const MovingPolygon& b, const Contact& contact) {
  const auto rank = [](const Feature& p, const Feature& q) {
    return std::tuple(static_cast<int>(p.kind) + static_cast<int>(q.kind), p.kind, p.index, q.kind, q.index);
  };
  const auto told = rank(contact.feature_a, contact.feature_b);
  const auto [body, by] = a.mover();
  std::vector<std::pair<Feature, oracle::Body>> parts;
  const bool is_all_space = body.is_plane && oracle::is_zero(body.normal);
  // A vertex of the polygon may be inside, which is known by all edges of the body.  All of space has no face.
  if (!body.is_plane || is_all_space) parts.push_back({inside, body});
  if (!is_all_space) {
    for (const oracle::Part& p : body.parts) parts.push_back({p.feature, body.part(p)});
  }
  const oracle::Vector velocity = oracle::operator-(by, oracle::vector(b.by));
  bool found = false;
  for (const auto& [of_body, body_part] : parts) {
    for (const auto& [feature, part] : b.features()) {
      const auto of_pair = rank(of_body, feature);
      if (of_pair > told) continue;
      const auto when = oracle::first_time(body_part, part, velocity);
      const bool in_time = when && compare(*when, std::nextafter(contact.time, 2.0)) < 0;
      EXPECT_FALSE(in_time && of_pair < told)
          << about << " feature " << of_body.index << " of the body, " << feature.index << " of the polygon";
      found = found || (in_time && of_pair == told);
    }
  }
  EXPECT_TRUE(found) << about;
}

TEST(PolygonContact, BodiesAsTheTriangles) {
  PolygonsSeen seen;
  std::uint64_t index = 0;
  shape_cases::on_shapes(6001, battery::sanitized ? 60 : 300, [&](Material& m) {
    Entropy entropy(6002, index);
    Draw draw(entropy);
    const AnyMover a = AnyMover::drawn(draw, index++ % std::variant_size_v<AnyShape>);
    const MovingPolygon b(m);
    std::optional<Root> wanted;
    for (const Triangle3& t : b.triangles) wanted = earlier(wanted, posed_contact_time(a.motion(), b.motion(t)));
    const std::string about = "index " + std::to_string(index - 1);
    const auto contact = expect_as_pieces(about, a.motion(), b.motion(), wanted, seen);
    if (!contact) return;
    expect_laws(about, a.motion(), b.motion(), draw, contact);
    if (!is_inside(*contact)) expect_lowest(about, a, b, *contact);
  });
  EXPECT_GT(seen.met * 5, seen.cases);
  EXPECT_LT(seen.met * 6, seen.cases * 5);
  EXPECT_GE(seen.faces, battery::sanitized ? 0 : 2);  // a fifth of the cases may have none
  EXPECT_GT(seen.later * 5, seen.met);
}

TEST(PolygonContact, VertexInsideIsTheLowest) {
  const Vector3 rest{0, 0, 0};
  // A hole that is a spike comes into a skew box, which the rest of the polygon is clear of.
  const AnyMover box{
      Obb3{{-4, -5, 4}, {{{3, 3, 0}, {-3, -2, -3}, {0, 2, 2}}}, {1, 3, 1}},
      {384, -128, 384},
  };
  const MovingPolygon spike{{{{{2, 0, 0}, {-1, 0, 3}, {5, 0, 3}}}, {{{{2, 0, 8}, {1, 0, 11}, {2, 0, 8}}}}},
                            {{{2, 0, 0}, {-1, 0, 3}, {5, 0, 3}}, {{2, 0, 8}, {1, 0, 11}, {1, 0, 11}}},
                            {2, 0, -2}};
  const Contact in_box{0, inside, {FeatureKind::vertex, 3}};
  EXPECT_EQ(posed_contact(box.motion(), spike.motion()), in_box);
  expect_lowest("a box", box, spike, in_box);
  // All of space, which a plane without a normal is, has an inside; edges that bound none do not overlap it.
  const AnyMover space{Plane3{{0, 0, 0}, 0}, rest};
  const MovingPolygon there_and_back{
      {{{{1, 0, 1}, {1, -4, 5}, {6, -4, 0}, {1, -4, 5}}}, {}},
      {{{1, 0, 1}, {1, -4, 5}, {1, -4, 5}}, {{1, -4, 5}, {6, -4, 0}, {6, -4, 0}}},
      rest,
  };
  const Contact in_space{0, inside, {FeatureKind::vertex, 0}};
  EXPECT_EQ(posed_contact(space.motion(), there_and_back.motion()), in_space);
  expect_lowest("all of space", space, there_and_back, in_space);
}

TEST(PolygonContact, PolygonsAsTheTriangles) {
  PolygonsSeen seen;
  shape_cases::on_shapes(6003, battery::sanitized ? 60 : 160, [&](Material& m) {
    MovingPolygon a(m);
    const MovingPolygon b(m);
    a.by = {whole(m, 12), whole(m, 12), whole(m, 12)};
    std::optional<Root> wanted;
    for (const Triangle3& s : a.triangles) {
      for (const Triangle3& t : b.triangles) wanted = earlier(wanted, posed_contact_time(a.motion(s), b.motion(t)));
    }
    expect_as_pieces(m.about(a.polygon.outer.vertices[0], b.polygon.outer.vertices[0]), a.motion(), b.motion(), wanted,
                     seen);
  });
  EXPECT_GT(seen.met * 8, seen.cases);
  EXPECT_LT(seen.met * 6, seen.cases * 5);
  EXPECT_GT(seen.later * 5, seen.met);
}

TEST(PolytopeContact, SaysWhichFeatures) {
  const Tetrahedron3 tip{{0, 0, 4}, {1, 0, 6}, {0, 1, 6}, {-1, -1, 6}};
  const Rectangle3 sheet{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}, {2, 3}};
  EXPECT_EQ(first_contact(Translating{tip, {0, 0, -8}}, sheet),
            (Contact{0.5, {FeatureKind::vertex, 0}, {FeatureKind::face, 0}}));
  const Lozenge3 pad{{-2, -3, 0}, {Vector3{4, 0, 0}, Vector3{0, 6, 0}}, 1};
  EXPECT_EQ(first_contact(Translating{tip, {0, 0, -6}}, pad),
            (Contact{0.5, {FeatureKind::vertex, 0}, {FeatureKind::face, 0}}));
  EXPECT_EQ(first_contact(Translating{pad, {0, 0, 6}}, Point3{3, 0, 3}),  // its rim, as high as the core
            (Contact{0.5, {FeatureKind::edge, 3}, {FeatureKind::vertex, 0}}));
  EXPECT_FALSE(intersects(Translating{pad, {0, 0, 6}}, Point3{std::nextafter(3.0, 4.0), 0, 3}));
  // At rest, and sliding along a face.
  EXPECT_FALSE(first_contact(Translating{sheet, {0, 0, 0}}, Point3{2, 3, 1}));
  EXPECT_EQ(first_contact(Translating{sheet, {0, 0, 0}}, Point3{2, 3, 0})->time, 0);
  const Aabb3 table{{4, -1, -1}, {9, 1, 0}};
  EXPECT_EQ(first_contact(Translating{sheet, {8, 0, 0}}, table),  // its edge on the table's upper one
            (Contact{0.25, {FeatureKind::edge, 3}, {FeatureKind::vertex, 4}}));
  EXPECT_FALSE(intersects(Translating{Rectangle3{{0, 0, 0x1p-60}, sheet.axes, sheet.half}, {8, 0, 0}}, table));
  const Quadrilateral3 notched{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  EXPECT_FALSE(first_contact(Translating{Point3{2, 2, 1}, {0, 0, -2}}, notched));
  EXPECT_FALSE(first_contact(Translating{Aabb3{{1, 1, 2}, {0.25, 0.25, 1}}, {0, 0, -4}}, notched));  // an empty box
  EXPECT_EQ(first_contact(Translating{tip, {0.5, 0.5, -8}}, notched),
            (Contact{0.5, {FeatureKind::vertex, 0}, {FeatureKind::face, 0}}));
}

TEST(PolygonContact, FeaturesAndHoles) {
  const HoledPolygon3 floor{{{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}},
                            {{{{1, 1, 0}, {1, 5, 0}, {5, 5, 0}, {5, 1, 0}}}}};
  const auto drop = [&](Point3 from, double r) {
    return first_contact(Translating{Sphere3{from, r}, {0, 0, -10}}, floor);
  };
  const Feature ball{FeatureKind::face, 0};
  EXPECT_FALSE(drop({3, 3, 5}, 1.5));                                           // through the hole
  EXPECT_EQ(drop({3, 3, 5}, 2), (Contact{0.5, ball, {FeatureKind::edge, 4}}));  // all four rims at once
  EXPECT_EQ(drop({0.5, 3, 5}, 0.25), (Contact{0.47499999999999998, ball, {FeatureKind::face, 0}}));
  EXPECT_EQ(drop({-3, -4, 7}, 13), (Contact{0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}));
  EXPECT_EQ(drop({-3, -4, 12}, 13), (Contact{0, ball, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(first_contact(Translating{Capsule3{{0.5, 1, 5}, {0.5, 5, 5}, 1}, {0, 0, -10}}, floor),
            (Contact{0.39999999999999997, {FeatureKind::vertex, 0}, {FeatureKind::face, 0}}));
  const Rectangle3 sheet{{3, 3, 0}, {{{1, 0, 0}, {0, 1, 0}}}, {3, 3}};
  EXPECT_EQ(first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, -8}}, sheet),
            (Contact{0.5, ball, {FeatureKind::face, 0}}));
  EXPECT_EQ(first_contact(Translating{sheet, {0, 0, 8}}, Sphere3{{6, 7, 5}, 1}),
            (Contact{0.625, {FeatureKind::vertex, 3}, ball}));
  EXPECT_EQ(first_contact(Translating{sheet, {0, 0, 8}}, Sphere3{{5, 7, 5}, 1}),
            (Contact{0.625, {FeatureKind::edge, 1}, ball}));  // along x, at the upper end of y
  const Quadrilateral3 quad{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}};
  EXPECT_EQ(first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, -8}}, quad),
            (Contact{0.5, ball, {FeatureKind::face, 0}}));
  EXPECT_THAT(
      [&] {
        (void)first_contact(Translating{Sphere3{{3, 3, 5}, -1}, {0, 0, -8}}, quad);
      },
      ThrowsMessage<InvalidShape>(HasSubstr("first_contact: ")));
  EXPECT_THAT(
      [&] {
        (void)first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, NAN}}, quad);
      },
      ThrowsMessage<NonFinite>(HasSubstr("first_contact: a.by.z is nan")));
  const Polygon3 bent{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}};
  EXPECT_THROW((void)first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, -8}}, bent), InvalidShape);
}

}  // namespace
}  // namespace plumb
