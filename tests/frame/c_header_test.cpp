#include <gtest/gtest.h>

#include <sstream>

#include "tests/frame/frames.h"
#include "tests/support.h"

namespace tristim {
namespace {

/// The lines of the header's comment that read a pixel.
std::string reading_lines(const std::string& header) {
  std::istringstream lines(header);
  std::string found;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("//   ", 0) == 0) found += line.substr(5) + "\n";
  }
  return found;
}

/// A C program that prints every pixel of the headers it is made of, one row a line, by what their
/// comments say.
class Program {
 public:
  void add(const std::string& identifier, const std::string& header, const FrameInfo& info) {
    const bool rgb = info.layout.packing.samples == 3;
    includes_ += "#include \"" + identifier + ".h\"\n";
    body_ += "for (int y = 0; y < " + identifier + "_height; ++y) {\n";
    body_ += "for (int x = 0; x < " + identifier + "_width; ++x) {\n" + reading_lines(header);
    body_ += rgb ? "printf(\"%u %u %u \", red, green, blue);\n" : "printf(\"%u \", code);\n";
    body_ += "}\nprintf(\"\\n\");\n}\n";
    body_ += "printf(\"%d %d %s\\n\", (int)sizeof " + identifier + "_data / " + identifier +
             "_height, " + identifier + "_bits, " + identifier + "_packing);\n";
    if (info.palette.empty()) return;
    body_ += "for (int i = 0; i < " + identifier + "_colors; ++i) printf(\"%d %d %d %d\\n\", " +
             identifier + "_palette[i][0], " + identifier + "_palette[i][1], " + identifier +
             "_palette[i][2], " + identifier + "_palette_codes[i]);\n";
  }

  std::string text() const {
    return "#include <stdio.h>\n" + includes_ + "int main(void) {\n" + body_ + "return 0;\n}\n";
  }

 private:
  std::string includes_;
  std::string body_;
};

/// What the program prints of one header.
std::string expected_text(const TestFrame& frame, std::size_t stride) {
  std::ostringstream text;
  const FrameInfo& info = frame.info;
  for (int y = 0; y < info.height; ++y) {
    for (const std::uint16_t code : frame.view().row(y)) {
      text << (info.palette.empty() ? code : info.palette[code].code) << ' ';
    }
    text << '\n';
  }
  text << stride << ' ' << info.layout.packing.bits_per_pixel() << ' ' << info.layout.packing.name
       << '\n';
  for (const PaletteEntry& entry : info.palette) {
    text << int{entry.srgb[0]} << ' ' << int{entry.srgb[1]} << ' ' << int{entry.srgb[2]} << ' '
         << entry.code << '\n';
  }
  return text.str();
}

/// A frame of every packing in every order, and palettes.
std::vector<TestFrame> all_frames() {
  std::vector<TestFrame> frames;
  for (const Packing& packing : kPackings) {
    for (const BitOrder bit_order : {BitOrder::kMsb, BitOrder::kLsb}) {
      for (const ByteOrder byte_order : {ByteOrder::kBig, ByteOrder::kLittle}) {
        FrameInfo info = frame_info(packing.name, 19, 3);
        info.layout.bit_order = bit_order;
        info.layout.byte_order = byte_order;
        info.device = "A \"device\" */ with \\";
        if (packing.indexed) info.palette = test_palette(packing.bits[0] * 2, packing.bits[0]);
        frames.push_back(random_frame(info));
      }
    }
  }
  return frames;
}

TEST(CHeaderWriter, IsReadByCAndCxxAsItsCommentSays) {
  if (run_command({"cc", "--version"}).exit_code != 0) GTEST_SKIP() << "no cc";
  const TemporaryDirectory directory;
  Program program;
  std::string expected;
  for (const TestFrame& frame : all_frames()) {
    const std::string identifier = "f" + std::to_string(expected.size());
    const std::string path = directory.file(identifier + ".h");
    write_frame(frame, path);
    program.add(identifier, read_bytes(path), frame.info);
    const int bits = frame.info.layout.packing.bits_per_pixel();
    const std::size_t stored = bits == 15 || bits == 12 ? 16 : static_cast<std::size_t>(bits);
    expected += expected_text(frame, (19 * stored + 7) / 8);
  }
  write_bytes(directory.path() / "main.c", program.text());
  const std::vector<std::vector<std::string>> compilers = {{"cc", "-std=c99", "-x", "c"},
                                                           {"c++", "-std=c++11", "-x", "c++"}};
  for (std::vector<std::string> command : compilers) {
    SCOPED_TRACE(command[0]);
    for (const char* argument : {"-Wall", "-Wextra", "-pedantic", "-Werror", "-o"}) {
      command.push_back(argument);
    }
    command.push_back(directory.file("main"));
    command.push_back(directory.file("main.c"));
    const CommandResult compiled = run_command(command);
    ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
    const CommandResult printed = run_command({directory.file("main")});
    EXPECT_EQ(printed.exit_code, 0);
    EXPECT_TRUE(printed.out == expected) << printed.out;
  }
}

TEST(CHeaderWriter, IsPlainText) {
  const TemporaryDirectory directory;
  FrameInfo info = frame_info("index2", 5, 2);
  info.device = "panel";
  info.palette = {{{0, 0, 0}, 3, "black"}, {{255, 255, 255}, 0, ""}};
  write_frame({info, {0, 0, 1, 1, 0, 1, 1, 1, 0, 0}}, directory.file("My panel-2.h"));
  EXPECT_EQ(read_bytes(directory.file("My panel-2.h")),
            R"(#pragma once

#include <stdint.h>

// 5x2 pixels for panel, written by tristim.
// Packing index2: 2 bits a pixel, the first pixel of a byte in its most significant bits; each row starts in a new byte.
// To read the pixel in column x and row y:
//   const uint8_t* p = My_panel_2_data + (uint32_t)y * My_panel_2_stride + x / 4;
//   unsigned code = *p >> (6 - x % 4 * 2) & 3;
enum {
  My_panel_2_width = 5,  // pixels
  My_panel_2_height = 2,  // rows
  My_panel_2_stride = 2,  // bytes from one row to the next
  My_panel_2_bits = 2,  // of a pixel
  My_panel_2_colors = 2,  // of the palette
};

static const char My_panel_2_packing[] = "index2";

// What each colour looks like: sRGB red, green, blue.
static const uint8_t My_panel_2_palette[2][3] = {
  {0, 0, 0},  // black
  {255, 255, 255},
};

// The code of each colour in the data.
static const uint16_t My_panel_2_palette_codes[2] = {
  3, 0,
};

static const uint8_t My_panel_2_data[4] = {
  0xf0, 0xc0,
  0x03, 0xc0,
};
)");
}

TEST(CHeaderWriter, NamesItsIdentifiersAfterTheFile) {
  const TemporaryDirectory directory;
  const std::pair<const char*, const char*> cases[] = {
      {"__a__b_.h", "a_b_width"}, {"7seg.h", "frame_7seg_width"}, {"\xc3\xa4.h", "frame_width"},
      {"int.h", "int_width"},     {"a.b.hpp", "a_b_width"},
  };
  for (const auto& [name, identifier] : cases) {
    SCOPED_TRACE(name);
    write_frame(random_frame(frame_info("gray8", 1, 1)), directory.file(name));
    EXPECT_NE(read_bytes(directory.file(name)).find("  " + std::string(identifier) + " = 1,"),
              std::string::npos);
  }
}

TEST(CHeaderWriter, RefusesArraysThatNoCompilerTakes) {
  const Error error(ErrorKind::kMisuse, "a.h", "the array would be longer than 256 MiB",
                    "use format raw or a smaller size");
  EXPECT_EQ(open_error(frame_info("rgb48", 1 << 16, 1 << 16), "a.h"),
            "2 " + std::string(error.what()));
}

}  // namespace
}  // namespace tristim
