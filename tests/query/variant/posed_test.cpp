// Figures of any kind under poses of any kind: a common rigid pose changes no answer to any question, in every pair of
// its table; an answer is that of the kinds under the same poses, bit for bit, at both places.
#include <gtest/gtest.h>

#include <map>

#include "certify/sanitized.hpp"
#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "query/body/degenerate_forms.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/variant/outcome.hpp"

namespace plumb::pair_cases {
namespace {

using Some = plumb::AnyFigure;

AnyPose pose_in(const RigidCase& by, int dimension) {
  const auto kept = [](const auto& pose) { return AnyPose(pose); };
  return dimension == 3 ? std::visit(kept, by.space) : std::visit(kept, by.plane);
}

/// Not what is told, which the pose moves, but what it keeps; of an error its type.
struct Kept {
  std::string of(Relation r) { return std::to_string(static_cast<int>(r)); }
  std::string of(bool b) { return b ? "yes" : "no"; }
  std::string of(double x) { return hexadecimal(x); }
  std::string of(const ExactDistance& d) {  // of what meets, zero in one of many ways
    return compare(d, ExactDistance{}) == Sign::zero ? "none" : d.square.text() + " " + d.inset.text();
  }
  std::string of(const Closest& c) { return of(c.distance); }
  std::string of(Sign s) { return std::to_string(static_cast<int>(s)); }
  std::string of(const Feature& f) { return std::to_string(static_cast<int>(f.kind)) + "." + std::to_string(f.index); }
  std::string of(const Hit& h) { return of(h.t) + of(h.feature); }
  std::string of(const Contact& c) { return of(c.time) + of(c.feature_a) + of(c.feature_b); }
  std::string of(const Penetration& p) { return of(p.depth); }
  std::string of(const ContactManifold& c) { return of(c.relation) + of(c.distance); }
  std::string of(const AnyIntersection& common) {
    return std::visit(
        []<class Common>(const Common& c) {
          std::string text = std::to_string(static_cast<int>(c.kind));
          if constexpr (requires { c.vertices; }) text += " " + std::to_string(c.vertices.size());
          return text;
        },
        common);
  }
  template <class T>
  std::string of(const std::optional<T>& x) {
    return x ? of(*x) : "nothing";
  }
};
template <class Call>
std::string kept(const Call& call) {
  try {
    return Kept().of(call());
  } catch (const Unsupported&) {
    return "Unsupported";
  } catch (const UnevenPose&) {
    return "UnevenPose";
  } catch (const InvalidShape&) {
    return "InvalidShape";
  }
}

class Laws {
 public:
  explicit Laws(std::string name) : name_(std::move(name)) {}
  std::map<std::string, std::array<int, 2>>* seen = nullptr;  // of each question the answers, and how many are none

  template <class Plain, class Moved>
  void expect(const std::string& question, const Plain& plain, const Moved& moved) const {
    const std::string wanted = kept(plain);
    auto& [answers, refused] = (*seen)[question];
    ++answers, refused += wanted == "Unsupported" || wanted == "InvalidShape";
    EXPECT_EQ(kept(moved), wanted) << question << ": " << name_;
  }

 private:
  std::string name_;
};

/// A motion whose image is known without rounding: along an axis of the figure, as often as the matrix's weight says.
struct Ways {
  Vector3 before, after;
};
std::optional<Ways> ways_under(const AnyPose& pose, Material& m) {
  const double size = std::ldexp(m.below(2) == 0 ? 1.0 : -1.0, static_cast<int>(m.below(4)));
  if (const auto* rigid = std::get_if<RigidPose>(&pose)) {
    if (const auto turn = exact_matrix(rigid->turn)) {
      const Vector3& c = turn->columns[1];
      return Ways{{0, size * turn->weight, 0}, {c.x * size, c.y * size, c.z * size}};
    }
  } else if (const auto* flat = std::get_if<RigidPose2>(&pose)) {
    if (const auto turn = exact_matrix(flat->turn)) {
      const Vector2& c = turn->columns[1];
      return Ways{{0, size * turn->weight, 0}, {c.x * size, c.y * size, 0}};
    }
  }
  return {};
}

void expect_pair_laws(const Some& x, const Some& y, const AnyPose& pose, const Laws& laws, Material& m,
                      bool is_costly) {
  const Some p = x.under(pose), q = y.under(pose);
  const auto expect = [&](const char* question, const auto& ask) {
    laws.expect(
        question, [&] { return ask(x, y); }, [&] { return ask(p, q); });
    laws.expect(
        question, [&] { return ask(y, x); }, [&] { return ask(q, p); });
  };
  expect("relate", [](const Some& a, const Some& b) { return relate(a, b); });
  expect("intersects", [](const Some& a, const Some& b) { return intersects(a, b); });
  // Of two points it is asked under poses alone, as relate is.
  const bool are_points = x.kind() == FigureKind::point && y.kind() == FigureKind::point;
  if (!are_points) expect("contains", [](const Some& a, const Some& b) { return contains(a, b); });
  expect("distance", [](const Some& a, const Some& b) { return distance(a, b); });
  expect("exact_distance", [](const Some& a, const Some& b) { return exact_distance(a, b); });
  expect("compare_distance", [](const Some& a, const Some& b) { return compare_distance(a, b, 1.0); });
  expect("closest_points", [](const Some& a, const Some& b) { return closest_points(a, b); });
  expect("first_hit", [](const Some& a, const Some& b) { return first_hit(a, b); });
  expect("hits", [](const Some& a, const Some& b) { return hits(a, b); });
  if (!is_costly) expect("intersection", [](const Some& a, const Some& b) { return intersection(a, b); });
  expect("gjk_intersects", [](const Some& a, const Some& b) { return gjk_intersects(a, b); });
  expect("gjk_distance", [](const Some& a, const Some& b) { return gjk_distance(a, b); });
  expect("gjk", [](const Some& a, const Some& b) { return gjk(a, b).closest; });
  expect("penetration", [](const Some& a, const Some& b) { return penetration(a, b); });
  expect("contact", [](const Some& a, const Some& b) { return contact(a, b, {.margin = 4}); });
  const auto ways = ways_under(pose, m);
  if (!ways) return;
  const auto in_motion = [&](const char* question, const auto& ask) {
    laws.expect(
        question,
        [&] {
          return ask(Translating<Some>{x, ways->before}, y);
        },
        [&] {
          return ask(Translating<Some>{p, ways->after}, q);
        });
    laws.expect(
        question,
        [&] {
          return ask(y, Translating<Some>{x, ways->before});
        },
        [&] {
          return ask(q, Translating<Some>{p, ways->after});
        });
  };
  in_motion("first_contact", [](const auto& a, const auto& b) { return first_contact(a, b); });
  in_motion("intersects in motion", [](const auto& a, const auto& b) { return intersects(a, b); });
}

template <class All>
void expect_laws_of_all(std::uint64_t start) {
  std::map<std::string, std::array<int, 2>> seen;
  for (const PairRow& pair : pairs_of(All{})) {
    if (++start % 8 != 0 && battery::sanitized) continue;
    shape_cases::on_shapes(start, 1, [&](Material& m) {
      const bool is_plain = m.below(2) == 0;
      const AnyPair drawn = pair_of(pair, m);
      const AnyFigure a = is_plain ? figure(drawn.a.row(), m) : degenerate(drawn.a.row(), m);
      const AnyPose pose = pose_in(rigid_case(m), pair.dimension());
      Laws laws(pair.name() + about(m, a, drawn.b));
      laws.seen = &seen;
      const auto is_long = [](FigureKind k) {
        return query::is_one_of(k,
                                {FigureKind::k_dop, FigureKind::halfspace_intersection, FigureKind::convex_polyhedron});
      };
      expect_pair_laws(some(a), some(drawn.b), pose, laws, m, is_long(a.row().kind) && is_long(drawn.b.row().kind));
    });
  }
  for (const auto& [question, count] : seen) {
    std::printf("%s: %d answers, %d of them that there is none\n", question.c_str(), count[0], count[1]);
    if (!std::is_same_v<All, Space> || battery::sanitized) continue;
    EXPECT_GT(count[0] - count[1], 20) << question;
  }
}
TEST(AnyFigure, KeepsItsAnswersUnderACommonRigidPoseInThePlane) { expect_laws_of_all<Plane>(21'000); }
TEST(AnyFigure, KeepsItsAnswersUnderACommonRigidPoseInSpace) { expect_laws_of_all<Space>(22'000); }

}  // namespace
}  // namespace plumb::pair_cases
