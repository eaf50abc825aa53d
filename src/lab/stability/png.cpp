#include "lab/stability/png.hpp"

#include <png.h>

#include <string_view>

#include "plumb/arith/error.hpp"

namespace plumb::lab::stability {

std::string palette_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Color> palette) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(pixels.size() / width);
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = static_cast<png_uint_32>(palette.size());
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  const auto stride = static_cast<png_int_32>(width);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), stride, palette.data()) == 0) {
    throw Error(std::string("cannot write a picture: ").append(image.message));
  }
  bytes.resize(size);
  return bytes;
}

std::string in_base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      group = group << 8 | (k < bytes.size() ? static_cast<std::uint8_t>(bytes[k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace plumb::lab::stability
