#include "lib/frame/io/file_sink.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "tristim/core/error.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
FileSink::FileSink(const std::string& path, const FrameInfo& info, bool replace, bool seekable)
    : info_(info), file_(path, replace, seekable) {}

std::int64_t FileSink::all_rows() const noexcept {
  return std::int64_t{info_.height} * info_.frames;
}

void FileSink::write(ImageView<const std::uint16_t> rows) {
  const int samples = info_.layout.packing.samples;
  if (rows.width != info_.width || rows.channels != samples || rows.height > all_rows() - rows_) {
    throw std::invalid_argument(
        "CodeSink::write: rows " + std::to_string(rows_) + " to " +
        std::to_string(rows_ + rows.height) + ", " + std::to_string(rows.width) + " pixels of " +
        std::to_string(rows.channels) + " samples, expected " + std::to_string(all_rows()) +
        " rows of " + std::to_string(info_.width) + " pixels of " + std::to_string(samples));
  }
  for (int y = 0; y < rows.height; ++y) {
    check_codes(rows.row(y));
    write_row(rows.row(y));
  }
  rows_ += rows.height;
}

void FileSink::finish() {
  if (rows_ != all_rows()) {
    throw std::logic_error("CodeSink::finish: after " + std::to_string(rows_) +
                           " rows, expected after " + std::to_string(all_rows()));
  }
  write_end();
  file_.commit();
}

void FileSink::check_codes(std::span<const std::uint16_t> codes) const {
  const Packing& packing = info_.layout.packing;
  std::array<unsigned, 3> limit{};
  for (std::size_t i = 0; i < limit.size(); ++i) limit[i] = max_code(packing.bits[i]);
  if (!info_.palette.empty()) limit[0] = static_cast<unsigned>(info_.palette.size() - 1);

  std::array<std::uint16_t, 3> highest{};
  if (packing.samples == 1 || (limit[0] == limit[1] && limit[1] == limit[2])) {
    for (const std::uint16_t code : codes) highest[0] = std::max(highest[0], code);
  } else {
    for (std::size_t i = 0; i + 2 < codes.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) highest[k] = std::max(highest[k], codes[i + k]);
    }
  }
  for (std::size_t k = 0; k < limit.size(); ++k) {
    if (highest[k] <= limit[k]) continue;
    throw std::invalid_argument("CodeSink::write: code " + std::to_string(highest[k]) +
                                ", expected at most " + std::to_string(limit[k]));
  }
}

void check_frame(const FrameInfo& info) {
  if (info.width < 1 || info.height < 1) {
    throw std::invalid_argument("FrameInfo: size " + std::to_string(info.width) + "x" +
                                std::to_string(info.height) + ", expected at least 1x1");
  }
  if (!info.palette.empty() && info.layout.packing.samples != 1) {
    throw std::invalid_argument("FrameInfo: a palette with packing " +
                                std::string(info.layout.packing.name) +
                                ", expected a packing of one sample");
  }
  if (info.frames < 1) {
    throw std::invalid_argument("FrameInfo: " + std::to_string(info.frames) +
                                " pictures, expected at least 1");
  }
  if (info.gamma && !(*info.gamma > 0)) {
    throw std::invalid_argument("FrameInfo: gamma " + std::to_string(*info.gamma) +
                                ", expected above 0");
  }
}

void check_palette_codes(const std::string& path, const FrameInfo& info) {
  const int bits = info.layout.packing.bits_per_pixel();
  for (std::size_t i = 0; i < info.palette.size(); ++i) {
    if (info.palette[i].code <= max_code(bits)) continue;
    throw Error(ErrorKind::kMisuse, path,
                "palette entry " + std::to_string(i) + " has code " +
                    std::to_string(info.palette[i].code) + ", more than the " +
                    std::to_string(bits) + " bits of packing " +
                    std::string(info.layout.packing.name),
                "use a wider packing or smaller codes");
  }
}

void pack_device_row(std::span<const std::uint16_t> codes, const FrameInfo& info,
                     std::vector<std::uint16_t>& scratch, std::span<std::uint8_t> bytes) {
  if (info.palette.empty()) {
    pack_row(codes, info.layout, bytes);
    return;
  }
  scratch.resize(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) scratch[i] = info.palette[codes[i]].code;
  pack_row(scratch, info.layout, bytes);
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return extension;
}

}  // namespace tristim::detail
