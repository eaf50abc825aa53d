#include "tool/drawing/data_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "tool/drawing/chart.hpp"

namespace plumb::tool {
namespace {

constexpr double paper = 960, edge = 24, plan_top = 130, below = 56;
constexpr double tallest = 720, flattest = 90;
constexpr double beyond = 8, strip_gap = 14;  // the plan's border: what is cut is cut there; strips begin there

/// Halved, so that no difference is beyond doubles; a part of the whole.
double part_of(double x, double min, double half_span) {
  return half_span > 0 ? std::clamp((x / 2 - min / 2) / half_span, -4.0, 4.0) : 0;
}

template <class... A>
void put(std::string& text, fmt::format_string<A...> form, A&&... values) {
  fmt::format_to(std::back_inserter(text), form, std::forward<A>(values)...);
}

}  // namespace

DataView::DataView(const std::string& title, std::string_view style, DataAxis right, DataAxis up, DataStrips strips)
    : right_(std::move(right)), up_(std::move(up)), strips_(strips), title_(escaped(title)), style_(style) {
  const double plan_width = paper - 2 * edge - strips_.left;
  const double wide = right_.max / 2 - right_.min / 2, high = up_.max / 2 - up_.min / 2;
  // In the less of both lengths: scaled up, the largest doubles would not fit.
  span_ = std::max(wide * (tallest / plan_width), high);
  height_ = std::clamp(tallest * (span_ > 0 ? high / span_ : 0), flattest, tallest);
}

// What is narrower than the paper stands in its middle, and so does what is flatter.
double DataView::right_of(double x) const {
  const double used = tallest * part_of(right_.max, right_.min, span_);
  const double plan_left = edge + strips_.left, plan_width = paper - edge - plan_left;
  return plan_left + tallest * part_of(x, right_.min, span_) + (plan_width - used) / 2;
}
double DataView::down_of(double y) const {
  const double used = tallest * part_of(up_.max, up_.min, span_);
  return plan_top + height_ - tallest * part_of(y, up_.min, span_) - (height_ - used) / 2;
}

void DataView::say(std::string_view text) {
  put(said_, "<text class=\"muted\" x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"13\">{}</text>\n", edge, next_line_,
      escaped(text));
  next_line_ += 20;
}

void DataView::explain(std::string_view kind, std::string_view text) {
  constexpr double letter = 7.2, y = plan_top - 22;
  put(legend_,
      "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"13\" height=\"11\" stroke-width=\"1\"/>\n"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\">{}</text>\n",
      kind, next_legend_, y - 10, next_legend_ + 19, y, escaped(text));
  next_legend_ += 44 + letter * static_cast<double>(text.size());
}

void DataView::begin_group(std::string_view id, double stroke_width) {
  put(body_, "<g id=\"{}\" stroke-width=\"{}\">\n", id, stroke_width);
}
void DataView::begin_cut_group(std::string_view id, double stroke_width) {
  put(body_, "<g id=\"{}\" stroke-width=\"{}\" clip-path=\"url(#plan)\">\n", id, stroke_width);
}
void DataView::end_group() { body_ += "</g>\n"; }

void DataView::rectangle(std::string_view kind, std::array<double, 2> from, std::array<double, 2> to) {
  put_rectangle(kind, right_of(from[0]), down_of(to[1]), right_of(to[0]), down_of(from[1]));
}

void DataView::put_rectangle(std::string_view kind, double left, double top, double right, double bottom) {
  put(body_, "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", kind, left, top,
      std::max(right - left, 1.0), std::max(bottom - top, 1.0));
}

void DataView::bar_below(std::string_view kind, std::array<double, 2> along, std::array<double, 2> across) {
  const double top = plan_top + height_ + strip_gap, high = strips_.below - strip_gap;
  put_rectangle(kind, right_of(along[0]), top + high * across[0], right_of(along[1]), top + high * across[1]);
}

void DataView::bar_left(std::string_view kind, std::array<double, 2> along, std::array<double, 2> across) {
  const double right = right_of(right_.min) - strip_gap, wide = strips_.left - strip_gap;
  put_rectangle(kind, right - wide * across[1], down_of(along[1]), right - wide * across[0], down_of(along[0]));
}

void DataView::line(std::string_view kind, std::array<double, 2> from, std::array<double, 2> to) {
  put(body_, "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", kind, right_of(from[0]),
      down_of(from[1]), right_of(to[0]), down_of(to[1]));
}

void DataView::dot(std::string_view kind, std::array<double, 2> at, double pixels) {
  put(body_, "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", kind, right_of(at[0]), down_of(at[1]),
      pixels);
}

void DataView::circle(std::string_view kind, std::array<double, 2> center, double radius) {
  put(body_, "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", kind, right_of(center[0]),
      down_of(center[1]), tallest * part_of(radius, 0, span_));
}

std::string DataView::text() const {
  const double bottom = plan_top + height_ + strips_.below, all = bottom + below;
  std::string text;
  put(text,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "role=\"img\">\n<title>{2}</title>\n",
      paper, all, title_);
  text += chart_style;
  put(text, "<style>\n{}</style>\n<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", style_, paper, all);
  put(text, "<text x=\"{:.0f}\" y=\"36\" font-size=\"19\" font-weight=\"600\">{}</text>\n", edge, title_);
  if (body_.find("url(#plan)") != std::string::npos) {
    const double left = right_of(right_.min) - beyond, top = down_of(up_.max) - beyond;
    put(text, "<clipPath id=\"plan\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n",
        left, top, right_of(right_.max) + beyond - left, down_of(up_.min) + beyond - top);
  }
  text += said_ + legend_ + body_;
  put(text,
      "<text class=\"muted\" x=\"{:.0f}\" y=\"{:.1f}\" font-size=\"12\">{} to the right, from {:.6g} to {:.6g}; {} up, "
      "from {:.6g} to {:.6g}</text>\n",
      edge, bottom + 34, right_.name, right_.min, right_.max, up_.name, up_.min, up_.max);
  return text + "</svg>\n";
}

}  // namespace plumb::tool
