#include "surface/file/gltf_uri.hpp"

#include <algorithm>
#include <fstream>

namespace plumb::surface {
namespace {

namespace fs = std::filesystem;

int digit64(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

int digit16(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

std::optional<std::string> unescaped(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      path += uri[i];
      continue;
    }
    const int high = i + 2 < uri.size() ? digit16(uri[i + 1]) : -1, low = i + 2 < uri.size() ? digit16(uri[i + 2]) : -1;
    if (high < 0 || low < 0) return std::nullopt;
    path += static_cast<char>(16 * high + low);
    i += 2;
  }
  return path;
}

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    const int digit = digit64(c);
    if (digit < 0) return std::nullopt;
    held = (held << 6U | static_cast<unsigned>(digit)) & 0xFFFFFU;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> static_cast<unsigned>(bits) & 0xFFU);
  }
  return bytes;
}

std::optional<fs::path> file_beside(const fs::path& folder, std::string_view uri) {
  const auto name = unescaped(uri);
  constexpr std::string_view never(":\\\0", 3);
  if (!name || name->empty() || name->find_first_of(never) != std::string::npos) return std::nullopt;
  const fs::path relative(*name);
  if (relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end())
    return std::nullopt;
  std::error_code error;
  const fs::path home = fs::canonical(folder, error);
  if (error) return std::nullopt;
  const fs::path place = fs::weakly_canonical(home / relative, error);
  if (error || std::mismatch(home.begin(), home.end(), place.begin(), place.end()).first != home.end())
    return std::nullopt;
  return place;
}

std::optional<std::string> bytes_of(const fs::path& path, std::uint64_t most) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(size, most)), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) return std::nullopt;
  return bytes;
}

}  // namespace plumb::surface
