#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "tristim/core/error.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kMaxArrayBytes = std::size_t{256} << 20;  // a text of 1.3 GB
constexpr std::size_t kBytesPerLine = 16;
constexpr char kDigits[] = "0123456789abcdef";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What the identifiers begin with: the file's stem, without what C and C++ reserve (leading and
/// double underscores).
std::string identifier_of(const std::string& path) {
  std::string identifier;
  for (const char c : std::filesystem::path(path).stem().string()) {
    if (is_letter(c) || is_digit(c)) {
      identifier += c;
    } else if (!identifier.empty() && identifier.back() != '_') {
      identifier += '_';
    }
  }
  if (!identifier.empty() && identifier.back() == '_') identifier.pop_back();
  if (identifier.empty()) return "frame";
  return is_digit(identifier[0]) ? "frame_" + identifier : identifier;
}

/// A name as a line comment can hold it: no backslash (nor its trigraph) that would go on in the
/// next line.
std::string comment_text(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    text += control || c == '\\' || c == '?' ? ' ' : c;
  }
  return text;
}

std::string number(std::size_t value) { return std::to_string(value); }

std::string field(const char* word, int shift, int bits) {
  std::string text = word;
  if (shift > 0) text += " >> " + std::to_string(shift);
  return text + " & " + std::to_string(max_code(bits));
}

std::string word_at(std::size_t byte, ByteOrder order) {
  const bool big = order == ByteOrder::kBig;
  return "(unsigned)p[" + number(byte + (big ? 0 : 1)) + "] << 8 | p[" +
         number(byte + (big ? 1 : 0)) + "]";
}

/// C statements that read the pixel in column x and row y: unsigned `code`, or `red`, `green`,
/// `blue`.
std::vector<std::string> reading(const std::string& name, const FrameLayout& layout) {
  const Packing& packing = layout.packing;
  const auto& bits = packing.bits;
  const std::string row =
      "const uint8_t* p = " + name + "_data + (uint32_t)y * " + name + "_stride";
  const auto pixel_bytes = packed_row_bytes(packing, 1);
  const std::string pixel =
      row + " + x" + (pixel_bytes > 1 ? " * " + number(pixel_bytes) : "") + ";";

  if (packing.samples == 1 && bits[0] < 8) {
    const int per_byte = 8 / bits[0];
    const std::string place =
        "x % " + std::to_string(per_byte) + (bits[0] > 1 ? " * " + std::to_string(bits[0]) : "");
    const std::string shift =
        layout.bit_order == BitOrder::kLsb ? place : std::to_string(8 - bits[0]) + " - " + place;
    return {row + " + x / " + std::to_string(per_byte) + ";",
            "unsigned code = *p >> (" + shift + ") & " + std::to_string(max_code(bits[0])) + ";"};
  }
  if (packing.samples == 1) {
    return {pixel,
            "unsigned code = " + (bits[0] == 8 ? "*p" : word_at(0, layout.byte_order)) + ";"};
  }
  const std::size_t red = packing.blue_first ? 2 : 0;
  const std::size_t blue = 2 - red;
  if (bits[0] == 8 || bits[0] == 16) {
    const auto sample = [&](std::size_t place) {
      return bits[0] == 8 ? "p[" + number(place) + "]" : word_at(place * 2, layout.byte_order);
    };
    return {pixel, "unsigned red = " + sample(red) + ";", "unsigned green = " + sample(1) + ";",
            "unsigned blue = " + sample(blue) + ";"};
  }
  const int low = packing.blue_first ? bits[0] : bits[2];
  const int high = low + bits[1];
  return {pixel,
          "unsigned word = " + (pixel_bytes == 1 ? "*p" : word_at(0, layout.byte_order)) + ";",
          "unsigned red = " + field("word", packing.blue_first ? 0 : high, bits[0]) + ";",
          "unsigned green = " + field("word", low, bits[1]) + ";",
          "unsigned blue = " + field("word", packing.blue_first ? high : 0, bits[2]) + ";"};
}

/// Says the orders that matter for this packing.
std::string order_text(const FrameLayout& layout) {
  const Packing& packing = layout.packing;
  if (packing.samples == 1 && packing.bits[0] < 8) {
    return layout.bit_order == BitOrder::kMsb
               ? ", the first pixel of a byte in its most significant bits"
               : ", the first pixel of a byte in its least significant bits";
  }
  const bool words = packing.bits[0] == 16 || packing.bits_per_pixel() > 8;
  if (!words || packing.bits[0] == 8) return "";
  return layout.byte_order == ByteOrder::kBig ? ", 16-bit words with the high byte first"
                                              : ", 16-bit words with the low byte first";
}

class CHeaderSink final : public FileSink {
 public:
  CHeaderSink(const std::string& path, const FrameInfo& info, bool replace)
      : FileSink(path, info, replace),
        name_(identifier_of(path)),
        bytes_(packed_row_bytes(info.layout.packing, info.width)) {
    write_head();
  }

 private:
  void write_head() {
    const FrameInfo& frame = info();
    const std::string size = std::to_string(frame.width) + "x" + std::to_string(frame.height);
    std::string text = "#pragma once\n\n#include <stdint.h>\n\n";
    text += "// " + size + " pixels";
    if (!frame.device.empty()) text += " for " + comment_text(frame.device);
    text += ", written by tristim.\n";
    text += "// Packing " + std::string(frame.layout.packing.name) + ": " +
            std::to_string(frame.layout.packing.bits_per_pixel()) + " bits a pixel" +
            order_text(frame.layout) + "; each row starts in a new byte.\n";
    text += "// To read the pixel in column x and row y:\n";
    for (const std::string& line : reading(name_, frame.layout)) text += "//   " + line + "\n";
    text += "enum {\n";
    text += constant("width", static_cast<std::size_t>(frame.width), "pixels");
    text += constant("height", static_cast<std::size_t>(frame.height), "rows");
    text += constant("stride", bytes_.size(), "bytes from one row to the next");
    text += constant("bits", static_cast<std::size_t>(frame.layout.packing.bits_per_pixel()),
                     "of a pixel");
    if (!frame.palette.empty()) text += constant("colors", frame.palette.size(), "of the palette");
    text += "};\n\nstatic const char " + name_ + "_packing[] = \"" +
            std::string(frame.layout.packing.name) + "\";\n\n";
    file().write(text);
    if (!frame.palette.empty()) write_palette();
    file().write("static const uint8_t " + name_ + "_data[" +
                 number(bytes_.size() * static_cast<std::size_t>(frame.height)) + "] = {\n");
  }

  std::string constant(const char* what, std::size_t value, const char* comment) const {
    return "  " + name_ + "_" + what + " = " + number(value) + ",  // " + comment + "\n";
  }

  void write_palette() {
    const auto& palette = info().palette;
    const std::string count = "[" + number(palette.size()) + "]";
    std::string text = "// What each colour looks like: sRGB red, green, blue.\n";
    text += "static const uint8_t " + name_ + "_palette" + count + "[3] = {\n";
    for (const PaletteEntry& entry : palette) {
      text += "  {" + std::to_string(entry.srgb[0]) + ", " + std::to_string(entry.srgb[1]) + ", " +
              std::to_string(entry.srgb[2]) + "},";
      if (!entry.name.empty()) text += "  // " + comment_text(entry.name);
      text += "\n";
    }
    text += "};\n\n// The code of each colour in the data.\n";
    text += "static const uint16_t " + name_ + "_palette_codes" + count + " = {";
    for (std::size_t i = 0; i < palette.size(); ++i) {
      text += (i % kBytesPerLine == 0 ? "\n  " : " ") + std::to_string(palette[i].code) + ",";
    }
    file().write(text + "\n};\n\n");
  }

  void write_row(std::span<const std::uint16_t> codes) override {
    pack_device_row(codes, info(), scratch_, bytes_);
    line_.clear();
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      line_ += i % kBytesPerLine == 0 ? "  0x" : " 0x";
      line_ += kDigits[bytes_[i] >> 4];
      line_ += kDigits[bytes_[i] & 15];
      line_ += ',';
      if (i % kBytesPerLine == kBytesPerLine - 1 || i + 1 == bytes_.size()) line_ += '\n';
    }
    file().write(line_);
  }

  void write_end() override { file().write("};\n"); }

  std::string name_;
  std::vector<std::uint16_t> scratch_;
  std::vector<std::uint8_t> bytes_;
  std::string line_;
};

}  // namespace

std::unique_ptr<CodeSink> open_c_header(const std::string& path, const FrameInfo& info,
                                        const FrameWriteOptions& options) {
  check_palette_codes(path, info);
  const std::size_t row_bytes = packed_row_bytes(info.layout.packing, info.width);
  if (row_bytes > kMaxArrayBytes / static_cast<std::size_t>(info.height)) {
    throw Error(ErrorKind::kMisuse, path, "the array would be longer than 256 MiB",
                "use format raw or a smaller size");
  }
  return std::make_unique<CHeaderSink>(path, info, options.replace);
}

}  // namespace tristim::detail
