// Lays pictures with captions on one dark sheet:
//
//   contact_sheet -o sheet.png --columns 4 --title "Seven devices" $'sRGB monitor\n8 bits=srgb.png'
//   ...
//
// Pictures are read as linear light, whatever their format, scaled down and laid out in light, and
// encoded once at the end. The first line of a caption is its name, further lines are set smaller.

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/fit.h"
#include "tristim/image/flatten.h"
#include "tristim/image/io/read.h"

namespace {

using namespace tristim;

// Sizes in pixels, shades as codes of sRGB.
constexpr int kMargin = 56;
constexpr int kGutter = 32;
constexpr int kTitleSize = 34;
constexpr int kTitleSpace = 84;  // from the margin to the first row of pictures
constexpr int kNameSize = 18;
constexpr int kNoteSize = 14;
constexpr int kCaptionGap = 14;  // from a picture to the top of its caption
constexpr int kLine = 22;
constexpr int kSheet = 24, kMat = 31, kTitle = 236, kName = 222, kNote = 148;

float light_of(int code) { return static_cast<float>(srgb_decode(code / 255.0)); }

struct Entry {
  std::vector<std::string> lines;
  std::string path;
};

struct Settings {
  std::string output;
  std::string title;
  int columns = 4;
  int picture_width = 440;
  bool replace = false;
  std::vector<Entry> entries;
};

[[noreturn]] void misuse(std::string_view thing, std::string_view wrong) {
  throw Error(
      ErrorKind::kMisuse, thing, wrong,
      "use: contact_sheet -o SHEET.png [--columns N] [--width PIXELS] [--title TEXT] [--force] "
      "CAPTION=PICTURE ...");
}

int number_of(std::string_view option, std::string_view text, int least, int most) {
  const auto value = parse_integer(text);
  if (!value || *value < least || *value > most) {
    misuse(option, "expects " + std::to_string(least) + " to " + std::to_string(most));
  }
  return static_cast<int>(*value);
}

Entry entry_of(std::string_view argument) {
  const std::size_t equals = argument.rfind('=');
  if (equals == std::string_view::npos) misuse(argument, "is no CAPTION=PICTURE");
  Entry entry;
  for (std::string_view line : split(argument.substr(0, equals), '\n'))
    entry.lines.emplace_back(line);
  entry.path = argument.substr(equals + 1);
  return entry;
}

Settings settings_of(const std::vector<std::string_view>& arguments) {
  Settings settings;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view option = arguments[i];
    if (option == "--force") {
      settings.replace = true;
    } else if (!option.starts_with('-')) {
      settings.entries.push_back(entry_of(option));
    } else {
      if (++i == arguments.size()) misuse(option, "has no value");
      const std::string_view value = arguments[i];
      if (option == "-o") {
        settings.output = value;
      } else if (option == "--title") {
        settings.title = value;
      } else if (option == "--columns") {
        settings.columns = number_of(option, value, 1, 32);
      } else if (option == "--width") {
        settings.picture_width = number_of(option, value, 16, 4096);
      } else {
        misuse(option, "is no option");
      }
    }
  }
  if (settings.output.empty()) misuse("-o", "is missing");
  if (settings.entries.empty() || settings.entries.size() > 1024) {
    misuse("CAPTION=PICTURE", "expected 1 to 1024");
  }
  return settings;
}

// A face of DejaVu Sans.
class Font {
 public:
  Font(FT_Library library, const std::string& file) {
    for (const char* folder :
         {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
          "/usr/share/fonts/dejavu", "/usr/share/fonts/TTF", "/usr/local/share/fonts"}) {
      const std::string path = std::string(folder) + "/" + file;
      FT_Face face = nullptr;
      if (std::filesystem::exists(path) && FT_New_Face(library, path.c_str(), 0, &face) == 0) {
        face_.reset(face);
        return;
      }
    }
    throw Error(ErrorKind::kSystem, file, "not found among the system's fonts",
                "install DejaVu Sans (Debian: fonts-dejavu-core)");
  }

  // Calls `pixel(x, y, coverage)` for the text's pixels; x from the text's start, y from its base
  // line. Returns the width.
  template <class F>
  int set(std::string_view text, int size, F&& pixel) const {
    FT_Set_Pixel_Sizes(face_.get(), 0, static_cast<FT_UInt>(size));
    int x = 0;
    FT_UInt before = 0;
    for (std::size_t i = 0; i < text.size();) {
      const FT_UInt glyph = FT_Get_Char_Index(face_.get(), next_character(text, i));
      FT_Vector kerning{};
      FT_Get_Kerning(face_.get(), before, glyph, FT_KERNING_DEFAULT, &kerning);
      x += static_cast<int>(kerning.x >> 6);
      before = glyph;
      if (FT_Load_Glyph(face_.get(), glyph, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) continue;
      const FT_GlyphSlot slot = face_->glyph;
      const FT_Bitmap& bitmap = slot->bitmap;
      for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
        for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
          pixel(x + slot->bitmap_left + column, row - slot->bitmap_top,
                static_cast<float>(bitmap.buffer[row * bitmap.pitch + column]) / 255);
        }
      }
      x += static_cast<int>(slot->advance.x >> 6);
    }
    return x;
  }

  int width(std::string_view text, int size) const {
    return set(text, size, [](int, int, float) {});
  }

 private:
  static FT_ULong next_character(std::string_view utf8, std::size_t& i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(utf8[at]); };
    const unsigned char first = byte(i++);
    const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    FT_ULong character = more == 0 ? first : first & (0x3fU >> more);
    for (int k = 0; k < more && i < utf8.size(); ++k)
      character = character << 6 | (byte(i++) & 0x3fU);
    return character;
  }

  struct Done {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  std::unique_ptr<FT_FaceRec_, Done> face_;
};

// As much of the text as fits, with an ellipsis where it is cut.
std::string cut_to(const Font& font, std::string text, int size, int width) {
  if (font.width(text, size) <= width) return text;
  while (!text.empty() && font.width(text + "…", size) > width) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80)
      text.pop_back();
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

void draw_text(ImageView<float> sheet, const Font& font, std::string_view text, int size, int x0,
               int base, int code) {
  const float ink = light_of(code);
  font.set(text, size, [&](int x, int y, float coverage) {
    if (x0 + x < 0 || x0 + x >= sheet.width || base + y < 0 || base + y >= sheet.height) return;
    float* pixel = sheet.pixel(x0 + x, base + y);
    for (int c = 0; c < 3; ++c) pixel[c] += coverage * (ink - pixel[c]);
  });
}

// Reads a picture into `frame`, all of it, centred, as light of sRGB's primaries.
void draw_picture(ImageView<float> frame, const std::string& path) {
  auto source = flatten(open_picture(path), {}, nullptr);
  const Primaries primaries = source->info().primaries;
  const Eigen::Matrix3d to_srgb = rgb_from_rgb({}, primaries, Adaptation::kBradford);
  const Eigen::Vector3d background = rgb_from_rgb(primaries, {}, Adaptation::kBradford) *
                                     Eigen::Vector3d::Constant(light_of(kMat));
  FitOptions options;
  options.width = frame.width;
  options.height = frame.height;
  options.background = {background.x(), background.y(), background.z()};
  fit(std::move(source), options)->read(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      float* pixel = frame.pixel(x, y);
      const Eigen::Vector3d rgb = to_srgb * Eigen::Vector3d(pixel[0], pixel[1], pixel[2]);
      for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(rgb[c]);
    }
  }
}

struct Layout {
  int picture_height, cell_height, width, height;
};

// All frames have the shape of the first picture.
Layout layout_of(const Settings& settings) {
  const PictureInfo first = open_picture(settings.entries[0].path)->info();
  const double shape = first.height / (first.width * first.pixel_aspect);
  std::size_t lines = 0;
  for (const Entry& entry : settings.entries) lines = std::max(lines, entry.lines.size());
  const int count = static_cast<int>(settings.entries.size());
  const int columns = std::min(settings.columns, count);
  const int rows = (count + columns - 1) / columns;
  Layout layout{};
  const double width = settings.picture_width;
  layout.picture_height = static_cast<int>(std::lround(std::clamp(width * shape, 1.0, 4 * width)));
  layout.cell_height = layout.picture_height + kCaptionGap + kLine * static_cast<int>(lines);
  layout.width = 2 * kMargin + columns * settings.picture_width + (columns - 1) * kGutter;
  layout.height = 2 * kMargin + (settings.title.empty() ? 0 : kTitleSpace) +
                  rows * layout.cell_height + (rows - 1) * kGutter;
  return layout;
}

void draw_sheet(ImageView<float> sheet, const Settings& settings, const Layout& layout,
                const Font& regular, const Font& bold) {
  std::fill(sheet.data, sheet.data + sheet.height * sheet.stride, light_of(kSheet));
  int top = kMargin;
  if (!settings.title.empty()) {
    draw_text(sheet, bold, cut_to(bold, settings.title, kTitleSize, sheet.width - 2 * kMargin),
              kTitleSize, kMargin - 2, top + kTitleSize - 6, kTitle);
    top += kTitleSpace;
  }
  for (std::size_t i = 0; i < settings.entries.size(); ++i) {
    const Entry& entry = settings.entries[i];
    const int column = static_cast<int>(i) % settings.columns;
    const int row = static_cast<int>(i) / settings.columns;
    const int x = kMargin + column * (settings.picture_width + kGutter);
    const int y = top + row * (layout.cell_height + kGutter);
    draw_picture(
        {sheet.pixel(x, y), settings.picture_width, layout.picture_height, 3, sheet.stride},
        entry.path);
    int base = y + layout.picture_height + kCaptionGap + kNameSize - 3;
    for (std::size_t line = 0; line < entry.lines.size(); ++line, base += kLine) {
      const Font& font = line == 0 ? bold : regular;
      const int size = line == 0 ? kNameSize : kNoteSize;
      draw_text(sheet, font, cut_to(font, entry.lines[line], size, settings.picture_width), size, x,
                base, line == 0 ? kName : kNote);
    }
  }
}

void write_sheet(ImageView<const float> sheet, const Settings& settings) {
  FrameInfo info;
  info.width = sheet.width;
  info.height = sheet.height;
  info.srgb = true;
  FrameWriteOptions options;
  options.replace = settings.replace;
  const auto sink = open_code_sink(settings.output, info, options);

  std::array<float, 255> half_way;  // the light from which on the next code is nearer
  for (std::size_t i = 0; i < half_way.size(); ++i) {
    half_way[i] = static_cast<float>(srgb_decode((static_cast<double>(i) + 0.5) / 255));
  }
  Raster<std::uint16_t> codes(sheet.width, 1, 3);
  for (int y = 0; y < sheet.height; ++y) {
    std::ranges::transform(sheet.row(y), codes.view().data, [&](float light) {
      return static_cast<std::uint16_t>(std::ranges::upper_bound(half_way, light) -
                                        half_way.begin());
    });
    sink->write(codes.view());
  }
  sink->finish();
}

struct FreeType {
  FT_Library library = nullptr;
  FreeType() {
    if (FT_Init_FreeType(&library) != 0) {
      throw Error(ErrorKind::kSystem, "FreeType", "cannot be started");
    }
  }
  ~FreeType() { FT_Done_FreeType(library); }
  FreeType(const FreeType&) = delete;
  FreeType& operator=(const FreeType&) = delete;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    const Settings settings = settings_of({argv + 1, argv + argc});
    const FreeType freetype;
    const Font regular(freetype.library, "DejaVuSans.ttf");
    const Font bold(freetype.library, "DejaVuSans-Bold.ttf");
    const Layout layout = layout_of(settings);
    Image sheet(layout.width, layout.height, 3);
    draw_sheet(sheet.view(), settings, layout, regular, bold);
    write_sheet(sheet.view(), settings);
    return 0;
  } catch (const tristim::Error& error) {
    std::fprintf(stderr, "contact_sheet: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "contact_sheet: %s\n", error.what());
    return 1;
  }
}
