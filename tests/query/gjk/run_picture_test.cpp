// The picture of a run in docs/convex.md is what the history says; with PLUMB_WRITE_PICTURES set, this test writes it.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "degenerate/picture.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/query/gjk/gjk.hpp"

namespace plumb {
namespace {

using plumb_test::Dot, plumb_test::Panel, plumb_test::Picture;

constexpr double size = 180, margin = 12, words_height = 18;
constexpr std::string_view red = "#c03020";

Polygon3 flat(const std::vector<Point2>& corners) {
  Polygon3 p;
  for (const Point2& c : corners) p.vertices.push_back({c.x, c.y, 0});
  return p;
}

/// Two polygons of the plane, so that their difference is one.
std::string drawn() {
  const std::vector<Point2> a{{0, 0}, {4, -1}, {6, 1}, {5, 4}, {2, 5}, {-1, 3}},
      b{{-5, 3.5}, {-3, 2.5}, {-0.9, 4.6}, {-2, 7}, {-5, 6}};
  std::vector<GjkStep> history;
  const Polygon3 first = flat(a), second = flat(b);
  GjkCache start{{{{{2, 0}}}, 1}, {}};
  const GjkAnswer answer = gjk(first, second, {.cache = &start, .history = &history});
  EXPECT_FALSE(answer.meets);
  EXPECT_GE(history.size(), 3U);
  std::vector<Point2> differences;
  std::vector<Dot> dots{{0, 0}};
  for (const Point2& p : a) {
    for (const Point2& q : b) differences.push_back({p.x - q.x, p.y - q.y}), dots.push_back({p.x - q.x, p.y - q.y});
  }
  const std::vector<std::uint32_t> outline = convex_hull(differences).vertices;
  const auto panels = static_cast<int>(history.size());
  Picture picture(static_cast<int>(size + 2 * margin) * panels, static_cast<int>(size + 2 * margin + words_height));
  for (int i = 0; i < panels; ++i) {
    const GjkStep& step = history[static_cast<std::size_t>(i)];
    const Panel panel = Panel::around(dots, margin + (size + 2 * margin) * i, margin, size);
    const auto at = [&](const Point2& p) { return panel.at({p.x, p.y}); };
    for (std::size_t k = 0; k < outline.size(); ++k) {
      picture.line(at(differences[outline[k]]), at(differences[outline[(k + 1) % outline.size()]]));
    }
    std::vector<Point2> corners;
    for (std::uint32_t k = 0; k < step.simplex.size; ++k) {
      const auto [p, q] = step.simplex.corners[k];
      corners.push_back({a[p].x - b[q].x, a[p].y - b[q].y});
    }
    for (std::size_t k = 1; k < corners.size(); ++k) picture.line(at(corners[k - 1]), at(corners[k]), red);
    for (const Point2& p : corners) picture.dot(at(p), 2.5, red);
    picture.line(panel.at({0, 0}), panel.at({step.direction.x, step.direction.y}));
    picture.dot(panel.at({0, 0}));
    std::array<char, 64> words{};
    std::snprintf(words.data(), words.size(), "%d: square %.4g", i + 1, step.square);
    picture.words({panel.left, size + 2 * margin + words_height / 2}, words.data());
  }
  return picture.text();
}

TEST(GjkRun, IsAsItsPictureShows) {
  const std::string path = std::string(PLUMB_SOURCE_DIR) + "/docs/gjk_run.svg", picture = drawn();
  if (std::getenv("PLUMB_WRITE_PICTURES") != nullptr) std::ofstream(path, std::ios::binary) << picture;
  std::ifstream in(path, std::ios::binary);
  const std::string kept{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  EXPECT_EQ(kept, picture) << "run this test with PLUMB_WRITE_PICTURES=1 to draw " << path << " anew";
}

}  // namespace
}  // namespace plumb
