#include "pictures.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tripoint::uvc {
namespace {

std::ptrdiff_t offset(std::size_t at) { return static_cast<std::ptrdiff_t>(at); }

std::vector<Bytes> files_in(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  std::vector<Bytes> files;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  if (files.empty()) throw std::runtime_error(folder.string() + ": no *" + extension);
  return files;
}

}  // namespace

Bytes without_huffman_tables(const Bytes& jpeg) {
  constexpr std::uint8_t kHuffmanTables = 0xc4;
  constexpr std::uint8_t kStartOfScan = 0xda;
  constexpr std::size_t kFirstSegment = 2;
  std::size_t at = kFirstSegment;
  Bytes bare(jpeg.begin(), jpeg.begin() + kFirstSegment);
  while (at + 4 <= jpeg.size() && jpeg[at + 1] != kStartOfScan) {
    const std::size_t end = at + 2 + (std::size_t{jpeg[at + 2]} << 8U | jpeg[at + 3]);
    if (end > jpeg.size()) break;
    if (jpeg[at + 1] != kHuffmanTables) bare.insert(bare.end(), jpeg.begin() + offset(at), jpeg.begin() + offset(end));
    at = end;
  }
  bare.insert(bare.end(), jpeg.begin() + offset(at), jpeg.end());
  return bare;
}

Pictures pictures_from(const RecordingFolders& folders, const std::string& side) {
  Pictures pictures{files_in(folders.yuyv / side, ".yuyv"), files_in(folders.mjpeg / side, ".jpg")};
  for (const Bytes& picture : pictures.yuyv) {
    if (picture.size() != kYuyvBytes) throw std::runtime_error(folders.yuyv.string() + ": pictures must be 640x480");
  }
  for (Bytes& picture : pictures.mjpeg) {
    if (picture.size() < 4) throw std::runtime_error(folders.mjpeg.string() + ": a picture is cut off");
    picture = without_huffman_tables(picture);
  }
  if (pictures.yuyv.size() != pictures.mjpeg.size()) throw std::runtime_error("the two recordings differ in length");
  return pictures;
}

bool Playlist::show(std::size_t first, std::size_t count, bool restless) {
  if (count == 0 || first >= pictures_ || count > pictures_ - first) return false;
  const std::scoped_lock lock(guard_);
  first_ = first;
  count_ = count;
  restless_ = restless;
  return true;
}

Showing Playlist::at(std::uint64_t frame) const {
  const std::scoped_lock lock(guard_);
  return {first_ + frame % count_, restless_};
}

}  // namespace tripoint::uvc
