#include "lib/image/io/exr_chunk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <new>
#include <utility>

#include "lib/image/io/exr_zip.h"
#include "lib/image/io/half_row.h"

namespace tristim::detail {
namespace {

static_assert(std::endian::native == std::endian::little,
              "EXR samples are used as they lie in the file");

// The samples of one channel in one row of a chunk, as the file holds them.
void decode_samples(exr_pixel_type_t type, const std::byte* samples, std::span<float> values,
                    std::vector<std::uint16_t>& halves) {
  if (type == EXR_PIXEL_HALF) {
    halves.resize(values.size());
    std::memcpy(halves.data(), samples, values.size() * 2);
    float_from_half(halves, values);
    return;
  }
  std::memcpy(values.data(), samples, values.size_bytes());
  if (type == EXR_PIXEL_UINT) {
    for (float& value : values) value = static_cast<float>(std::bit_cast<std::uint32_t>(value));
  }
}

// The rows of R, G, B and A of one row of a chunk, before they are joined.
using Planes = std::array<const float*, 4>;

void join_planes(const Planes& planes, int count, int channels, float* out) noexcept {
  const auto [r, g, b, a] = planes;
  if (channels == 3) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      out[3 * i] = r[i];
      out[3 * i + 1] = g[i];
      out[3 * i + 2] = b[i];
    }
    return;
  }
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    out[4 * i] = r[i];
    out[4 * i + 1] = g[i];
    out[4 * i + 2] = b[i];
    out[4 * i + 3] = a[i];
  }
}

int floor_mod(int a, int b) {
  const int rest = a % b;
  return rest < 0 ? rest + b : rest;
}

std::size_t sample_bytes(const exr_coding_channel_info_t& channel) {
  return channel.data_type == EXR_PIXEL_HALF ? 2 : 4;
}

// Bytes of a channel in row `y` of a chunk; subsampled ones are not in every row.
std::size_t row_bytes(const exr_coding_channel_info_t& channel, std::int64_t y) {
  const bool absent =
      channel.height == 0 ||
      (channel.y_samples > 1 && floor_mod(static_cast<int>(y), channel.y_samples) != 0);
  if (absent) return 0;
  return static_cast<std::size_t>(channel.width) * sample_bytes(channel);
}

}  // namespace

// What one thread needs; kept between chunks for its buffers.
struct ExrChunks::Decoder {
  explicit Decoder(const ExrFile& opened, const ExrPart& from) : file(opened), part(from) {}
  ~Decoder() { exr_decoding_destroy(file.context(), &pipeline); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  bool load(int row, int column);
  bool unpack_rows(const ExrSelection& selection, const ExrColour& colour,
                   const PlacedView& target);
  bool unpack_channel(const ExrSelection& selection, int c, std::span<const std::byte> samples,
                      std::size_t skipped, Planes& planes);

  static exr_result_t decompress(exr_decode_pipeline_t* pipeline);

  const ExrFile& file;
  const ExrPart& part;
  bool initialized = false;
  int column = 0;
  int row = 0;
  exr_decode_pipeline_t pipeline = {};
  exr_result_t (*default_decompress)(exr_decode_pipeline_t*) = nullptr;
  ExrZip zip;
  std::vector<std::uint16_t> halves;
  std::array<std::vector<float>, 4> values;
  std::vector<float> zeros;
  std::vector<float> ones;
};

bool ExrChunks::Decoder::load(int chunk_row, int chunk_column) {
  row = chunk_row;
  column = chunk_column;
  const exr_const_context_t context = file.context();
  exr_chunk_info_t chunk = {};
  const auto first_row = static_cast<int>(part.data.y + std::int64_t{chunk_row} * part.chunk_rows);
  const exr_result_t found =
      part.tiled
          ? exr_read_tile_chunk_info(context, part.index, chunk_column, chunk_row, 0, 0, &chunk)
          : exr_read_scanline_chunk_info(context, part.index, first_row, &chunk);
  if (found != EXR_ERR_SUCCESS) return false;
  if (chunk.packed_size == 0 || chunk.packed_size > file.file().size()) return false;
  if (chunk.unpacked_size == 0 || chunk.unpacked_size > kMaxHeldBytes) return false;
  if (initialized) {
    if (exr_decoding_update(context, part.index, &chunk, &pipeline) != EXR_ERR_SUCCESS)
      return false;
  } else {
    if (exr_decoding_initialize(context, part.index, &chunk, &pipeline) != EXR_ERR_SUCCESS)
      return false;
    initialized = true;
    // without places for the channels it unpacks nothing, which is done here
    if (exr_decoding_choose_default_routines(context, part.index, &pipeline) != EXR_ERR_SUCCESS) {
      return false;
    }
    pipeline.unpack_and_convert_fn = nullptr;
    pipeline.decoding_user_data = this;
    default_decompress = pipeline.decompress_fn;
    if (default_decompress != nullptr) pipeline.decompress_fn = decompress;
  }
  return exr_decoding_run(context, part.index, &pipeline) == EXR_ERR_SUCCESS;
}

exr_result_t ExrChunks::Decoder::decompress(exr_decode_pipeline_t* pipeline) {
  auto* self = static_cast<Decoder*>(pipeline->decoding_user_data);
  if (pipeline->unpacked_buffer == pipeline->packed_buffer) return EXR_ERR_SUCCESS;  // stored
  const std::span<std::byte> raw(static_cast<std::byte*>(pipeline->unpacked_buffer),
                                 pipeline->chunk.unpacked_size);
  const std::uint8_t compression = pipeline->chunk.compression;
  if (compression != EXR_COMPRESSION_ZIP && compression != EXR_COMPRESSION_ZIPS) {
    // a damaged chunk may fill only a part, and the rest must not depend on what was there
    std::ranges::fill(raw, std::byte{0});
    return self->default_decompress(pipeline);
  }
  const std::span<const std::byte> packed(static_cast<const std::byte*>(pipeline->packed_buffer),
                                          pipeline->chunk.packed_size);
  try {
    return self->zip.unpack(packed, raw) ? EXR_ERR_SUCCESS : EXR_ERR_CORRUPT_CHUNK;
  } catch (const std::bad_alloc&) {
    return EXR_ERR_OUT_OF_MEMORY;
  }
}

bool ExrChunks::Decoder::unpack_rows(const ExrSelection& selection, const ExrColour& colour,
                                     const PlacedView& target) {
  const exr_chunk_info_t& chunk = pipeline.chunk;
  const std::int64_t chunk_x = part.data.x + std::int64_t{column} * part.chunk_width;
  const std::int64_t chunk_y = part.data.y + std::int64_t{row} * part.chunk_rows;
  const std::int64_t first_x = std::max(chunk_x, target.x);
  const std::int64_t end_x = std::min(chunk_x + chunk.width, target.x + target.view.width);
  const auto count = static_cast<int>(std::max<std::int64_t>(end_x - first_x, 0));
  const auto skipped = static_cast<std::size_t>(std::max<std::int64_t>(first_x - chunk_x, 0));
  zeros.assign(static_cast<std::size_t>(count), 0.0F);
  ones.assign(static_cast<std::size_t>(count), 1.0F);

  std::span<const std::byte> samples(static_cast<const std::byte*>(pipeline.unpacked_buffer),
                                     chunk.unpacked_size);
  for (int line = 0; line < chunk.height; ++line) {
    const std::int64_t y = chunk_y + line;
    const bool wanted = count > 0 && y >= target.y && y < target.y + target.view.height;
    Planes planes = {zeros.data(), zeros.data(), zeros.data(), ones.data()};
    for (int c = 0; c < pipeline.channel_count; ++c) {
      const std::size_t bytes = row_bytes(pipeline.channels[c], y);
      if (bytes > samples.size()) return false;
      if (wanted && !unpack_channel(selection, c, samples.first(bytes), skipped, planes))
        return false;
      samples = samples.subspan(bytes);
    }
    if (!wanted) continue;
    float* out =
        target.view.pixel(static_cast<int>(first_x - target.x), static_cast<int>(y - target.y));
    join_planes(planes, count, target.view.channels, out);
    if (colour.delivered) convert_pixels(*colour.delivered, count, target.view.channels, out);
  }
  return true;
}

// Makes the planes that show channel `c` point to its values from sample `skipped` on.
bool ExrChunks::Decoder::unpack_channel(const ExrSelection& selection, int c,
                                        std::span<const std::byte> samples, std::size_t skipped,
                                        Planes& planes) {
  const auto found = std::ranges::find(selection.channel, c);
  if (found == selection.channel.end()) return true;
  const auto first = static_cast<std::size_t>(found - selection.channel.begin());
  const exr_coding_channel_info_t& channel = pipeline.channels[c];
  const std::size_t bytes = sample_bytes(channel);
  const std::size_t count = zeros.size();
  if ((skipped + count) * bytes > samples.size()) return false;
  values[first].resize(count);
  decode_samples(static_cast<exr_pixel_type_t>(channel.data_type), samples.data() + skipped * bytes,
                 values[first], halves);
  for (std::size_t slot = first; slot < planes.size(); ++slot) {
    if (selection.channel[slot] == c) planes[slot] = values[first].data();
  }
  return true;
}

ExrChunks::ExrChunks(const ExrFile& file, const ExrPart& part, const ExrSelection& selection,
                     const ExrColour& colour)
    : file_(file), part_(part), selection_(selection), colour_(colour) {
  if (part.tiled) {
    columns_ = static_cast<int>((part.data.width + part.chunk_width - 1) / part.chunk_width);
  }
  exr_get_chunk_unpacked_size(file.context(), part.index, &unpacked_bytes_);
}

ExrChunks::~ExrChunks() = default;

bool ExrChunks::decode(int row, int column, const PlacedView& target) {
  const std::int64_t x = part_.data.x + std::int64_t{column} * part_.chunk_width;
  const bool seen = x < target.x + target.view.width && x + part_.chunk_width > target.x;
  if (!seen) return true;
  std::unique_ptr<Decoder> decoder = take_decoder();
  const bool good = decoder->load(row, column) && decoder->unpack_rows(selection_, colour_, target);
  if (good) give_back(std::move(decoder));  // one that failed may be in any state
  return good;
}

std::unique_ptr<ExrChunks::Decoder> ExrChunks::take_decoder() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<Decoder>(file_, part_);
  std::unique_ptr<Decoder> decoder = std::move(idle_.back());
  idle_.pop_back();
  return decoder;
}

void ExrChunks::give_back(std::unique_ptr<Decoder> decoder) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(decoder));
}

}  // namespace tristim::detail
