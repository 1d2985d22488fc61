// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/pcd_stream.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace {

// The header is padded to this size with a comment, so that the count can be put in at the end.
constexpr std::size_t kHeaderBytes = 512;
constexpr std::size_t kBlock = 65536;

static_assert(sizeof(MapPoint) == 24, "a point is written as its six fields");
static_assert(sizeof(ColouredMapPoint) == 28, "a point is written as its seven fields");

/// What a field more than those of MapPoint adds to the lines of the header.
struct ExtraField {
  std::string name, size, type, count;
};
const ExtraField kNone;
const ExtraField kRgb{" rgb", " 4", " F", " 1"};

std::string header(std::size_t count, const ExtraField& extra) {
  const std::string n = std::to_string(count);
  const std::string fields = "VERSION 0.7\nFIELDS x y z intensity label instance" + extra.name +
                             "\nSIZE 4 4 4 4 4 4" + extra.size + "\nTYPE F F F F U U" + extra.type +
                             "\nCOUNT 1 1 1 1 1 1" + extra.count + "\nWIDTH " + n +
                             "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA binary\n";
  const std::string start = "# .PCD v0.7 - Point Cloud Data file format\n# ";
  const std::size_t padding = kHeaderBytes - start.size() - fields.size() - 1;
  return start + std::string(padding, '.') + "\n" + fields;
}

}  // namespace

PcdStream::PcdStream(const std::filesystem::path& file) : path_(file), file_(file) {
  file_.write(header(0, kNone));
}

void PcdStream::add(const std::vector<MapPoint>& points) {
  file_.write(points.data(), points.size() * sizeof(MapPoint));
  count_ += points.size();
}

void PcdStream::finish() {
  file_.rewriteStart(header(count_, kNone));
  file_.commit();
  std::filesystem::resize_file(path_, kHeaderBytes + count_ * sizeof(MapPoint));
}

void writeColouredPcd(const std::filesystem::path& file,
                      const std::vector<ColouredMapPoint>& points) {
  AtomicFile out(file);
  out.write(header(points.size(), kRgb));
  out.write(points.data(), points.size() * sizeof(ColouredMapPoint));
  out.commit();
}

void forEachPoint(const std::filesystem::path& file,
                  const std::function<void(const MapPoint&)>& visit) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw IoError("cannot read map " + file.string());
  const auto bytes = static_cast<std::size_t>(stream.tellg());
  if (bytes < kHeaderBytes || (bytes - kHeaderBytes) % sizeof(MapPoint) != 0) {
    throw IoError("map " + file.string() + " is not whole, or segdf did not write it");
  }
  std::size_t left = (bytes - kHeaderBytes) / sizeof(MapPoint);
  stream.seekg(static_cast<std::streamoff>(kHeaderBytes));
  std::vector<MapPoint> block;
  while (left > 0) {
    block.resize(std::min(left, kBlock));
    stream.read(reinterpret_cast<char*>(block.data()),
                static_cast<std::streamsize>(block.size() * sizeof(MapPoint)));
    if (!stream) throw IoError("cannot read map " + file.string() + " to its end");
    for (const MapPoint& point : block) visit(point);
    left -= block.size();
  }
}

}  // namespace segdf
