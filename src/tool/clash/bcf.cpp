#include "tool/clash/bcf.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/arith/error.hpp"
#include "tool/terminal/utf8.hpp"

namespace plumb::tool {
namespace {

std::string little_endian(std::uint64_t number, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i, number >>= 8) text += static_cast<char>(number & 0xFF);
  return text;
}

/// The text as that of an element; control characters, which XML cannot hold, are question marks.
std::string in_xml(const std::string& text) {
  std::string made;
  for (const char c : in_utf8(text)) {
    if (c == '&')
      made += "&amp;";
    else if (c == '<')
      made += "&lt;";
    else if (c == '>')
      made += "&gt;";
    else
      made += static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' ? '?' : c;
  }
  return made;
}

/// FNV-1a of the text, twice from different starts.
std::string guid_of(const std::string& text) {
  std::uint64_t high = 0xcbf29ce484222325U, low = 0x84222325cbf29ce4U;
  for (const char c : text) {
    high = (high ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    low = (low ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    low ^= low >> 29;
  }
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:012x}", high >> 32, high >> 16 & 0xFFFF, (high & 0xFFF) | 0x8000,
                     (low >> 48 & 0x3FFF) | 0x8000, low & 0xFFFFFFFFFFFF);
}

constexpr const char* xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

std::string xyz(double x, double y, double z) { return fmt::format("<X>{}</X><Y>{}</Y><Z>{}</Z>", x, y, z); }

std::string component(const std::string& part) {
  return "<Component><OriginatingSystem>plumb</OriginatingSystem><AuthoringToolId>" + in_xml(part) +
         "</AuthoringToolId></Component>";
}

}  // namespace

std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string body, directory;
  for (const auto& [name, bytes] : files) {
    const auto check = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    constexpr std::uint64_t date = 0x21;  // the first day that the format has
    const std::string about = little_endian(10, 2) + little_endian(0, 6) + little_endian(date, 2) +
                              little_endian(check, 4) + little_endian(bytes.size(), 4) +
                              little_endian(bytes.size(), 4) + little_endian(name.size(), 2) + little_endian(0, 2);
    directory +=
        "PK\x01\x02" + little_endian(10, 2) + about + little_endian(0, 10) + little_endian(body.size(), 4) + name;
    body += "PK\x03\x04" + about + name + bytes;
    if (body.size() + directory.size() > std::numeric_limits<std::uint32_t>::max() || files.size() > 0xFFFF)
      throw Error("an archive of more than 65535 files or 4 GiB cannot be written; ignore some words, or skip pairs");
  }
  const std::string count = little_endian(files.size(), 2);
  return body + directory + "PK\x05\x06" + little_endian(0, 4) + count + count + little_endian(directory.size(), 4) +
         little_endian(body.size(), 4) + little_endian(0, 2);
}

std::string clash_bcf(const ClashReport& report, const std::string& date) {
  std::vector<std::pair<std::string, std::string>> files{
      {"bcf.version",
       std::string(xml_head) + "<Version VersionId=\"2.1\"><DetailedVersion>2.1</DetailedVersion></Version>\n"}};
  for (const PartClash& pair : report.clashes) {
    const AssemblyMember &a = report.parts[pair.a], &b = report.parts[pair.b];
    const Clash& c = pair.clash;
    const std::string title = fmt::format("{} - {}: {}", a.name, b.name, name_of(c.kind));
    const std::string topic = guid_of("topic " + title), view = guid_of("viewpoint " + title);
    std::string about = fmt::format("at {} {} {}", c.place.x, c.place.y, c.place.z);
    if (c.distance) about += fmt::format(", distance {}", *c.distance);
    if (c.volume) about += fmt::format(", volume {}", *c.volume);
    if (c.depth) about += fmt::format(", depth {} to {}", c.depth->lower, c.depth->upper);
    files.emplace_back(
        topic + "/markup.bcf",
        xml_head + fmt::format("<Markup><Topic Guid=\"{}\" TopicType=\"Clash\" TopicStatus=\"Open\"><Title>{}</Title>"
                               "<CreationDate>{}</CreationDate><CreationAuthor>plumb</CreationAuthor>"
                               "<Description>{}</Description></Topic><Viewpoints Guid=\"{}\">"
                               "<Viewpoint>viewpoint.bcfv</Viewpoint></Viewpoints></Markup>\n",
                               topic, in_xml(title), date, about, view));
    const double away = std::max(a.size, b.size) + 1, third = 1 / std::sqrt(3.0);
    files.emplace_back(
        topic + "/viewpoint.bcfv",
        xml_head + fmt::format("<VisualizationInfo Guid=\"{}\"><Components><Selection>{}{}</Selection><Visibility "
                               "DefaultVisibility=\"true\"/></Components><PerspectiveCamera><CameraViewPoint>{}"
                               "</CameraViewPoint><CameraDirection>{}</CameraDirection><CameraUpVector>{}"
                               "</CameraUpVector><FieldOfView>60</FieldOfView></PerspectiveCamera>"
                               "</VisualizationInfo>\n",
                               view, component(a.name), component(b.name),
                               xyz(c.place.x - away, c.place.y - away, c.place.z + away), xyz(third, third, -third),
                               xyz(0, 0, 1)));
  }
  return stored_zip(files);
}

}  // namespace plumb::tool
