#include <algorithm>

#include "tools/outputs.h"
#include "tools/palette_actions.h"
#include "tools/palette_source.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/palette/io/file.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim palette convert vga16 vga.gpl\n"
    "  tristim palette convert vga16 vga.act && tristim palette convert vga.act vga.json\n"
    "  tristim palette convert epaper-7color panel.toml\n"
    "  tristim palette convert vga16 --format hex -\n";

struct Options {
  std::vector<std::string> words;
  std::string format, from;
  bool json = false, force = false;
};

std::string format_list() {
  std::string all;
  for (const PaletteFormat& format : palette_formats()) {
    if (!all.empty()) all += ", ";
    all += std::string(format.name) + " (" + std::string(format.what) + ")";
  }
  return all;
}

// What the file does not keep of the palette.
std::vector<std::string> losses(const Palette& palette, const PaletteFormat& format) {
  const auto& colors = palette.colors;
  std::vector<std::string> lost;
  const auto any = [&](auto&& is) { return std::ranges::any_of(colors, is); };
  if (!format.keeps_names && any([](const auto& c) { return !c.name.empty(); })) {
    lost.emplace_back("names");
  }
  if (!format.keeps_alpha && any([](const auto& c) { return c.alpha < 1; })) {
    lost.emplace_back("alpha");
  }
  const auto moved = [&, i = std::uint16_t{0}](const auto& c) mutable {
    return c.code && *c.code != i++;
  };
  if (!format.keeps_codes && any(moved)) lost.emplace_back("device codes");
  if (format.bits == 8 && any([](const auto& c) { return !is_8_bits(c.color); })) {
    lost.emplace_back("what is finer than 8 bits");
  }
  return lost;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

void run_palette_convert(Arguments arguments) {
  Options options;
  CommandLine line(palette_action("convert"), kExamples);
  line.positional("P OUT",
                  "a palette (a file, a device or a picture; - is standard input), and the file to "
                  "write, in the format of its extension; - is standard output",
                  options.words, 2, 2);
  line.option("--format", "F", "of the result: " + format_list(), options.format);
  line.option("--from", "F", "format of the palette, where neither bytes nor name tell it",
              options.from);
  line.flag("--json", "print the facts as JSON", options.json);
  line.flag("-f,--force", "replace an existing file", options.force);
  if (!line.parse(arguments)) return;
  const std::string& output = options.words[1];
  if (output == "-" && options.json) {
    throw Error(ErrorKind::kMisuse, "--json", "standard output is taken by the palette",
                "write the palette to a file");
  }
  const PaletteFormat& format = palette_format_of(output, options.format);
  refuse_inputs_as_outputs({options.words[0]}, {output});
  refuse_taken_outputs({output}, options.force);
  const Palette palette = options.from.empty()
                              ? load_palette({options.words[0]}, "palette convert").palette
                              : read_palette(options.words[0], options.from);
  OutputFile file(output, options.force);
  file.write(palette_bytes(palette, format, output));
  file.commit();
  const std::vector<std::string> lost = losses(palette, format);
  if (options.json) {
    print(json_line({{"palette", options.words[0]},
                     {"output", output},
                     {"format", format.name},
                     {"colors", palette.colors.size()},
                     {"lost", lost}}));
  } else if (!lost.empty()) {
    note(output + ": note: format " + std::string(format.name) + " does not keep " + joined(lost));
  }
}

}  // namespace tristim::tools
