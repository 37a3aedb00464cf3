#include "tristim/device/display_text.h"

#include <algorithm>
#include <stdexcept>

#include "tristim/core/text.h"
#include "tristim/device/channels.h"

namespace tristim {
namespace {

std::string quoted(const std::string& text) {
  constexpr const char* kHex = "0123456789abcdef";
  std::string literal = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      literal += std::string("\\") + c;
    } else if (byte < 32 || byte == 127) {
      literal += std::string("\\u00") + kHex[byte >> 4] + kHex[byte & 15];
    } else {
      literal += c;
    }
  }
  return literal + "\"";
}

// One "key = value  # comment" a line, the comments below each other.
class Section {
 public:
  explicit Section(const std::string& title) : text_(title.empty() ? "" : "\n" + title + "\n") {}

  void add(const std::string& key, const std::string& value, const std::string& comment = {}) {
    std::string line = key;
    line.resize(std::max<std::size_t>(line.size(), kKeys), ' ');
    line += " = " + value;
    if (!comment.empty()) {
      line.resize(std::max(line.size() + 2, kComments), ' ');
      line += "# " + comment;
    }
    text_ += line + "\n";
  }
  void add(const std::string& key, double value, const std::string& comment = {}) {
    add(key, shortest(value), comment);
  }

  const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t kKeys = 10, kComments = 36;
  std::string text_;
};

std::string array(std::initializer_list<double> values) {
  std::string text = "[";
  for (const double v : values) text += (text.size() > 1 ? ", " : "") + shortest(v);
  return text + "]";
}

std::string xy(Chromaticity c) { return array({c.x, c.y}); }

template <typename List, typename Match>
std::string named(const List& list, Match&& match) {
  for (const auto& item : list) {
    if (match(item)) return quoted(std::string(item.name));
  }
  return {};
}

std::string white_value(Chromaticity white) {
  const std::string name =
      named(kWhitePoints, [&](const WhitePoint& w) { return w.chromaticity == white; });
  return name.empty() ? xy(white) : name;
}

std::string frame_text(const FrameLayout& frame) {
  Section section("[frame_buffer]");
  section.add("packing", quoted(std::string(frame.packing.name)),
              std::to_string(frame.packing.bits_per_pixel()) + " bits a pixel");
  section.add("bit_order",
              named(kBitOrders, [&](const NamedBitOrder& b) { return b.order == frame.bit_order; }),
              "which pixel of a byte comes first");
  section.add(
      "byte_order",
      named(kByteOrders, [&](const NamedByteOrder& b) { return b.order == frame.byte_order; }),
      "of 16-bit words");
  section.add("store", named(kStores, [&](const NamedStore& s) { return s.store == frame.store; }),
              "value: the code itself; index: the level, its code in the colour table");
  return section.text();
}

std::string primaries_text(const Primaries& primaries) {
  Section section("[primaries]");
  const bool srgb = primaries == Primaries{};  // bt709 has the same
  const std::string set = named(primaries_list(), [&](const NamedPrimaries& p) {
    return p.primaries == primaries && (!srgb || p.name == "srgb");
  });
  if (!set.empty()) {
    section.add("set", set);
    return section.text();
  }
  section.add("red", xy(primaries.red), "chromaticities x, y");
  section.add("green", xy(primaries.green));
  section.add("blue", xy(primaries.blue));
  section.add("white", white_value(primaries.white), "of all three at their highest code");
  return section.text();
}

void add_figures(Section&, const SrgbResponse&) {}
void add_figures(Section&, const LinearResponse&) {}
void add_figures(Section& section, const GammaResponse& r) {
  section.add("gamma", r.gamma, "I = i0 + (1 - i0) K V^gamma");
  section.add("i0", r.i0, "light of code 0, relative to the white");
  if (r.k > 0) section.add("k", r.k, "K; Vmax^-gamma where it is absent");
}
void add_figures(Section& section, const Bt1886Response& r) {
  section.add("black", r.black, "luminance of the black over that of the white");
}
void add_figures(Section& section, const GogResponse& r) {
  section.add("gamma", r.gamma, "I = black + (1 - black) max(gain V/Vmax + offset, 0)^gamma");
  section.add("offset", r.offset, "gain = 1 - offset");
  section.add("black", r.black, "light that no code takes away, relative to the white");
}
void add_figures(Section& section, const TableResponse& r) {
  if (r.code_max > 0) section.add("code_max", r.code_max, "the highest code as the table counts");
  std::string rows = "[";
  for (std::size_t i = 0; i < r.code.size(); ++i) {
    rows += (i % 4 == 0 ? "\n  " : " ") + array({r.code[i], r.luminance[i]}) + ",";
  }
  section.add("table", rows + "\n]");
}

std::string response_text(const std::string& title, const Response& response) {
  Section section(title);
  section.add("kind", quoted(std::string(kind_of(response))));
  std::visit([&](const auto& r) { add_figures(section, r); }, response);
  return section.text();
}

std::string responses_text(const Display& display) {
  std::string text = response_text("[response]", display.response);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& own = display.channel_response[c];
    if (own) text += response_text("[response." + std::string(kChannelNames[c]) + "]", *own);
  }
  return text;
}

std::string levels_text(const LevelTable& levels) {
  Section section("[levels]");
  section.add("n", levels.n, "levels 0 to n");
  section.add("i0", levels.i0, "the lowest intensity");
  section.add("spacing", quoted(std::string(spacing_of(levels).name)),
              std::string(spacing_of(levels).formula));
  section.add("gamma", levels.gamma, "of the spacing gamma");
  section.add("peak", levels.peak_cd_m2, "cd/m2, of the spacing pq");
  section.add("from_zero", levels.from_zero ? "true" : "false", "whether level 0 is no light");
  return section.text();
}

void add_gain(Section&, const NoGain&) {}
void add_gain(Section& section, const MurrayDaviesGain& g) {
  section.add("gain", g.at_half, "area gained at half tone");
}
void add_gain(Section& section, const YuleNielsenGain& g) {
  section.add("yule_nielsen", g.n);
  section.add("solid", g.solid, "light of the solid, relative to the paper");
}
void add_gain(Section& section, const MeasuredGain& g) {
  std::string rows = "[";
  for (std::size_t i = 0; i < g.asked.size(); ++i) {
    rows += (i % 4 == 0 ? "\n  " : " ") + array({g.asked[i], g.covered[i]}) + ",";
  }
  section.add("gain_table", rows + "\n]");
}

std::string dots_text(const Dots& dots) {
  Section section("[dots]");
  section.add("dpi", dots.dpi, "dots an inch; 0: not known");
  section.add("lpi", dots.lpi, "ruling of screens; 0: the usual");
  section.add("isolated", dots.isolated ? "true" : "false", "whether a single dot holds");
  std::visit([&](const auto& gain) { add_gain(section, gain); }, dots.gain);
  return section.text();
}

std::string viewing_text(const Display& display) {
  Section section("[viewing]");
  section.add("white", white_value(display.viewing_white), "under which the palette is seen");
  section.add("adapt", named(kAdaptations, [&](const AdaptationMethod& a) {
                return a.method == display.adaptation;
              }));
  return section.text();
}

std::string palette_text(const std::vector<CodeColor>& palette) {
  std::string text;
  for (const CodeColor& entry : palette) {
    Section section("[[palette]]");
    section.add("code", entry.code);
    const Xyz& c = entry.appearance;
    section.add("xyz", array({c.x, c.y, c.z}));
    if (!entry.name.empty()) section.add("name", quoted(entry.name));
    text += section.text();
  }
  return text;
}

}  // namespace

std::string display_text(const Display& display, const std::string& remarks) {
  if (display.press) throw std::invalid_argument("display: a press has no device file of its own");
  std::string text;
  for (const std::string_view line : split(remarks, '\n')) {
    if (!line.empty()) text += "# " + std::string(line) + "\n";
  }
  Section head("");
  head.add("name", quoted(display.name));
  head.add("source", quoted(display.source));
  head.add("kind",
           named(kDisplayKinds, [&](const NamedDisplayKind& k) { return k.kind == display.kind; }),
           "emissive, reflective or print");
  text += head.text() + frame_text(display.frame);
  if (display.panel) {
    Section panel("[panel]");
    panel.add("size", array({double(display.panel->width), double(display.panel->height)}),
              "width and height in pixels");
    text += panel.text();
  }
  text += primaries_text(display.primaries);
  if (!display.palette.empty()) {
    return text + viewing_text(display) + (display.dots ? dots_text(*display.dots) : "") +
           palette_text(display.palette);
  }
  text += responses_text(display);
  if (display.levels) text += levels_text(*display.levels);
  return display.dots ? text + dots_text(*display.dots) : text;
}

}  // namespace tristim
