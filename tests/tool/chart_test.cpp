// The chart: well-formed whatever it is given, no label on another label or a marker, order on the page as in value.
#include "tool/drawing/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/arith/error.hpp"
#include "tool/drawing/log_axis.hpp"

namespace plumb::tool {
namespace {

using Points = std::vector<ChartPoint>;

const Points kMethods{{"float32", 2.1, 0.38}, {"double", 2.3, 0.11},       {"double, absolute", 2.5, 0.04},
                      {"exact", 6.4, 0},      {"interval only", 31, 2e-5}, {"long double", 9.8, 0.006}};

/// Empty where the text is well-formed XML (elements, attributes, the five entities), else what is wrong with it.
std::string fault_in_xml(std::string_view text) {
  std::vector<std::string> open;
  bool had_root = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '&') {
      const std::string_view rest = text.substr(i);
      const bool known = rest.starts_with("&amp;") || rest.starts_with("&lt;") || rest.starts_with("&gt;") ||
                         rest.starts_with("&quot;") || rest.starts_with("&apos;");
      if (!known) return "bare ampersand";
    }
    if (static_cast<unsigned char>(text[i]) < 0x20 && text[i] != '\n') return "control character";
    if (text[i] != '<') {
      if (open.empty() && text[i] != '\n') return "text outside the root";
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    bool quoted = false;
    for (; end < text.size() && (quoted || text[end] != '>'); ++end) {
      if (text[end] == '"') quoted = !quoted;
      if (text[end] == '<') return "'<' within a tag";
    }
    if (end == text.size()) return "unclosed tag";
    const std::string_view tag = text.substr(i + 1, end - i - 1);
    i = end + 1;
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1)) return "mismatched end " + std::string(tag);
      open.pop_back();
    } else {
      if (open.empty() && std::exchange(had_root, true)) return "second root";
      if (!tag.ends_with('/')) open.emplace_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty() && had_root ? "" : "unclosed element";
}

void expect_sound_layout(const Points& points) {
  const ChartLayout layout = lay_out_chart(points);
  ASSERT_EQ(layout.labels.size(), points.size());
  ASSERT_EQ(layout.markers.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Box box = layout.labels[i].box;
    EXPECT_TRUE(layout.plot.contains(box)) << points[i].label;
    EXPECT_TRUE(layout.plot.contains(layout.markers[i])) << points[i].label;
    for (std::size_t j = 0; j < points.size(); ++j) {
      EXPECT_FALSE(box.overlaps(layout.markers[j])) << points[i].label << " covers " << points[j].label;
      if (j != i) {
        EXPECT_FALSE(box.overlaps(layout.labels[j].box)) << points[i].label << " on " << points[j].label;
      }
    }
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (points[i].x < points[j].x) {
        EXPECT_LE(layout.markers[i].left, layout.markers[j].left);
      }
      if (points[i].x == points[j].x) {
        EXPECT_EQ(layout.markers[i].left, layout.markers[j].left);
      }
      if (points[i].y < points[j].y) {
        EXPECT_GE(layout.markers[i].top, layout.markers[j].top);
      }
      if (points[i].y == 0 && points[j].y > 0) {
        EXPECT_GT(layout.markers[i].top, layout.break_at);
        EXPECT_LE(layout.markers[j].bottom, layout.break_at);
      }
    }
  }
}

TEST(Chart, PlacesOrdinaryPointsBesideTheirMarkers) {
  expect_sound_layout(kMethods);
  const ChartLayout layout = lay_out_chart(kMethods);
  EXPECT_EQ(layout.width, 840);
  EXPECT_EQ(layout.height, 520);
  for (const LabelPlace& p : layout.labels) EXPECT_FALSE(p.leader);
  EXPECT_LT(layout.markers[0].left + 1, layout.markers[1].left);  // strictly apart, not only in order
  EXPECT_LT(layout.markers[0].top + 1, layout.markers[1].top);
}

TEST(Chart, PlacesHardCases) {
  expect_sound_layout({});
  expect_sound_layout({{"exact", 12, 1e-3}});
  expect_sound_layout({{"a", 2, 0}, {"b", 2, 0}, {"c", 2, 0}, {"d", 2, 0}, {"e", 2, 0}, {"f", 2, 0}});
  expect_sound_layout({{"tiny", 1e-300, 5e-324}, {"huge", 1e300, 1}, {"zero", 1, 0}});
  expect_sound_layout({{"left", 0.01, 1}, {std::string(300, 'W'), 1000, 1e-5}, {"low", 10, 1e-5}});
  expect_sound_layout({{"largest", std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}});
}

TEST(Chart, GrowsWhereLabelsHaveNoRoom) {
  Points crowd;
  for (int i = 0; i < 70; ++i) crowd.push_back({"method number " + std::to_string(i), 10 + i * 0.01, 0.1});
  expect_sound_layout(crowd);
  EXPECT_GT(lay_out_chart(crowd).height, 520);
}

TEST(Chart, PlacesRandomCrowds) {
  std::mt19937_64 random(7);
  int led = 0;
  for (int round = 0; round < 60; ++round) {
    Points points;
    const auto within = [&](double high) { return static_cast<double>(random() >> 11) * 0x1p-53 * high; };
    for (int i = 0; i < 14; ++i) {
      const double y = i % 4 == 0 ? 0 : 0.05 + within(round % 2 == 0 ? 0.01 : 0.9);
      points.push_back({std::string(3 + random() % 20, 'n'), 1 + within(round % 3 == 0 ? 0.2 : 300), y});
    }
    expect_sound_layout(points);
    for (const LabelPlace& p : lay_out_chart(points).labels) led += p.leader;
  }
  EXPECT_GT(led, 60);  // the cases were crowded enough to push labels away
}

TEST(Chart, IsWellFormedWhateverTheLabelsHold) {
  const ChartText text{"<&> \"title\"", "sub\ttitle ]]> \x01", "x < y & z", "y > 'x'"};
  for (const Points& points :
       {Points{}, kMethods, Points{{"</text><script>", 1, 0}, {"a&b;\x02\n", 1, 1}, {std::string(200, '&'), 3, 1}},
        Points{{"é…漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字漢字", 1, 0.5}}}) {
    const std::string svg = scatter_chart(text, points);
    EXPECT_EQ(fault_in_xml(svg), "") << svg;
    EXPECT_THAT(svg, testing::Not(testing::HasSubstr("<script")));
    EXPECT_THAT(svg, testing::Not(testing::HasSubstr("nan")));
  }
  EXPECT_NE(fault_in_xml("<a><b></a>"), "");
  EXPECT_NE(fault_in_xml("<a>&x</a>"), "");
}

TEST(Chart, ShowsEveryNameTheBandOfZerosAndDarkColors) {
  const std::string svg = scatter_chart({"Title", "sub", "ns", "share"}, kMethods);
  for (const ChartPoint& p : kMethods) EXPECT_THAT(svg, testing::HasSubstr(">" + p.label + "</text>"));
  EXPECT_THAT(svg, testing::HasSubstr("class=\"band\""));
  EXPECT_THAT(svg, testing::HasSubstr(">0</text>"));
  EXPECT_THAT(svg, testing::HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(scatter_chart({}, Points{{"a", 1, 1}}), testing::Not(testing::HasSubstr("class=\"band\"")));
  EXPECT_EQ(svg, scatter_chart({"Title", "sub", "ns", "share"}, kMethods));
}

TEST(Chart, DrawsALineUpToTheMostOfAPoint) {
  const Points points{
      {"none", 1, 8, true, "", "", 8}, {"zero", 2, 0, true, "z", "", 0.25}, {"some", 3, 2, true, "s", "", 4e9}};
  const std::string svg = scatter_chart({"Title", "sub", "ns", "ulps"}, points);
  EXPECT_EQ(fault_in_xml(svg), "");
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("class=\"whisker\" d=")));  // of the first there is none
  expect_sound_layout(points);
  const ChartLayout layout = lay_out_chart(points);
  std::vector<double> tops;
  for (const char* key : {"z", "s"}) {
    const std::string begin = "<path class=\"whisker\" data-key=\"" + std::string(key) + "\" d=\"M";
    const std::size_t at = svg.find(begin);
    ASSERT_NE(at, std::string::npos) << key;
    tops.push_back(std::stod(svg.substr(svg.find('V', at) + 1)));
  }
  // The one of 0 crosses the break, and ends below what is at 2; the other ends above all of them.
  EXPECT_LT(tops[0], layout.break_at);
  EXPECT_GT(tops[0], layout.markers[2].bottom);
  EXPECT_LT(tops[1], layout.markers[0].top);
  EXPECT_GE(tops[1], layout.plot.top);
}

TEST(Chart, RefusesPointsWithoutAPlace) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const ChartPoint& p : {ChartPoint{"bad", 0, 1},
                              {"bad", -1, 1},
                              {"bad", infinity, 1},
                              {"bad", nan, 1},
                              {"bad", 1, -1e-300},
                              {"bad", 1, infinity},
                              {"bad", 1, nan},
                              {"bad", 1, 1, true, "", "", -1},
                              {"bad", 1, 1, true, "", "", infinity}}) {
    EXPECT_THROW(scatter_chart({}, Points{p}), Error) << p.x << ' ' << p.y;
  }
}

TEST(LogAxis, LabelsTwoToThirteenTicksWithinItsEnds) {
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{
           {1, 1}, {2, 3}, {0.9, 11}, {1e-3, 1e3}, {1e-12, 1}, {5e-324, 1.7e308}, {99, 101}, {1, 1e13}}) {
    for (const auto ends : {LogAxis::Ends::whole_decades, LogAxis::Ends::padded}) {
      const LogAxis axis(low, high, ends, 400, 100);
      EXPECT_LE(axis.at(low), 400);
      EXPECT_GE(axis.at(high), 100);
      int labeled = 0;
      for (const Tick& t : axis.ticks()) {
        labeled += t.labeled;
        EXPECT_GE(t.at, 100 - 1e-9);
        EXPECT_LE(t.at, 400 + 1e-9);
      }
      EXPECT_GE(labeled, 2) << low << ' ' << high;
      EXPECT_LE(labeled, 13) << low << ' ' << high;
    }
  }
}

TEST(LogAxis, WritesTicksPlainlyWhereTheyAreShort) {
  const Tick hundredth{0, 1, -2, true}, half{0, 5, -1, true}, fifty{0, 5, 1, true}, tiny{0, 1, -7, true},
      one{0, 1, 0, true};
  EXPECT_EQ(tick_text(hundredth, {hundredth, one}), "0.01");
  EXPECT_EQ(tick_text(half, {half, one}), "0.5");
  EXPECT_EQ(tick_text(fifty, {fifty, one}), "50");
  EXPECT_EQ(tick_text(one, {tiny, one}), "1");
  EXPECT_EQ(tick_text(tiny, {tiny, one}), "10<tspan dy=\"-5\" font-size=\"9\">−7</tspan>");
}

}  // namespace
}  // namespace plumb::tool
