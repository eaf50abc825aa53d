// The spectrum of bounding volumes: from loose and cheap to tight and dear, measured.
#include "tool/drawing/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "tool/bounds/command.hpp"
#include "tool/drawing/log_axis.hpp"

namespace plumb::tool {
namespace {

constexpr double kWidth = 960, kLeft = 96, kRight = 24, kTop = 118, kRow = 46, kGap = 30, kBottom = 52;
constexpr double kPanel = (kWidth - kLeft - kRight - 2 * kGap) / 3;

class Spectrum {
 public:
  explicit Spectrum(std::span<const MeshBounds> meshes) : meshes_(meshes), order_(bound_kinds.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {}, [&](std::size_t k) { return medians(meshes, k).test_ns; });
    bottom_ = kTop + kRow * static_cast<double>(order_.size());
  }

  std::string draw() {
    const double height = bottom_ + kBottom;
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>Bounding volumes, measured</title>\n",
        kWidth, height);
    out_ += chart_style;
    put("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", kWidth, height);
    put("<text x=\"24\" y=\"36\" font-size=\"19\" font-weight=\"600\">Bounding volumes, measured</text>\n");
    const std::size_t placements = meshes_.empty() ? 0 : meshes_[0].ratings.placements.size();
    put("<text class=\"muted\" x=\"24\" y=\"58\" font-size=\"13\">{} placements of two copies whose spheres meet; a "
        "dot "
        "is a mesh ({}), a bar the median; the cheapest test on top</text>\n",
        placements, meshes_.size());
    for (std::size_t row = 0; row < order_.size(); ++row) {
      const double y = row_at(row);
      if (row % 2 == 0)
        put("<rect class=\"band\" x=\"24\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\"/>\n", y - kRow / 2,
            kWidth - kRight - 24, kRow);
      put("<text x=\"{:.0f}\" y=\"{:.1f}\" font-size=\"14\" text-anchor=\"end\">{}</text>\n", kLeft - 14, y + 5,
          name_of(bound_kinds[order_[row]]));
    }
    log_panel(0, "volume over hull volume",
              [](const MeshBounds& m, std::size_t k) { return m.ratings.kinds[k].tightness; });
    share_panel(1);
    log_panel(2, "nanoseconds per overlap test",
              [](const MeshBounds& m, std::size_t k) { return m.ratings.kinds[k].test_ns; });
    return out_ + "</svg>\n";
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(values)...);
  }

  [[nodiscard]] static double left_of(int panel) { return kLeft + panel * (kPanel + kGap); }
  [[nodiscard]] static double row_at(std::size_t row) { return kTop + kRow * (static_cast<double>(row) + 0.5); }

  void grid(double x, const std::string& label) {
    put("<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1:.0f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\"/>\n", x, kTop, bottom_);
    put("<text class=\"muted\" font-size=\"12\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
        bottom_ + 20, label);
  }

  void heading(int panel, std::string_view text) {
    put("<text x=\"{:.1f}\" y=\"{:.0f}\" font-size=\"13\" font-weight=\"600\">{}</text>\n", left_of(panel), kTop - 16,
        text);
  }

  /// All meshes of a kind, spread about the row in their order, and the median with its number.
  template <class Number, class At, class Shown>
  void marks(int panel, std::size_t row, Number number, At at, const Shown& shown) {
    const std::size_t kind = order_[row];
    std::vector<double> numbers;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      const double x = number(meshes_[i], kind);
      if (!std::isfinite(x)) continue;
      numbers.push_back(x);
      const double spread = meshes_.size() < 2 ? 0 : static_cast<double>(i) / static_cast<double>(meshes_.size() - 1);
      put("<circle class=\"s{}\" fill-opacity=\"0.55\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.2\"><title>{}, {}: "
          "{:.4g}</title></circle>\n",
          panel, at(x), row_at(row) + 4 + 12 * (spread - 0.5), escaped(meshes_[i].name), name_of(bound_kinds[kind]), x);
    }
    if (numbers.empty()) return;
    std::ranges::sort(numbers);
    const std::size_t n = numbers.size();
    const double middle = n % 2 == 1 ? numbers[n / 2] : (numbers[n / 2 - 1] + numbers[n / 2]) / 2;
    put("<rect class=\"s6\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"2.4\" height=\"20\"/>\n", at(middle) - 1.2,
        row_at(row) - 6);
    const double end = left_of(panel) + kPanel - 16, text_at = std::clamp(at(middle), left_of(panel) + 16, end);
    put("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" text-anchor=\"middle\">{}</text>\n", text_at,
        row_at(row) - 9, shown(middle));
  }

  template <class Number>
  void log_panel(int panel, std::string_view text, Number number) {
    double low = 1, high = 10;
    bool any = false;
    for (const MeshBounds& m : meshes_) {
      for (const std::size_t k : order_) {
        const double x = number(m, k);
        if (!(x > 0) || !std::isfinite(x)) continue;
        low = any ? std::min(low, x) : x;
        high = any ? std::max(high, x) : x;
        any = true;
      }
    }
    const LogAxis axis(low, high, LogAxis::Ends::padded, left_of(panel), left_of(panel) + kPanel);
    heading(panel, text);
    const auto ticks = axis.ticks();
    double last = -1e9;
    for (const Tick& t : ticks) {
      if (!t.labeled || t.at - last < 26) continue;
      grid(t.at, tick_text(t, ticks));
      last = t.at;
    }
    const auto shown = [](double x) { return x < 1000 ? fmt::format("{:.3g}", x) : fmt::format("{:.2g}k", x / 1000); };
    const auto positive = [&](const MeshBounds& m, std::size_t k) {
      const double x = number(m, k);
      return x > 0 ? x : std::numeric_limits<double>::infinity();
    };
    for (std::size_t row = 0; row < order_.size(); ++row)
      marks(
          panel, row, positive, [&](double x) { return axis.at(x); }, shown);
  }

  void share_panel(int panel) {
    heading(panel, "false overlaps, of hulls apart");
    const auto at = [panel](double share) { return left_of(panel) + 8 + share * (kPanel - 16); };
    for (int percent = 0; percent <= 100; percent += 25) grid(at(percent / 100.0), fmt::format("{}%", percent));
    for (std::size_t row = 0; row < order_.size(); ++row)
      marks(
          panel, row, [](const MeshBounds& m, std::size_t k) { return m.false_share(k); }, at,
          [](double share) { return fmt::format("{:.0f}%", 100 * share); });
  }

  std::span<const MeshBounds> meshes_;
  std::vector<std::size_t> order_;
  double bottom_ = 0;
  std::string out_;
};

}  // namespace

std::string bounds_chart(std::span<const MeshBounds> meshes) { return Spectrum(meshes).draw(); }

}  // namespace plumb::tool
