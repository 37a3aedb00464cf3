#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

// What the text says of its array, in the words that both languages have.
constexpr std::string_view kSize = "_size = ";
constexpr std::string_view kCube = "_is_cube = ";
constexpr std::string_view kChannels = "_channels = ";
constexpr std::string_view kBitsText = "_bits = ";
constexpr std::string_view kLow = "_low[3] = {";
constexpr std::string_view kHigh = "_high[3] = {";
constexpr int kFloatBits = 32;
constexpr int kMostIntegerBits = 16;

// Names are letters, digits and single '_', and do not begin with a digit.
std::string identifier(std::string_view title) {
  std::string name;
  for (const char c : title) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter || (c >= '0' && c <= '9' && !name.empty())) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "lut" : name;
}

// A title as a line comment can hold it: no backslash (nor its trigraph) that would go on.
std::string comment(std::string_view title) {
  std::string text = one_line(title);
  for (char& c : text) {
    if (c == '\\' || c == '?') c = ' ';
  }
  return text;
}

// How one of the two languages declares things.
struct Language {
  const char* head;
  const char* integer8;
  const char* integer16;
  const char* constant;  // in front of an array
  bool enumerates;       // C has no constants but those of an enum
};
constexpr Language kC{"#include <stdint.h>\n", "uint8_t", "uint16_t", "static const", true};
constexpr Language kCpp{"#include <cstdint>\n", "std::uint8_t", "std::uint16_t", "inline constexpr",
                        false};

constexpr const char* kProgmem =
    "#ifdef __AVR__\n#include <avr/pgmspace.h>\n#elif !defined(PROGMEM)\n#define PROGMEM\n#endif\n";

class Writer {
 public:
  Writer(const Lut& lut, const LutFileOptions& options, const Language& language)
      : lut_(lut), parts_(parts_of(lut)), options_(options), language_(language) {
    name_ = identifier(lut.title);
    bits_ = options.bits != 0 ? options.bits : kFloatBits;
    one_ = parts_.curves != nullptr && equal_channels(*parts_.curves);
    cube_ = parts_.cube != nullptr;
    size_ = cube_ ? parts_.cube->size : parts_.curves->size;
  }

  std::string text() {
    text_ =
        "// " + (lut_.title.empty() ? "A table" : comment(lut_.title)) + ", written by tristim.\n";
    text_ += "#pragma once\n\n" + std::string(language_.head);
    if (options_.progmem) text_ += kProgmem;
    text_ += explanation() + "\n";
    constants();
    range();
    array();
    return text_;
  }

 private:
  std::string explanation() const {
    std::string text = "\n// ";
    text += cube_ ? "A cube of _size points an edge, red fastest: entry (blue * _size + green) * "
                    "_size + red"
                  : "Entry i is the output for input low + (high - low) * i / (_size - 1)";
    text += one_ ? ", for all channels.\n" : ": red, green, blue.\n";
    if (bits_ != kFloatBits) {
      text +=
          "// Values are integers: 0 to " + std::to_string(most_of_bits(bits_)) + " is 0 to 1.\n";
    }
    return text;
  }

  void constant(std::string_view what, int value) {
    text_ += language_.enumerates ? "  " : "inline constexpr int ";
    text_ += name_ + std::string(what) + std::to_string(value);
    text_ += language_.enumerates ? ",\n" : ";\n";
  }

  void constants() {
    if (language_.enumerates) text_ += "enum {\n";
    constant(kSize, size_);
    constant(kCube, cube_ ? 1 : 0);
    constant(kChannels, one_ ? 1 : 3);
    constant(kBitsText, bits_);
    if (language_.enumerates) text_ += "};\n";
  }

  void range() {
    const LutRange& range = cube_ ? parts_.cube->range : parts_.curves->range;
    if (range == LutRange{}) return;
    for (const bool high : {false, true}) {
      const auto& ends = high ? range.high : range.low;
      text_ +=
          std::string(language_.constant) + " double " + name_ + std::string(high ? kHigh : kLow);
      text_ += shortest(ends[0]) + ", " + shortest(ends[1]) + ", " + shortest(ends[2]) + "};\n";
    }
  }

  void array() {
    const std::vector<float>& rgb = cube_ ? parts_.cube->rgb : parts_.curves->rgb;
    const char* type = bits_ == kFloatBits ? "float"
                       : bits_ > 8         ? language_.integer16
                                           : language_.integer8;
    text_ += std::string(language_.constant) + " " + type + " " + name_ + "[" +
             std::to_string(rgb.size() / 3) + (one_ ? "]" : "][3]") +
             (options_.progmem ? " PROGMEM" : "") + " = {\n";
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      text_ += one_ ? "  " : "  {";
      for (std::size_t c = 0; c < (one_ ? 1u : 3u); ++c) {
        if (c > 0) text_ += ", ";
        value(rgb[i + c]);
      }
      text_ += one_ ? ",\n" : "},\n";
    }
    text_ += "};\n";
  }

  void value(float value) {
    if (bits_ != kFloatBits) {
      text_ += std::to_string(table_code(value, most_of_bits(bits_)));
      return;
    }
    const std::size_t from = text_.size();
    append_float(text_, value);
    // "1" is an int and "1f" nothing at all
    if (text_.find_first_of(".e", from) == std::string::npos) text_ += ".0";
    text_ += 'f';
  }

  const Lut& lut_;
  LutParts parts_;
  const LutFileOptions& options_;
  const Language& language_;
  std::string name_, text_;
  int bits_ = kFloatBits;
  bool one_ = false, cube_ = false;
  int size_ = 0;
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Lut lut() {
    const bool cube = constant(kCube, 0, 1) == 1;
    const int size = constant(kSize, 2, cube ? kMostCubeSize : kMostCurveSize);
    const auto channels = static_cast<std::size_t>(constant(kChannels, 1, 3));
    bits_ = constant(kBitsText, 8, kFloatBits);
    if (bits_ != kFloatBits && bits_ > kMostIntegerBits) {
      fail("has " + std::to_string(bits_) + " bits", "integers have 8 to 16, floats 32");
    }
    if (channels == 2) fail("has two channels", "it is one or three");
    const std::size_t samples = cube ? cube_samples(size) : curve_samples(size);
    LutRange range;
    range.low = ends(kLow, range.low);
    range.high = ends(kHigh, range.high);
    std::vector<float> rgb = numbers(channels == 1 ? samples / 3 : samples);
    if (channels == 1) rgb = repeated(rgb);
    if (cube) return {"", {Lut3D{range, size, std::move(rgb)}}};
    return {"", {Lut1D{range, size, std::move(rgb)}}};
  }

 private:
  [[noreturn]] void fail(const std::string& wrong, std::string_view remedy = {}) const {
    throw Error(ErrorKind::kContent, file_ + ", byte " + std::to_string(at_), wrong, remedy);
  }

  static bool is_number_part(char c) {
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E' ||
           c == 'n' || c == 'a' || c == 'i';  // of inf and nan, to be refused
  }

  std::string_view word_at(std::size_t from) const {
    std::size_t end = from;
    while (end < text_.size() && is_number_part(text_[end])) ++end;
    return text_.substr(from, end - from);
  }

  int constant(std::string_view what, int least, int most) {
    at_ = std::min(text_.find(what), text_.size());
    if (at_ == text_.size()) {
      fail("has no '" + std::string(what) + "'", "only headers that tristim wrote are read");
    }
    const auto value = parse_integer(word_at(at_ + what.size()));
    if (!value || *value < least || *value > most) {
      fail("'" + std::string(what) + "' is out of range",
           "it is from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return static_cast<int>(*value);
  }

  std::array<double, 3> ends(std::string_view what, const std::array<double, 3>& absent) {
    const std::size_t found = text_.find(what);
    if (found == std::string_view::npos) return absent;
    at_ = found + what.size();
    std::array<double, 3> values{};
    for (double& value : values) {
      at_ = text_.find_first_not_of(", ", at_);
      const std::string_view word = at_ < text_.size() ? word_at(at_) : std::string_view();
      const auto number = parse_number(word);
      if (!number) fail("the ends of the range are no three numbers");
      value = *number;
      at_ += word.size();
    }
    return values;
  }

  // The numbers of the array: what lies between them is not looked at.
  std::vector<float> numbers(std::size_t count) {
    constexpr std::string_view kBegin = " = {\n";
    at_ = text_.rfind(kBegin);
    if (at_ == std::string_view::npos) at_ = text_.size();
    if (count > (text_.size() - at_) / 2) {
      fail("promises " + std::to_string(count) + " numbers, but only " +
           std::to_string(text_.size() - at_) + " bytes follow");
    }
    at_ += kBegin.size();
    std::vector<float> values;
    values.reserve(count);
    const float scale = bits_ == kFloatBits ? 1.0F : static_cast<float>(most_of_bits(bits_));
    while (values.size() < count) {
      at_ = text_.find_first_not_of("{}, \n\rf", at_);
      if (at_ >= text_.size() || text_[at_] == ';') {
        at_ = std::min(at_, text_.size());
        fail("the array ends after " + std::to_string(values.size()) + " of " +
             std::to_string(count) + " numbers");
      }
      const std::string_view word = word_at(at_);
      const auto value = finite_float(word);
      if (!value) fail("is no finite number");
      values.push_back(*value / scale);
      at_ += word.size();
    }
    at_ = text_.find_first_not_of("{}, \n\rf", at_);
    if (at_ >= text_.size() || text_[at_] != ';')
      fail("the array has more numbers than _size says");
    return values;
  }

  static std::vector<float> repeated(const std::vector<float>& one) {
    std::vector<float> rgb;
    rgb.reserve(3 * one.size());
    for (const float value : one) rgb.insert(rgb.end(), 3, value);
    return rgb;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int bits_ = kFloatBits;
};

}  // namespace

// Headers of write_c_lut and write_cpp_lut.
Lut read_c_lut(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  return Reader(bytes, file).lut();
}

std::string write_c_lut(const Lut& lut, const LutFileOptions& options) {
  return Writer(lut, options, kC).text();
}

std::string write_cpp_lut(const Lut& lut, const LutFileOptions& options) {
  return Writer(lut, options, kCpp).text();
}

}  // namespace tristim::detail
