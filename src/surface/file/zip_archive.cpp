#include "surface/file/zip_archive.hpp"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <vector>

#include "surface/file/mesh_failure.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb::surface {

struct ZipArchive::Reading {
  std::string_view bytes;
  std::string file;
  std::uint64_t limit, left;
  std::uint64_t at = 0;
  bool beyond = false;  // whether something was read beyond the end
  unzFile zip = nullptr;
  std::map<std::string, unz64_file_pos> places{};  // by names in lower case; of two alike the first
};

namespace {

// minizip reads files by these; here the file is in memory.
template <class Reading>
zlib_filefunc64_def functions_of(Reading& reading) {
  zlib_filefunc64_def f{};
  f.opaque = &reading;
  f.zopen64_file = [](voidpf opaque, const void*, int) -> voidpf { return opaque; };
  f.zread_file = [](voidpf, voidpf stream, void* to, uLong size) -> uLong {
    auto& r = *static_cast<Reading*>(stream);
    const std::uint64_t begin = std::min<std::uint64_t>(r.at, r.bytes.size());
    const std::uint64_t got = std::min<std::uint64_t>(size, r.bytes.size() - begin);
    if (got != 0) std::memcpy(to, r.bytes.data() + begin, got);
    r.at = begin + got;
    r.beyond = r.beyond || got < size;
    return static_cast<uLong>(got);
  };
  f.zwrite_file = [](voidpf, voidpf, const void*, uLong) -> uLong { return 0; };
  f.ztell64_file = [](voidpf, voidpf stream) -> ZPOS64_T { return static_cast<Reading*>(stream)->at; };
  f.zseek64_file = [](voidpf, voidpf stream, ZPOS64_T offset, int origin) -> long {
    auto& r = *static_cast<Reading*>(stream);
    const std::uint64_t from = origin == ZLIB_FILEFUNC_SEEK_CUR   ? r.at
                               : origin == ZLIB_FILEFUNC_SEEK_END ? r.bytes.size()
                                                                  : 0;
    if (offset > r.bytes.size() || from > r.bytes.size() - offset) return -1;
    r.at = from + offset;
    return 0;
  };
  f.zclose_file = [](voidpf, voidpf) -> int { return 0; };
  // Otherwise minizip takes zeros for what lies beyond the end.
  f.zerror_file = [](voidpf, voidpf stream) -> int { return static_cast<Reading*>(stream)->beyond; };
  return f;
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes, std::string_view file, std::uint64_t limit)
    : reading_(new Reading{bytes, std::string(file), limit, limit}) {
  zlib_filefunc64_def functions = functions_of(*reading_);
  reading_->zip = unzOpen2_64("", &functions);
  if (reading_->zip == nullptr)
    fail_at_file(MeshFileProblem::truncated, file,
                 "the zip archive has no directory at its end; it is cut short or damaged: fetch or export it again");
  int said = unzGoToFirstFile(reading_->zip);
  for (; said == UNZ_OK; said = unzGoToNextFile(reading_->zip)) {
    std::array<char, 512> name{};  // longer ones are no parts of a 3MF
    unz64_file_pos place{};
    unz_file_info64 info{};
    unzGetCurrentFileInfo64(reading_->zip, &info, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
    if (unzGetFilePos64(reading_->zip, &place) == UNZ_OK) reading_->places.emplace(lower_case(name.data()), place);
  }
  if (said != UNZ_END_OF_LIST_OF_FILE) {
    unzClose(reading_->zip);
    fail_at_file(MeshFileProblem::syntax, file,
                 "the directory of the zip archive is damaged; fetch or export it again");
  }
}

ZipArchive::~ZipArchive() { unzClose(reading_->zip); }

std::optional<std::string> ZipArchive::entry(const std::string& name) {
  Reading& r = *reading_;
  const auto found = r.places.find(lower_case(name));
  if (found == r.places.end() || unzGoToFilePos64(r.zip, &found->second) != UNZ_OK) return std::nullopt;
  const auto fail = [&](MeshFileProblem problem, const std::string& text) {
    fail_at_file(problem, r.file, in_quotes(name) + ": " + text);
  };
  unz_file_info64 info{};
  unzGetCurrentFileInfo64(r.zip, &info, nullptr, 0, nullptr, 0, nullptr, 0);
  if ((info.flag & 1U) != 0)
    fail(MeshFileProblem::unsupported, "this entry is encrypted, expected a plain one; export it without a password");
  if (info.compression_method != 0 && info.compression_method != Z_DEFLATED)
    fail(MeshFileProblem::unsupported, "this entry is packed by method " + std::to_string(info.compression_method) +
                                           ", expected 0 or 8 (deflate); export it again");
  const char* const damaged = "this entry of the zip archive is damaged; fetch or export it again";
  if (unzOpenCurrentFile(r.zip) != UNZ_OK) fail(MeshFileProblem::syntax, damaged);
  std::string unpacked;
  std::vector<char> room(std::size_t{1} << 18);
  for (int got = 0; (got = unzReadCurrentFile(r.zip, room.data(), static_cast<unsigned>(room.size()))) != 0;) {
    if (got < 0) fail(MeshFileProblem::syntax, damaged);
    const auto size = static_cast<std::uint64_t>(got);
    if (size > r.left)
      fail(MeshFileProblem::too_large, "unpacks to more than " + std::to_string(r.limit) +
                                           " bytes with what was read " +
                                           "before, expected no more; raise the limit if you trust it");
    r.left -= size;
    unpacked.append(room.data(), size);
  }
  const bool whole = unpacked.size() == info.uncompressed_size;
  if (unzCloseCurrentFile(r.zip) != UNZ_OK || !whole) fail(MeshFileProblem::syntax, damaged);
  return unpacked;
}

}  // namespace plumb::surface
