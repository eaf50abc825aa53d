#include "lab/stability/share_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "lab/stability/picture_head.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/log_axis.hpp"

namespace plumb::lab::stability {
namespace {

constexpr double width = 960, left = 64, right = 24, top = 112, plot_height = 300, gap = 28, bottom = 62;
constexpr std::size_t series = 7;  // colors that chart_style has

class Curves {
 public:
  explicit Curves(std::span<const SharePanel> panels)
      : panels_(panels),
        panel_((width - left - right - gap * (static_cast<double>(panels.size()) - 1)) /
               static_cast<double>(panels.size())) {
    for (const SharePanel& panel : panels_) {
      for (const ShareCurve& curve : panel.curves) {
        if (std::ranges::find(labels_, curve.label) == labels_.end()) labels_.push_back(curve.label);
      }
    }
  }

  std::string draw(const std::string& title, const std::string& subtitle) {
    out_ = picture_head(width, top + plot_height + bottom, title, subtitle);
    legend();
    for (std::size_t i = 0; i < panels_.size(); ++i) panel(i);
    return out_ + "</svg>\n";
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(values)...);
  }

  static double height_of(double share) { return top + plot_height * (1 - share); }

  void marker(std::size_t i, double x, double y, const std::string& hint) {
    static constexpr std::array<std::string_view, series> shapes{"M-4 0A4 4 0 1 0 4 0A4 4 0 1 0-4 0",
                                                                 "M-3.6-3.6H3.6V3.6H-3.6Z",
                                                                 "M0-4.6L4.4 3.6H-4.4Z",
                                                                 "M0-4.8L4.8 0L0 4.8L-4.8 0Z",
                                                                 "M0 4.6L4.4-3.6H-4.4Z",
                                                                 "M-4.6-1.4H4.6V1.4H-4.6Z",
                                                                 "M-1.4-4.6H1.4V4.6H-1.4Z"};
    put("<path class=\"marker s{}\" transform=\"translate({:.1f} {:.1f})\" d=\"{}\">", i % series, x, y,
        shapes[i % series]);
    put("<title>{}</title></path>\n", escaped(hint));
  }

  void legend() {
    double x = left;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      marker(i, x + 5, 80, labels_[i]);
      put("<text x=\"{:.0f}\" y=\"84.5\" font-size=\"13\">{}</text>\n", x + 16, escaped(labels_[i]));
      x += 40 + 7.4 * static_cast<double>(labels_[i].size());
    }
  }

  void panel(std::size_t number) {
    const SharePanel& p = panels_[number];
    const double from = left + static_cast<double>(number) * (panel_ + gap), to = from + panel_;
    put("<text x=\"{:.1f}\" y=\"{:.0f}\" font-size=\"13\" font-weight=\"600\">{}</text>\n", from, top - 8,
        escaped(p.title));
    for (int percent = 0; percent <= 100; percent += 25) {
      const double y = height_of(percent / 100.0);
      put("<line class=\"grid\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", from, y, to, y);
      if (number == 0)
        put("<text class=\"muted\" font-size=\"12\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}%</text>\n",
            from - 8, y + 4, percent);
    }
    put("<text class=\"muted\" font-size=\"13\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
        (from + to) / 2, top + plot_height + 46, escaped(p.x_axis));
    double low = 1, high = 1;
    bool any = false;
    for (const ShareCurve& curve : p.curves) {
      for (const SharePoint& point : curve.points) {
        low = any ? std::min(low, point.x) : point.x;
        high = any ? std::max(high, point.x) : point.x;
        any = true;
      }
    }
    const LogAxis axis(low, high, LogAxis::Ends::padded, from, to);
    const auto ticks = axis.ticks();
    double last = from - 40;
    for (const Tick& t : ticks) {
      if (!t.labeled || t.at - last < 34) continue;
      last = t.at;
      put("<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1:.0f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\"/>\n", t.at, top,
          top + plot_height);
      put("<text class=\"muted\" font-size=\"12\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", t.at,
          top + plot_height + 22, tick_text(t, ticks));
    }
    for (const ShareCurve& curve : p.curves) draw_curve(curve, axis);
  }

  void draw_curve(const ShareCurve& curve, const LogAxis& axis) {
    const auto i = static_cast<std::size_t>(std::ranges::find(labels_, curve.label) - labels_.begin());
    // Colors are fills in chart_style: a line is a thin area.
    std::string path;
    for (std::size_t k = 1; k < curve.points.size(); ++k) {
      const double x = axis.at(curve.points[k - 1].x), y = height_of(curve.points[k - 1].share);
      const double u = axis.at(curve.points[k].x), v = height_of(curve.points[k].share);
      const double length = std::hypot(u - x, v - y), aside = (v - y) / length, up = (x - u) / length;
      path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z", x + aside, y + up, u + aside,
                          v + up, u - aside, v - up, x - aside, y - up);
    }
    put("<path class=\"s{}\" d=\"{}\"/>\n", i % series, path);
    for (const SharePoint& p : curve.points) {
      marker(i, axis.at(p.x), height_of(p.share),
             fmt::format("{}: {:.4g}% at {:.3g}", curve.label, 100 * p.share, p.x));
    }
  }

  std::span<const SharePanel> panels_;
  std::vector<std::string> labels_;
  double panel_;
  std::string out_;
};

}  // namespace

std::string share_curves(const std::string& title, const std::string& subtitle, std::span<const SharePanel> panels) {
  return Curves(panels).draw(title, subtitle);
}

}  // namespace plumb::lab::stability
