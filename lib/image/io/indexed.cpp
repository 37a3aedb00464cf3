#include "tristim/image/io/indexed.h"

#include <algorithm>

#include "lib/image/io/indexed_readers.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim {
namespace detail {
namespace {

struct Reader {
  std::string_view name;
  std::optional<IndexedPicture> (*read)(InputFilePtr file);
};

constexpr Reader kReaders[] = {{"png", read_indexed_png},
                               {"gif", read_indexed_gif},
                               {"bmp", read_indexed_bmp},
                               {"tiff", read_indexed_tiff}};

void check_positions(const std::string& name, const IndexedPicture& picture) {
  const auto view = picture.positions.view();
  for (int y = 0; y < view.height; ++y) {
    const auto row = view.row(y);
    const std::size_t highest = *std::ranges::max_element(row);
    if (highest < picture.palette.size()) continue;
    throw Error(ErrorKind::kContent, name,
                "row " + std::to_string(y) + " has position " + std::to_string(highest) +
                    ", but its palette has " + std::to_string(picture.palette.size()) + " colours",
                "write it again");
  }
}

}  // namespace

Raster<std::uint8_t> position_raster(const std::string& name, std::int64_t width,
                                     std::int64_t height) {
  check_picture_size(name, width, height);
  if (static_cast<std::uint64_t>(width * height) > kMaxHeldBytes) {
    throw Error(ErrorKind::kContent, name, "is too large: its positions have to be held whole",
                "cut it into parts of 512 MiB");
  }
  return {static_cast<int>(width), static_cast<int>(height), 1};
}

void fail_at_row(const std::string& name, int row, const std::string& why) {
  throw Error(ErrorKind::kContent, name,
              "is damaged or cut off at row " + std::to_string(row) + ": " + why,
              "write or copy it again");
}

}  // namespace detail

std::optional<IndexedPicture> read_indexed_picture(const std::string& path) {
  const auto file = std::make_shared<const detail::InputFile>(path);
  const auto* reader = find_by_name(detail::kReaders, detail::sniff_format(*file));
  if (reader == nullptr) return std::nullopt;
  auto picture = reader->read(file);
  if (picture) detail::check_positions(file->name(), *picture);
  return picture;
}

}  // namespace tristim
