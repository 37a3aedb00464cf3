#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "lib/image/io/pnm_header.h"
#include "lib/image/io/readers.h"
#include "lib/image/io/sample_decoder.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

class PnmRows final : public RowSource {
 public:
  PnmRows(InputFilePtr file, PnmHeader header, const SampleLayout& layout, PictureInfo info)
      : file_(std::move(file)),
        header_(std::move(header)),
        decoder_(layout),
        info_(std::move(info)),
        sample_count_(static_cast<std::size_t>(header_.width) *
                      static_cast<std::size_t>(header_.samples)),
        sample_bytes_(sample_bytes(layout.type)),
        samples_(sample_count_ * sample_bytes_) {
    if (header_.text) characters_ = std::make_unique<CharacterReader>(*file_, header_.data);
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      if (header_.text) {
        read_digits();
      } else if (header_.packed) {
        read_bits();
      } else {
        read_samples();
      }
      decoder_.decode(samples_, rows.row(y));
    }
  }

 private:
  void read_digits() {
    for (std::size_t i = 0; i < sample_count_; ++i) {
      const std::int64_t value = header_.format == "pbm" ? read_bit() : read_number(*characters_);
      if (value < 0) damaged();
      set_sample(i, static_cast<std::uint16_t>(std::min(value, header_.maximum)));
    }
  }

  // Digits of a PBM may stand without space between them.
  std::int64_t read_bit() {
    int c = characters_->next();
    while (c == ' ' || (c >= '\t' && c <= '\r')) c = characters_->next();
    return c == '0' ? 1 : c == '1' ? 0 : -1;
  }

  void read_bits() {
    packed_.resize((sample_count_ + 7) / 8);
    fetch(packed_, static_cast<std::uint64_t>(next_));
    for (std::size_t i = 0; i < sample_count_; ++i) {
      const auto byte = static_cast<unsigned>(packed_[i / 8]);
      set_sample(i, (byte >> (7 - i % 8) & 1) != 0 ? 0 : 1);
    }
  }

  void read_samples() {
    // PFM has its rows from the bottom
    const int row = header_.format == "pfm" ? info_.height - 1 - next_ : next_;
    fetch(samples_, static_cast<std::uint64_t>(row));
    const bool little = header_.format == "pfm" && header_.little_endian;
    if (sample_bytes_ == 1 || little == (std::endian::native == std::endian::little)) return;
    for (std::size_t i = 0; i < samples_.size(); i += sample_bytes_) {
      std::reverse(samples_.data() + i, samples_.data() + i + sample_bytes_);
    }
  }

  void fetch(std::span<std::byte> bytes, std::uint64_t row) {
    if (file_->read_at(header_.data + row * bytes.size(), bytes) < bytes.size()) damaged();
  }

  void set_sample(std::size_t i, std::uint16_t value) {
    if (sample_bytes_ == 1) {
      samples_[i] = static_cast<std::byte>(value);
    } else {
      std::memcpy(samples_.data() + 2 * i, &value, 2);
    }
  }

  [[noreturn]] void damaged() const {
    throw Error(ErrorKind::kContent, info_.name,
                "is damaged or cut off at row " + std::to_string(next_), "write or copy it again");
  }

  InputFilePtr file_;
  PnmHeader header_;
  SampleDecoder decoder_;
  PictureInfo info_;
  std::size_t sample_count_;  // of a row
  std::size_t sample_bytes_;
  std::vector<std::byte> samples_;  // a row
  std::vector<std::byte> packed_;
  std::unique_ptr<CharacterReader> characters_;
  int next_ = 0;
};

SampleLayout layout_of(const PnmHeader& header, bool codes) {
  SampleLayout layout{.samples = header.samples};
  if (header.format == "pfm") {
    layout.type = SampleType::kFloat;
    layout.curve = kNoCurve;
  } else {
    layout.type = header.maximum > 255 ? SampleType::kUint16 : SampleType::kUint8;
    layout.maximum = static_cast<int>(header.maximum);
    if (codes) layout.curve = kNoCurve;
  }
  const int alpha = header.alpha ? header.samples - 1 : -1;
  layout.source = header.samples < 3 ? std::array{0, 0, 0, alpha} : std::array{0, 1, 2, alpha};
  return layout;
}

}  // namespace

OpenedPicture open_pnm(InputFilePtr file, const ReadOptions& options) {
  PnmHeader header = read_pnm_header(*file);
  check_picture_size(file->name(), header.width, header.height);
  const SampleLayout layout = layout_of(header, options.codes);
  OpenedPicture opened;
  PictureFacts& facts = opened.facts;
  facts.format = header.format;
  facts.colour = header.format == "pfm" ? "linear" : "sRGB curve";
  facts.colour += ", sRGB primaries: the format does not say";
  const std::string type =
      ":" + (header.packed ? std::string("1-bit") : std::string(sample_type_name(layout.type)));
  const std::string_view names = header.samples < 3 ? "YA" : "RGBA";
  for (int i = 0; i < header.samples; ++i) {
    facts.channels.push_back(names[static_cast<std::size_t>(i)] + type);
  }
  facts.data_width = static_cast<int>(header.width);
  facts.data_height = static_cast<int>(header.height);
  PictureInfo& info = facts.info;
  info.name = file->name();
  info.width = facts.data_width;
  info.height = facts.data_height;
  info.channels = header.alpha ? 4 : 3;
  info.grey = header.samples < 3;
  if (!options.layer.empty()) {
    opened.why_no_rows = "has no layers";
    opened.remedy = "ask for none";
    return opened;
  }
  opened.rows = std::make_unique<PnmRows>(std::move(file), std::move(header), layout, info);
  return opened;
}

}  // namespace tristim::detail
