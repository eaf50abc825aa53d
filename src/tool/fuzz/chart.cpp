// A bar a generator: wrong answers, and behind them what did not answer at all.
#include "tool/drawing/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "tool/drawing/log_axis.hpp"
#include "tool/fuzz/report.hpp"

namespace plumb::tool {
namespace {

using degenerate::Tally;

class Bars {
  static constexpr double kWidth = 860, kRight = 190, kTop = 112, kRow = 34, kBottom = 64, kLetter = 8.2, kZero = 44;

 public:
  explicit Bars(const FuzzReport& report) : report_(report), tallies_(report.run.findings.tallies) {
    std::size_t longest = 9;
    double least = 0.1;  // so that there is a decade to see
    for (const Tally& t : tallies_) {
      longest = std::max(longest, t.generator.size());
      for (const std::uint64_t bad : {t.wrong, t.failed}) {
        if (bad > 0) least = std::min(least, share(t, bad));
      }
    }
    left_ = 40 + kLetter * static_cast<double>(longest);
    axis_.emplace(least, 1.0, LogAxis::Ends::whole_decades, left_ + kZero, kWidth - kRight);
    bottom_ = kTop + kRow * static_cast<double>(tallies_.size());
  }

  std::string draw() {
    const double height = bottom_ + kBottom;
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
        kWidth, height, title());
    out_ += chart_style;
    put("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", kWidth, height);
    put("<text x=\"24\" y=\"36\" font-size=\"19\" font-weight=\"600\">{}</text>\n", title());
    put("<text class=\"muted\" x=\"24\" y=\"58\" font-size=\"13\">{} cases, seed {}: share of failures by generator"
        "</text>\n",
        report_.run.findings.asked(), report_.options.seed);
    legend();
    for (std::size_t row = 0; row < tallies_.size(); row += 2) {
      put("<rect class=\"band\" x=\"24\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\"/>\n", top_of(row), kWidth - 48,
          kRow);
    }
    grid();
    for (std::size_t row = 0; row < tallies_.size(); ++row) draw_row(row);
    put("<text class=\"muted\" x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" text-anchor=\"middle\">share of "
        "cases</text>\n",
        (left_ + kWidth - kRight) / 2, bottom_ + 46);
    return out_ + "</svg>\n";
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(values)...);
  }

  [[nodiscard]] std::string title() const {
    return escaped(fmt::format("{} on {}", printable(report_.options.symbol), report_.kind.name));
  }
  static double top_of(std::size_t row) { return kTop + kRow * static_cast<double>(row); }
  static double share(const Tally& t, std::uint64_t bad) {
    return static_cast<double>(bad) / static_cast<double>(std::max<std::uint64_t>(t.asked, 1));
  }

  void legend() {
    if (std::ranges::all_of(tallies_, [](const Tally& t) { return t.failed == 0; })) return;
    put("<rect class=\"s1\" x=\"24\" y=\"74\" width=\"14\" height=\"10\"/><text x=\"44\" y=\"84\" "
        "font-size=\"13\">wrong "
        "answer</text>\n");
    put("<rect class=\"s5\" x=\"150\" y=\"74\" width=\"14\" height=\"10\"/><text x=\"170\" y=\"84\" "
        "font-size=\"13\">crashed, hung, exited or threw</text>\n");
  }

  void vertical(double x, const std::string& label) {
    put("<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1:.0f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\"/>\n", x, kTop, bottom_);
    put("<text class=\"muted\" font-size=\"12\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
        bottom_ + 20, label);
  }

  void grid() {
    vertical(left_, "0");
    const std::vector<Tick> ticks = axis_->ticks();
    for (const Tick& t : ticks) {
      if (t.labeled) vertical(t.at, tick_text(t, ticks));
    }
  }

  /// From zero, which the axis does not have, to the share.
  void bar(std::string_view color, const Tally& t, std::uint64_t bad, double y, double height) {
    if (bad == 0) return;
    put("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", color, left_, y,
        std::max(axis_->at(share(t, bad)) - left_, 2.0), height);
  }

  void draw_row(std::size_t row) {
    const Tally& t = tallies_[row];
    const double y = top_of(row);
    put("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"14\" text-anchor=\"end\">{}</text>\n", left_ - 10, y + 22,
        escaped(t.generator));
    const bool both = t.wrong > 0 && t.failed > 0;
    bar("s1", t, t.wrong, y + 6, both ? 10 : 22);
    bar("s5", t, t.failed, y + (both ? 18 : 6), both ? 10 : 22);
    const std::string parts = both           ? fmt::format("{} wrong, {} failed of {}", t.wrong, t.failed, t.asked)
                              : t.failed > 0 ? fmt::format("{} failed of {}", t.failed, t.asked)
                                             : fmt::format("{} of {}", t.wrong, t.asked);
    put("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\">{}</text>\n", kWidth - kRight + 12, y + 21,
        parts);
  }

  const FuzzReport& report_;
  const std::vector<Tally>& tallies_;
  double left_ = 0, bottom_ = 0;
  std::optional<LogAxis> axis_;
  std::string out_;
};

}  // namespace

std::string fuzz_chart(const FuzzReport& report) { return Bars(report).draw(); }

}  // namespace plumb::tool
