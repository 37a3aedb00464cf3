#include "lib/frame/io/color_table.h"

#include "lib/frame/io/file_sink.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

std::vector<PaletteEntry> greys(int bits) {
  std::vector<PaletteEntry> entries;
  for (unsigned code = 0; code <= max_code(bits); ++code) {
    const auto grey = static_cast<std::uint8_t>(widen(code, bits, 8));
    entries.push_back({{grey, grey, grey}, static_cast<std::uint16_t>(code), {}});
  }
  return entries;
}

}  // namespace

ColorTable color_table(const std::string& path, const FrameInfo& info, std::string_view format) {
  const Packing& packing = info.layout.packing;
  ColorTable table;
  if (!info.palette.empty()) {
    table.entries = info.palette;
  } else if (packing.samples == 1 && packing.bits[0] <= 8) {
    table.entries = greys(packing.bits[0]);
  } else {
    throw Error(ErrorKind::kMisuse, path,
                std::string(format) + " holds a palette of at most " +
                    std::to_string(kMostTableColors) + " colours, codes of packing " +
                    std::string(packing.name) + " are more",
                "choose a palette (--palette), or write PNG or TIFF");
  }
  if (table.entries.size() > kMostTableColors) {
    throw Error(ErrorKind::kMisuse, path,
                "a palette of " + std::to_string(table.entries.size()) + " colours, but " +
                    std::string(format) + " holds at most " + std::to_string(kMostTableColors),
                "use fewer colours");
  }
  table.bits = 1;
  while (table.entries.size() > std::size_t{1} << table.bits) ++table.bits;
  return table;
}

int transparent_entry(const std::vector<PaletteEntry>& entries) noexcept {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].alpha == 0) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace tristim::detail
