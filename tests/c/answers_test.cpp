// The C interface answers as C++ does, bit by bit: every kind of figure, as numbers in the union and by its line, posed
// or not; every predicate of the manifest.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "certify/catalog.hpp"
#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/plumb.h"
#include "plumb/query/certificate/certificate_text.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/variant/all_kinds.hpp"

namespace plumb::pair_cases {
namespace {

using plumb::AnyFigure;

struct Kept {
  plumb_kept* handle = nullptr;
  ~Kept() { plumb_kept_destroy(handle); }
};

plumb_figure empty_figure() {
  plumb_figure f{};
  f.size = sizeof f;
  return f;
}

/// The figure by its line.
plumb_figure by_line(const AnyFigure& any, Kept& kept) {
  EXPECT_EQ(plumb_kept_parse(to_string(any).c_str(), &kept.handle), PLUMB_OK) << plumb_last_error();
  plumb_figure f = empty_figure();
  f.kept = kept.handle;
  return f;
}

/// The figure in the union; nothing of what has lists.
std::optional<plumb_figure> by_numbers(const AnyFigure& any) {
  plumb_figure f = empty_figure();
  f.kind = static_cast<std::int32_t>(any.kind()) + 1;
  f.dimension = any.dimension();
  const bool is_flat = visit(
      [&]<class Shape>(const Shape& shape) {
        if constexpr (std::is_trivially_copyable_v<Shape>) std::memcpy(&f.as, &shape, sizeof shape);
        return std::is_trivially_copyable_v<Shape>;
      },
      any);
  const bool is_posed = std::visit(
      [&]<class Pose>(const Pose& pose) {
        if constexpr (std::is_same_v<Pose, RigidPose> || std::is_same_v<Pose, RigidPose2>) {
          f.pose_kind = PLUMB_RIGID;
        } else if constexpr (std::is_same_v<Pose, plumb::Pose> || std::is_same_v<Pose, Pose2>) {
          f.pose_kind = PLUMB_MATRIX;
        } else {
          return std::is_same_v<Pose, std::monostate>;
        }
        std::memcpy(&f.pose, &pose, sizeof pose);
        return true;
      },
      any.pose());
  if (!is_flat || !is_posed) return {};
  return f;
}

struct Seen {
  int answers = 0, refused = 0, by_numbers = 0, texts = 0;
};

/// What `ask` answers is `answer()`, or its error.
template <class Answer, class Ask>
void expect_as(const Answer& answer, const Ask& ask, Seen& seen) {
  using Number = std::decay_t<decltype(answer())>;
  std::optional<Number> expected;
  try {
    expected = answer();
  } catch (const Error&) {
    ++seen.refused;
  }
  Number told{};
  const plumb_status status = ask(told);
  ASSERT_EQ(status == PLUMB_OK, expected.has_value()) << plumb_last_error();
  if (!expected) {
    EXPECT_NE(std::string(plumb_last_error()), "");
    return;
  }
  ++seen.answers;
  EXPECT_EQ(std::memcmp(&told, &*expected, sizeof told), 0);
}

/// The same of texts.
template <class Answer, class Ask>
void expect_text_as(const Answer& answer, const Ask& ask, Seen& seen) {
  std::optional<std::string> expected;
  try {
    expected = answer();
  } catch (const Error&) {
    ++seen.refused;
  }
  std::vector<char> told(1 << 16, '?');
  std::size_t length = 0;
  const plumb_status status = ask(told.data(), told.size(), &length);
  ASSERT_EQ(status == PLUMB_OK, expected.has_value()) << plumb_last_error();
  if (!expected) {
    EXPECT_EQ(told[0], '?');
    return;
  }
  ++seen.texts;
  EXPECT_EQ(std::string(told.data()), *expected);
  EXPECT_EQ(length, expected->size());
}

/// Whatever is exact, and whatever proves it.
void expect_exact_answers(const AnyFigure& a, const AnyFigure& b, const plumb_figure& x, const plumb_figure& y,
                          Seen& seen) {
  SCOPED_TRACE(to_string(a) + "; " + to_string(b));
  expect_text_as(
      [&] {
        const ExactDistance d = exact_distance(a, b);
        return d.square.text() + " " + d.inset.text();
      },
      [&](char* text, std::size_t capacity, std::size_t* length) {
        return plumb_exact_distance(&x, &y, text, capacity, length);
      },
      seen);
  expect_text_as([&] { return squared_distance_exact(a, b).text(); },
                 [&](char* text, std::size_t capacity, std::size_t* length) {
                   return plumb_squared_distance(&x, &y, text, capacity, length);
                 },
                 seen);
  expect_text_as([&] { return certificate_text(relate_with_proof(a, b), a, b); },
                 [&](char* text, std::size_t capacity, std::size_t* length) {
                   return plumb_prove(PLUMB_CLAIM_RELATION, &x, &y, text, capacity, length);
                 },
                 seen);
  expect_as([&] { return static_cast<int>(compare_distance(a, b, b, b)); },
            [&](int& told) { return plumb_compare_distance(&x, &y, &y, &y, &told); }, seen);
}

void expect_answers(const AnyFigure& a, const AnyFigure& b, const plumb_figure& x, const plumb_figure& y, Seen& seen) {
  SCOPED_TRACE(to_string(a) + "; " + to_string(b));
  expect_as([&] { return static_cast<int>(relate(a, b)); },
            [&](int& told) {
              plumb_relation r{};
              const plumb_status status = plumb_relate(&x, &y, &r);
              told = r;
              return status;
            },
            seen);
  expect_as([&] { return static_cast<int>(intersects(a, b)); },
            [&](int& told) { return plumb_intersects(&x, &y, &told); }, seen);
  expect_as([&] { return static_cast<int>(contains(a, b)); }, [&](int& told) { return plumb_contains(&x, &y, &told); },
            seen);
  expect_as([&] { return distance(a, b); }, [&](double& told) { return plumb_distance(&x, &y, &told); }, seen);
  expect_as([&] { return closest_points(a, b).on_b; },
            [&](Point3& told) {
              plumb_closest c{};
              c.size = sizeof c;
              const plumb_status status = plumb_closest_points(&x, &y, &c);
              std::memcpy(&told, c.on_b, sizeof told);
              return status;
            },
            seen);
  expect_as(
      [&] {
        const auto hit = first_hit(a, b);
        return hit ? hit->t : -1.0;
      },
      [&](double& told) {
        plumb_hit h{};
        h.size = sizeof h;
        int found = 0;
        const plumb_status status = plumb_first_hit(&x, &y, &found, &h);
        told = found != 0 ? h.t : -1.0;
        return status;
      },
      seen);
}

TEST(CInterface, AnswersAsTheLibraryDoes) {
  Seen seen;
  const int rounds = battery::sanitized ? 1 : 2;
  for (int round = 0; round < rounds; ++round) {
    Material m(97, static_cast<std::uint64_t>(round));
    std::vector<AnyFigure> all = all_kinds(m);
    for (std::size_t i = 0; i < all.size(); ++i) {  // every fourth one moved exactly, every fourth one sheared
      const bool plane = all[i].dimension() == 2;
      const auto turn = [&m] { return static_cast<double>(m.below(9)) - 4; };
      if ((i + static_cast<std::size_t>(round)) % 4 == 1) {
        all[i] =
            all[i].under(plane ? AnyPose(RigidPose2{{1 + turn() / 8, turn()}, {turn(), turn()}})
                               : AnyPose(RigidPose{{1 + turn() / 8, turn(), turn(), turn()}, {turn(), 0, turn()}}));
      } else if ((i + static_cast<std::size_t>(round)) % 4 == 2) {
        all[i] = all[i].under(plane ? AnyPose(Pose2{{{{1, 1}, {0, 2}}}, {turn(), turn()}})
                                    : AnyPose(Pose{{{{1, 0, 1}, {0, 2, 0}, {1, 1, 0}}}, {turn(), turn(), 0}}));
      }
    }
    for (const AnyFigure& a : all) {
      Kept kept_a;
      const plumb_figure x = by_line(a, kept_a);
      for (const AnyFigure& b : all) {
        if (a.dimension() != b.dimension()) continue;
        Kept kept_b;
        expect_answers(a, b, x, by_line(b, kept_b), seen);
        const auto numbers_a = by_numbers(a), numbers_b = by_numbers(b);
        if (!numbers_a || !numbers_b) continue;
        expect_answers(a, b, *numbers_a, *numbers_b, seen);
        expect_exact_answers(a, b, *numbers_a, *numbers_b, seen);
        ++seen.by_numbers;
      }
    }
  }
  EXPECT_GT(seen.answers, 1500 * rounds);
  EXPECT_GT(seen.refused, 500 * rounds);
  EXPECT_GT(seen.by_numbers, 300 * rounds);
  EXPECT_GT(seen.texts, 300 * rounds);
}

TEST(CInterface, HasEveryPredicate) {
  ASSERT_EQ(plumb_sign_count(), catalog().size());
  for (std::size_t i = 0; i < catalog().size(); ++i) {
    const CatalogEntry& entry = catalog()[i];
    EXPECT_EQ(plumb_sign_name(i), entry.name);
    EXPECT_EQ(plumb_find_sign(plumb_sign_name(i)), i);
    ASSERT_EQ(plumb_sign_arity(i), entry.arity());
    Entropy e(98, i);
    constexpr std::size_t cases = 50;
    std::vector<double> rows(cases * entry.arity());
    for (double& x : rows) x = static_cast<double>(e.below(5)) - 2;
    std::vector<const double*> columns(entry.arity());
    const std::vector<std::ptrdiff_t> strides(entry.arity(), static_cast<std::ptrdiff_t>(entry.arity()));
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = rows.data() + k;
    std::vector<std::int8_t> signs(cases, 7);
    ASSERT_EQ(plumb_signs(i, columns.data(), strides.data(), cases, signs.data()), PLUMB_OK) << plumb_last_error();
    for (std::size_t c = 0; c < cases; ++c) {
      const std::span<const double> row(rows.data() + c * entry.arity(), entry.arity());
      const int expected = static_cast<int>(entry.decide(row).sign);
      int sign = 7;
      ASSERT_EQ(plumb_sign(i, row.data(), &sign), PLUMB_OK);
      EXPECT_EQ(sign, expected) << entry.name << " case " << c;
      EXPECT_EQ(signs[c], expected) << entry.name << " case " << c;
    }
    std::vector<std::vector<double>> apart(entry.arity());
    std::vector<const double*> without_gaps;
    for (std::size_t k = 0; k < apart.size(); ++k) {
      for (std::size_t c = 0; c < cases; ++c) apart[k].push_back(rows[c * entry.arity() + k]);
      without_gaps.push_back(apart[k].data());
    }
    std::vector<std::int8_t> same(cases, 7);
    ASSERT_EQ(plumb_signs(i, without_gaps.data(), nullptr, cases, same.data()), PLUMB_OK) << plumb_last_error();
    EXPECT_EQ(same, signs) << entry.name;
    apart[0][7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(plumb_signs(i, without_gaps.data(), nullptr, cases, same.data()), PLUMB_NON_FINITE);
    EXPECT_NE(std::string(plumb_last_error()).find("case 7"), std::string::npos) << plumb_last_error();
    EXPECT_EQ(same, signs) << entry.name;
    rows[7 * entry.arity()] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(plumb_signs(i, columns.data(), strides.data(), cases, signs.data()), PLUMB_NON_FINITE);
    EXPECT_NE(std::string(plumb_last_error()).find("case 7"), std::string::npos) << plumb_last_error();
  }
}

TEST(CInterface, BatchesTellWhichPairFails) {
  std::vector<plumb_figure> balls(300, empty_figure());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls[i].kind = PLUMB_BALL;
    balls[i].dimension = 3;
    balls[i].as.sphere3 = {{static_cast<double>(i), 0, 0}, 1};
  }
  std::vector<plumb_figure> first(balls.size(), balls[0]);
  std::vector<double> distances(balls.size(), -7);
  std::vector<std::int8_t> relations(balls.size(), 7);
  ASSERT_EQ(plumb_distance_each(first.data(), balls.data(), balls.size(), distances.data()), PLUMB_OK);
  ASSERT_EQ(plumb_relate_each(first.data(), balls.data(), balls.size(), relations.data()), PLUMB_OK);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_EQ(distances[i], std::max(0.0, static_cast<double>(i) - 2));
    EXPECT_EQ(relations[i], i < 2 ? PLUMB_OVERLAPPING : i == 2 ? PLUMB_TOUCHING : PLUMB_DISJOINT);
  }
  balls[217].as.sphere3.radius = -1;
  balls[290].size = 0;
  relations.assign(balls.size(), 7);
  EXPECT_EQ(plumb_relate_each(first.data(), balls.data(), balls.size(), relations.data()), PLUMB_INVALID_SHAPE);
  EXPECT_NE(std::string(plumb_last_error()).find("pair 217"), std::string::npos) << plumb_last_error();
  EXPECT_EQ(std::ranges::count(relations, 7), 300);
}

}  // namespace
}  // namespace plumb::pair_cases
