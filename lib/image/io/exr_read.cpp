#include <algorithm>
#include <optional>
#include <utility>

#include "lib/core/parallel.h"
#include "lib/image/io/exr_channels.h"
#include "lib/image/io/exr_chunk.h"
#include "lib/image/io/exr_colour.h"
#include "lib/image/io/exr_file.h"
#include "lib/image/io/exr_module_rows.h"
#include "lib/image/io/readers.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr std::uint64_t kSharedChunkBytes = std::uint64_t{32}
                                            << 20;  // above it, one thread at a time
constexpr std::size_t kNamedChannels = 16;

// All that the rows of one EXR file need; its address is fixed, as parts of it refer to each other.
struct OpenedExr {
  explicit OpenedExr(InputFilePtr from) : file(std::move(from)) {}
  ExrFile file;
  ExrPart part;
  ExrSelection selection;
  ExrColour colour;
  int threads = 0;
};

class ExrRows final : public RowSource {
 public:
  ExrRows(std::unique_ptr<OpenedExr> exr, PictureInfo info)
      : exr_(std::move(exr)),
        info_(std::move(info)),
        chunks_(exr_->file, exr_->part, exr_->selection, exr_->colour) {}

  const PictureInfo& info() const noexcept override { return info_; }
  void read(ImageView<float> rows) override;

 private:
  // Rows of the picture that one row of chunks gives.
  struct ChunkRow {
    int index;
    int first, end;
  };
  ChunkRow chunk_row_at(std::int64_t data_row) const;
  void decode(std::span<const std::pair<int, PlacedView>> rows);
  PlacedView placed(ImageView<float> view, int first_row) const {
    return {view, exr_->part.display.x, exr_->part.display.y + first_row};
  }

  std::unique_ptr<OpenedExr> exr_;
  PictureInfo info_;
  ExrChunks chunks_;
  int next_ = 0;
  Image held_;  // the rows of a chunk of which only some have been asked for
  int held_index_ = -1;
};

void clear(ImageView<float> view) {
  for (int y = 0; y < view.height; ++y) std::ranges::fill(view.row(y), 0.0F);
}

void ExrRows::read(ImageView<float> rows) {
  const ExrPart& part = exr_->part;
  const int first = next_;
  const int end = first + rows.height;
  next_ = end;
  if (!covers(part.data, part.display)) clear(rows);
  const PixelWindow seen = visible(part.data, part.display);
  if (seen.width == 0) return;
  const int seen_end = static_cast<int>(std::min<std::int64_t>(end, seen.y + seen.height));

  std::vector<std::pair<int, PlacedView>> whole;
  for (int y = static_cast<int>(std::max<std::int64_t>(first, seen.y)); y < seen_end;) {
    const ChunkRow chunk = chunk_row_at(part.display.y + y - part.data.y);
    const int until = std::min(chunk.end, seen_end);
    if (y == chunk.first && until == chunk.end) {
      whole.emplace_back(chunk.index, placed(rows.rows(y - first, until - y), y));
    } else {
      if (held_index_ != chunk.index) {
        held_index_ = -1;
        held_ = Image(info_.width, std::min(part.chunk_rows, info_.height), info_.channels);
        const std::pair<int, PlacedView> target(
            chunk.index, placed(held_.view().rows(0, chunk.end - chunk.first), chunk.first));
        decode({&target, 1});
        held_index_ = chunk.index;
      }
      const ImageView<float> held = held_.view();
      for (int row = y; row < until; ++row) {
        std::ranges::copy(held.row(row - chunk.first), rows.row(row - first).begin());
      }
    }
    y = until;
  }
  decode(whole);
}

ExrRows::ChunkRow ExrRows::chunk_row_at(std::int64_t data_row) const {
  const ExrPart& part = exr_->part;
  const std::int64_t index = data_row / part.chunk_rows;
  const std::int64_t offset = part.data.y - part.display.y;  // from rows of data to the picture's
  const PixelWindow seen = visible(part.data, part.display);
  const std::int64_t first = std::max(index * part.chunk_rows + offset, seen.y);
  const std::int64_t end = std::min((index + 1) * part.chunk_rows + offset, seen.y + seen.height);
  return {static_cast<int>(index), static_cast<int>(first), static_cast<int>(end)};
}

void ExrRows::decode(std::span<const std::pair<int, PlacedView>> rows) {
  const int columns = chunks_.columns();
  const auto jobs = static_cast<int>(rows.size()) * columns;
  const int threads = chunks_.unpacked_bytes() > kSharedChunkBytes ? 1 : exr_->threads;
  std::vector<char> good(static_cast<std::size_t>(jobs), 0);
  parallel_for_rows(jobs, threads, [&](int job) {
    const auto& [index, target] = rows[static_cast<std::size_t>(job / columns)];
    good[static_cast<std::size_t>(job)] = chunks_.decode(index, job % columns, target) ? 1 : 0;
  });
  const auto bad = std::ranges::find(good, 0);
  if (bad == good.end()) return;
  const PlacedView& target = rows[static_cast<std::size_t>((bad - good.begin()) / columns)].second;
  const std::int64_t row = target.y - exr_->part.display.y;
  throw Error(ErrorKind::kContent, info_.name,
              "is damaged or cut off at row " + std::to_string(row), "write or copy it again");
}

std::vector<ExrPart> all_parts(const ExrFile& file) {
  std::vector<ExrPart> parts;
  const int count = file.part_count();
  parts.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) parts.push_back(file.part(i));
  return parts;
}

// The names of a channel_list, without their types.
std::string join_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kNamedChannels); ++i) {
    if (i > 0) text += ", ";
    text += names[i].substr(0, names[i].rfind(':'));
  }
  if (names.size() > kNamedChannels) text += ", ...";
  return text;
}

void explain_no_rows(const std::vector<ExrPart>& parts, const ReadOptions& options,
                     OpenedPicture& out) {
  const std::string list = join_names(out.facts.channels);
  if (std::ranges::all_of(parts, &ExrPart::deep)) {
    out.why_no_rows = "is deep: a pixel has any number of samples";
    out.remedy = "flatten it in the renderer or compositor first";
  } else if (!options.layer.empty()) {
    out.why_no_rows = "has no layer or channel called " + options.layer;
    out.remedy = "it has " + list;
  } else {
    out.why_no_rows = "has no colour channels (R G B, Y or X Y Z)";
    out.remedy = list.empty() ? "" : "choose a layer or a channel of those it has: " + list;
  }
}

PictureFacts facts_of(const InputFile& file, const ExrPart& part, const ExrSelection& selection,
                      const ExrColour& colour) {
  PictureFacts facts;
  facts.format = "openexr";
  facts.compression = part.compression;
  facts.colour = colour.words;
  facts.data_x = static_cast<int>(part.data.x - part.display.x);
  facts.data_y = static_cast<int>(part.data.y - part.display.y);
  facts.data_width = static_cast<int>(part.data.width);
  facts.data_height = static_cast<int>(part.data.height);
  PictureInfo& info = facts.info;
  info.width = static_cast<int>(part.display.width);
  info.height = static_cast<int>(part.display.height);
  info.channels = selection.channel[3] >= 0 || !covers(part.data, part.display) ? 4 : 3;
  info.grey = selection.model == ExrColourModel::kGrey;
  info.primaries = colour.primaries;
  info.pixel_aspect = part.pixel_aspect;
  info.chunk_rows = std::min(part.chunk_rows, info.height);
  info.name = file.name();
  return facts;
}

// Refuses, before anything large is allocated, what cannot be the size of this file.
void check_sizes(const ExrFile& file, const ExrPart& part) {
  const std::string& name = file.file().name();
  check_picture_size(name, part.display.width, part.display.height);
  check_picture_size(name, part.data.width, part.data.height);
  const auto far = [](std::int64_t a, std::int64_t b) {
    return a - b > INT32_MAX || b - a > INT32_MAX;
  };
  if (far(part.data.x, part.display.x) || far(part.data.y, part.display.y)) {
    throw Error(ErrorKind::kContent, name, "its data window is far outside its display window");
  }
  if (part.deep) return;
  std::int32_t chunk_count = 0;
  std::uint64_t unpacked = 0;
  if (exr_get_chunk_count(file.context(), part.index, &chunk_count) != EXR_ERR_SUCCESS ||
      exr_get_chunk_unpacked_size(file.context(), part.index, &unpacked) != EXR_ERR_SUCCESS) {
    throw Error(ErrorKind::kContent, name, "its EXR header is damaged", "write or copy it again");
  }
  const auto table_bytes =
      std::uint64_t{sizeof(std::uint64_t)} * static_cast<std::uint64_t>(chunk_count);
  if (chunk_count < 1 || table_bytes > file.file().size()) {
    throw Error(ErrorKind::kContent, name,
                "is damaged or cut off at row 0: its table of " + std::to_string(chunk_count) +
                    " chunks does not fit into it",
                "write or copy it again");
  }
  const std::uint64_t held =
      std::uint64_t{sizeof(float)} * 4 * static_cast<std::uint64_t>(part.display.width) *
      static_cast<std::uint64_t>(std::min<std::int64_t>(part.chunk_rows, part.display.height));
  if (unpacked + held > kMaxHeldBytes) {
    throw Error(ErrorKind::kContent, name,
                "its chunks are too large: one row of them needs " +
                    std::to_string((unpacked + held) >> 20) + " MiB",
                "write it with smaller tiles or blocks of rows");
  }
}

// The luminance alone may be read at full size; every other channel must have it.
void check_sampling(const ExrFile& file, const ExrPart& part, const ExrSelection& selection) {
  for (const int index : selection.channel) {
    if (index < 0 || !part.channels[static_cast<std::size_t>(index)].subsampled) continue;
    throw Error(ErrorKind::kContent, file.file().name(),
                "its channel " + part.channels[static_cast<std::size_t>(index)].name +
                    " has fewer samples than the picture has pixels",
                "write it with one sample for each pixel");
  }
}

}  // namespace

OpenedPicture open_exr(InputFilePtr file, const ReadOptions& options) {
  auto exr = std::make_unique<OpenedExr>(file);
  const std::vector<ExrPart> parts = all_parts(exr->file);
  exr->selection = select_channels(parts, options.layer);
  exr->part = parts[static_cast<std::size_t>(exr->selection.part)];
  exr->threads = options.threads;
  check_sizes(exr->file, exr->part);
  exr->colour = exr_colour(file->name(), exr->part, exr->selection.model);

  OpenedPicture opened;
  opened.facts = facts_of(*file, exr->part, exr->selection, exr->colour);
  opened.facts.channels = channel_list(parts);
  if (exr->selection.model == ExrColourModel::kNone) {
    explain_no_rows(parts, options, opened);
    return opened;
  }
  check_sampling(exr->file, exr->part, exr->selection);
  PictureInfo info = opened.facts.info;
  if (needs_exr_module(exr->part, exr->selection)) {
    opened.rows =
        open_exr_module_rows(std::move(file), exr->part, exr->selection, exr->colour, info);
  } else {
    opened.rows = std::make_unique<ExrRows>(std::move(exr), std::move(info));
  }
  return opened;
}

}  // namespace tristim::detail
