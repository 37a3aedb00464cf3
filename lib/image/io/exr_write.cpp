#include <openexr.h>

#include <algorithm>
#include <exception>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lib/core/parallel.h"
#include "lib/image/io/exr_zip.h"
#include "lib/image/io/half_row.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/image/io/exr.h"

namespace tristim {
namespace detail {
namespace {

constexpr int kChunkRows = 16;  // of the compression ZIP

// Each channel's place in the rows by its name; a file has them in this order.
std::map<std::string, int> named_channels(const PictureInfo& info,
                                          const std::vector<std::string>& names) {
  if (names.empty() && info.grey) {
    return info.channels == 4 ? std::map<std::string, int>{{"A", 3}, {"Y", 0}}
                              : std::map<std::string, int>{{"Y", 0}};
  }
  std::map<std::string, int> channels;
  const std::vector<std::string> colors{"R", "G", "B", "A"};
  const std::vector<std::string>& used = names.empty() ? colors : names;
  for (int i = 0; i < std::min(info.channels, static_cast<int>(used.size())); ++i) {
    channels.emplace(used[static_cast<std::size_t>(i)], i);
  }
  const auto count = static_cast<std::size_t>(info.channels);
  if (channels.size() != count || channels.contains("")) {
    throw std::invalid_argument("names of channels: expected " + std::to_string(count) +
                                " different ones");
  }
  return channels;
}

class ExrSink final : public RowSink {
 public:
  ExrSink(const std::string& path, PictureInfo info, const ExrWriteOptions& options);
  ~ExrSink() override;
  ExrSink(const ExrSink&) = delete;
  ExrSink& operator=(const ExrSink&) = delete;

  void write(ImageView<const float> rows) override;
  void finish() override;

 private:
  static std::int64_t put_bytes(exr_const_context_t context, void* user_data, const void* buffer,
                                std::uint64_t size, std::uint64_t offset,
                                exr_stream_error_func_ptr_t report);
  void put(std::span<const std::byte> bytes, std::uint64_t offset);
  void check(exr_result_t result);
  void write_header(const ExrWriteOptions& options);
  void add_row(std::span<const float> row);
  void add_channel(std::span<const float> row, int channel);
  void write_chunk();

  OutputFile file_;
  PictureInfo info_;
  exr_pixel_type_t type_;
  exr_context_t context_ = nullptr;
  std::exception_ptr failure_;  // of put_bytes, which OpenEXR calls from C
  std::vector<int> channels_;   // in the order of the file: by name
  ExrZip zip_;
  std::vector<float> values_;
  std::vector<std::uint16_t> halves_;
  std::vector<std::byte> chunk_;
  int chunk_rows_ = 0;
  int next_ = 0;
};

ExrSink::ExrSink(const std::string& path, PictureInfo info, const ExrWriteOptions& options)
    : file_(path, options.replace, true),
      info_(std::move(info)),
      type_(options.pixel == ExrPixel::kHalf ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT) {
  exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
  initializer.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
  initializer.user_data = this;
  initializer.write_fn = put_bytes;
  check(exr_start_write(&context_, path.c_str(), EXR_WRITE_FILE_DIRECTLY, &initializer));
  try {
    write_header(options);
  } catch (...) {
    exr_finish(&context_);
    throw;
  }
}

ExrSink::~ExrSink() { exr_finish(&context_); }

std::int64_t ExrSink::put_bytes(exr_const_context_t /*context*/, void* user_data,
                                const void* buffer, std::uint64_t size, std::uint64_t offset,
                                exr_stream_error_func_ptr_t /*report*/) {
  auto* self = static_cast<ExrSink*>(user_data);
  try {
    self->put({static_cast<const std::byte*>(buffer), size}, offset);
    return static_cast<std::int64_t>(size);
  } catch (...) {
    self->failure_ = std::current_exception();
    return -1;
  }
}

void ExrSink::put(std::span<const std::byte> bytes, std::uint64_t offset) {
  if (offset > file_.size()) {  // the table of chunks, which is filled in at the end
    file_.write(std::vector<std::byte>(offset - file_.size()));
  }
  if (offset == file_.size()) {
    file_.write(bytes);
  } else {
    file_.write_at(offset, bytes);
  }
}

void ExrSink::check(exr_result_t result) {
  if (result == EXR_ERR_SUCCESS) return;
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (result == EXR_ERR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw Error(ErrorKind::kSystem, file_.path(),
              std::string("cannot be written: ") + exr_get_default_error_message(result));
}

void ExrSink::write_header(const ExrWriteOptions& options) {
  int part = 0;
  check(exr_add_part(context_, "", EXR_STORAGE_SCANLINE, &part));
  check(exr_initialize_required_attr_simple(context_, part, info_.width, info_.height,
                                            EXR_COMPRESSION_ZIP));
  check(exr_set_pixel_aspect_ratio(context_, part, static_cast<float>(info_.pixel_aspect)));
  for (const auto& [name, channel] : named_channels(info_, options.channels)) {
    check(exr_add_channel(context_, part, name.c_str(), type_, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
    channels_.push_back(channel);
  }
  const Primaries& p = info_.primaries;
  const auto single = [](double value) { return static_cast<float>(value); };
  const exr_attr_chromaticities_t chromaticities = {
      single(p.red.x),  single(p.red.y),  single(p.green.x), single(p.green.y),
      single(p.blue.x), single(p.blue.y), single(p.white.x), single(p.white.y)};
  check(exr_attr_set_chromaticities(context_, part, "chromaticities", &chromaticities));
  check(exr_attr_set_string(context_, part, "software", options.software.c_str()));
  check(exr_write_header(context_));
}

void ExrSink::write(ImageView<const float> rows) {
  for (int y = 0; y < rows.height; ++y) {
    add_row(rows.row(y));
    if (chunk_rows_ == kChunkRows || next_ == info_.height) write_chunk();
  }
}

void ExrSink::add_row(std::span<const float> row) {
  for (const int channel : channels_) add_channel(row, channel);
  ++chunk_rows_;
  ++next_;
}

void ExrSink::add_channel(std::span<const float> row, int channel) {
  values_.resize(static_cast<std::size_t>(info_.width));
  const float* in = row.data() + channel;
  for (float& value : values_) {
    value = *in;
    in += info_.channels;
  }
  std::span<const std::byte> bytes = std::as_bytes(std::span(values_));
  if (type_ == EXR_PIXEL_HALF) {
    halves_.resize(values_.size());
    half_from_float(values_, halves_);
    bytes = std::as_bytes(std::span(halves_));
  }
  chunk_.insert(chunk_.end(), bytes.begin(), bytes.end());
}

void ExrSink::write_chunk() {
  const std::span<const std::byte> packed = zip_.pack(chunk_);
  check(exr_write_scanline_chunk(context_, 0, next_ - chunk_rows_, packed.data(), packed.size()));
  chunk_.clear();
  chunk_rows_ = 0;
}

void ExrSink::finish() {
  check(exr_finish(&context_));
  file_.commit();
}

}  // namespace
}  // namespace detail

std::unique_ptr<RowSink> open_exr_sink(const std::string& path, const PictureInfo& info,
                                       const ExrWriteOptions& options) {
  return std::make_unique<detail::ExrSink>(path, info, options);
}

}  // namespace tristim
