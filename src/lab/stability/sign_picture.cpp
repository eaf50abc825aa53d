#include "lab/stability/sign_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "lab/stability/picture_head.hpp"
#include "lab/stability/png.hpp"
#include "lab/trial/terms.hpp"
#include "tool/drawing/chart.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t kColumns = 3, kSide = 256, kGap = 24, kLeft = 24, kTop = 112, kHead = 46;
constexpr std::array<Color, 3> kColors{{{0xD5, 0x5E, 0x00}, {0xF0, 0xE4, 0x42}, {0x00, 0x72, 0xB2}}};

std::string in_hex(const Color& c) { return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]); }

std::string png_of(std::span<const Sign> signs) {
  const auto width = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(signs.size()))));
  std::vector<std::uint8_t> pixels;
  for (std::size_t row = width; row-- > 0;) {
    for (const Sign s : signs.subspan(row * width, width))
      pixels.push_back(static_cast<std::uint8_t>(static_cast<int>(s) + 1));
  }
  return palette_png(width, pixels, kColors);
}

std::string key(const SignPictureText& text) {
  std::string svg;
  std::size_t x = kLeft;
  for (const auto& [sign, meaning] : {std::pair{2U, &text.positive}, {1U, &text.zero}, {0U, &text.negative}}) {
    svg += fmt::format("<rect x=\"{}\" y=\"74\" width=\"14\" height=\"14\" fill=\"{}\"/>\n", x, in_hex(kColors[sign]));
    svg += fmt::format("<text x=\"{}\" y=\"86\" font-size=\"13\">{}</text>\n", x + 20, escaped(*meaning));
    x += kSide + kGap;
  }
  return svg;
}

}  // namespace

std::string sign_picture(const SignPictureText& text, std::span<const SignPanel> panels) {
  const std::size_t rows = (panels.size() + kColumns - 1) / kColumns;
  const std::size_t width = 2 * kLeft + kColumns * kSide + (kColumns - 1) * kGap;
  const std::size_t height = kTop + rows * (kHead + kSide + 12) + 12;
  std::string svg = picture_head(static_cast<double>(width), static_cast<double>(height), text.title, text.subtitle);
  svg += key(text);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t x = kLeft + i % kColumns * (kSide + kGap), y = kTop + i / kColumns * (kHead + kSide + 12);
    svg += fmt::format(
        "<g data-key=\"{0}\"><text x=\"{1}\" y=\"{2}\" font-size=\"14\" font-weight=\"600\">{0}</text>\n"
        "<text class=\"muted\" x=\"{1}\" y=\"{3}\" font-size=\"12\">{4}</text>\n"
        "<image x=\"{1}\" y=\"{5}\" width=\"{6}\" height=\"{6}\" style=\"image-rendering: pixelated\" "
        "href=\"data:image/png;base64,{7}\"/></g>\n",
        escaped(panels[i].title), x, y + 18, y + 36, escaped(panels[i].subtitle), y + kHead, kSide,
        in_base64(png_of(panels[i].signs)));
  }
  return svg + "</svg>\n";
}

}  // namespace plumb::lab::stability
