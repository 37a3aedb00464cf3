#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "lib/image/io/half_row.h"
#include "lib/image/io/readers.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kMostHeaderBytes = 65536;

// How numbers are stored; the name is NumPy's without the byte order.
struct NpyType {
  std::string_view name;
  std::size_t bytes;
  float (*value)(const std::byte* bytes);  // in the processor's own byte order
};

template <typename T>
float value_of(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<float>(value);
}

float half_of(const std::byte* bytes) {
  std::uint16_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  return float_from_half(bits);
}

constexpr NpyType kTypes[] = {{"b1", 1, value_of<std::uint8_t>},  {"u1", 1, value_of<std::uint8_t>},
                              {"u2", 2, value_of<std::uint16_t>}, {"f2", 2, half_of},
                              {"f4", 4, value_of<float>},         {"f8", 8, value_of<double>}};

/// What stands before the numbers [NumPyFormat].
struct NpyHeader {
  const NpyType* type = nullptr;
  bool swapped = false;  // bytes in the other order than the processor's
  std::int64_t height = 0, width = 0;
  int channels = 1;
  std::uint64_t data = 0;  // where the numbers begin
};

[[noreturn]] void refuse(const InputFile& file, const std::string& wrong,
                         const std::string& remedy) {
  throw Error(ErrorKind::kContent, file.name(), wrong, remedy);
}

// What follows 'key': in the header's dictionary, up to `end`.
std::string_view entry(std::string_view header, std::string_view key, char end) {
  const std::size_t at = header.find(key);
  if (at == header.npos) return {};
  std::string_view rest = header.substr(at + key.size());
  while (!rest.empty() && (rest.front() == ':' || rest.front() == ' ')) rest.remove_prefix(1);
  return rest.substr(0, rest.find(end));
}

std::vector<std::int64_t> shape_of(std::string_view header) {
  std::string_view text = entry(header, "'shape'", ')');
  if (!text.starts_with('(')) return {};
  text.remove_prefix(1);
  std::vector<std::int64_t> shape;
  for (std::string_view part : split(text, ',')) {
    while (part.starts_with(' ')) part.remove_prefix(1);
    if (part.empty()) continue;
    shape.push_back(parse_integer(part).value_or(-1));
  }
  return shape;
}

void set_type(const InputFile& file, std::string_view header, NpyHeader& npy) {
  std::string_view text = entry(header, "'descr'", ',');
  text.remove_prefix(text.starts_with('\'') ? 1 : 0);
  text.remove_suffix(text.ends_with('\'') ? 1 : 0);
  const char order = text.empty() ? '|' : text.front();
  const auto* found = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const NpyType& type) {
    return !text.empty() && text.substr(1) == type.name;
  });
  if (found == std::end(kTypes)) {
    refuse(file, "holds numbers of the type " + std::string(text),
           "save floats: array.astype('float32')");
  }
  npy.type = found;
  const char own = std::endian::native == std::endian::little ? '<' : '>';
  npy.swapped = order != own && (order == '<' || order == '>');
}

void set_shape(const InputFile& file, std::string_view header, NpyHeader& npy) {
  const std::vector<std::int64_t> shape = shape_of(header);
  const std::int64_t channels = shape.size() == 3 ? shape[2] : 1;
  const bool picture = shape.size() == 2 || shape.size() == 3;
  if (!picture || (channels != 1 && channels != 3 && channels != 4)) {
    refuse(file, "is no picture: its shape is not rows, columns and 1, 3 or 4 channels",
           "save such an array");
  }
  npy.height = shape[0];
  npy.width = shape[1];
  npy.channels = static_cast<int>(channels);
  if (entry(header, "'fortran_order'", ',') != "False") {
    refuse(file, "is stored column by column", "save numpy.ascontiguousarray(array)");
  }
}

NpyHeader read_header(const InputFile& file) {
  constexpr std::size_t kFixed = 8;  // magic and version
  std::vector<std::byte> bytes(kMostHeaderBytes);
  bytes.resize(file.read_at(0, bytes));
  const auto number = [&](std::size_t at) {
    return at < bytes.size() ? static_cast<std::size_t>(bytes[at]) : 0;
  };
  const bool wide = number(6) >= 2;
  const std::size_t from = kFixed + (wide ? 4 : 2);
  std::size_t size = number(kFixed) | number(kFixed + 1) << 8;
  if (wide) size |= number(kFixed + 2) << 16 | number(kFixed + 3) << 24;
  if (from + size > bytes.size()) {
    refuse(file, "its NumPy header is damaged or cut off", "write or copy it again");
  }
  const std::string_view header(reinterpret_cast<const char*>(bytes.data()) + from, size);
  NpyHeader npy;
  npy.data = from + size;
  set_type(file, header, npy);
  set_shape(file, header, npy);
  return npy;
}

class NpyRows final : public RowSource {
 public:
  NpyRows(InputFilePtr file, const NpyHeader& header, PictureInfo info)
      : file_(std::move(file)),
        header_(header),
        info_(std::move(info)),
        row_(static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.channels) *
             header.type->bytes) {}

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      const auto at = static_cast<std::uint64_t>(next_) * row_.size();
      if (file_->read_at(header_.data + at, row_) < row_.size()) {
        throw Error(ErrorKind::kContent, info_.name,
                    "is damaged or cut off at row " + std::to_string(next_),
                    "write or copy it again");
      }
      convert(rows.row(y));
    }
  }

 private:
  void convert(std::span<float> row) {
    const std::size_t size = header_.type->bytes;
    const std::size_t copies = header_.channels == 1 ? 3 : 1;
    float* to = row.data();
    for (std::byte* from = row_.data(); from < row_.data() + row_.size(); from += size) {
      if (header_.swapped) std::reverse(from, from + size);
      const float value = header_.type->value(from);
      for (std::size_t i = 0; i < copies; ++i) *to++ = value;
    }
  }

  InputFilePtr file_;
  NpyHeader header_;
  PictureInfo info_;
  std::vector<std::byte> row_;
  int next_ = 0;
};

}  // namespace

OpenedPicture open_npy(InputFilePtr file, const ReadOptions& options) {
  const NpyHeader header = read_header(*file);
  check_picture_size(file->name(), header.width, header.height);
  OpenedPicture opened;
  PictureFacts& facts = opened.facts;
  facts.format = "npy";
  facts.colour = "linear, sRGB primaries: the format does not say";
  const std::string_view names = header.channels == 1 ? "Y" : "RGBA";
  for (int i = 0; i < header.channels; ++i) {
    facts.channels.push_back(names[static_cast<std::size_t>(i)] +
                             (":" + std::string(header.type->name)));
  }
  facts.data_width = static_cast<int>(header.width);
  facts.data_height = static_cast<int>(header.height);
  PictureInfo& info = facts.info;
  info.name = file->name();
  info.width = facts.data_width;
  info.height = facts.data_height;
  info.channels = header.channels == 4 ? 4 : 3;
  info.grey = header.channels == 1;
  if (!options.layer.empty()) {
    opened.why_no_rows = "has no layers";
    opened.remedy = "ask for none";
    return opened;
  }
  opened.rows = std::make_unique<NpyRows>(std::move(file), header, info);
  return opened;
}

}  // namespace tristim::detail
