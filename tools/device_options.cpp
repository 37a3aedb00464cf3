#include "tools/device_options.h"

#include "tools/outputs.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/device/display_text.h"

namespace tristim::tools {
namespace {

template <typename List>
const auto& member(const List& list, const std::string& option, const std::string& what,
                   const std::string& name) {
  const auto* item = find_by_name(list, name);
  if (item != nullptr) return *item;
  throw Error(ErrorKind::kMisuse, option, "unknown " + what + " '" + name + "'",
              name_hint(list, name));
}

// "x,y", or for a white the name of one.
Chromaticity chromaticity_option(const std::string& option, const std::string& text) {
  if (const WhitePoint* white = find_by_name(kWhitePoints, text)) return white->chromaticity;
  const std::vector<std::string_view> parts = split(text, ',');
  const auto x = parse_number(parts[0]);
  const auto y = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  if (x && y && *x >= -1 && *x <= 2 && *y >= -1 && *y <= 2 && *y != 0) return {*x, *y};
  throw Error(
      ErrorKind::kMisuse, option, "'" + text + "' is no chromaticity",
      "give x,y such as 0.64,0.33" +
          std::string(option == "--white" ? ", or one of " + list_names(kWhitePoints) : ""));
}

PanelSize size_option(const std::string& text) {
  const std::size_t x = text.find_first_of("xX");
  const auto width = x == std::string::npos ? std::nullopt : parse_integer(text.substr(0, x));
  const auto height = x == std::string::npos ? std::nullopt : parse_integer(text.substr(x + 1));
  if (width && height && *width >= 1 && *width <= 65535 && *height >= 1 && *height <= 65535) {
    return {static_cast<int>(*width), static_cast<int>(*height)};
  }
  throw Error(ErrorKind::kMisuse, "--size", "'" + text + "' is no size of a panel",
              "give WIDTHxHEIGHT in pixels, 1 to 65535: 320x240");
}

// Refuses what the reader of device files would: options that contradict each other.
void check_file(const std::string& text) {
  try {
    (void)parse_display(text, "file");
  } catch (const Error& error) {
    const std::string_view what = error.what();  // "file:<line>:<column>: ..."
    throw Error(ErrorKind::kMisuse, "options", what.substr(what.find(": ") + 2));
  }
}

}  // namespace

Packing packing_option(const std::string& name) {
  return member(kPackings, "--packing", "packing", name);
}

Primaries primaries_option(const std::string& name) {
  return member(primaries_list(), "--set", "primaries", name).primaries;
}

void declare_device_options(CommandLine& line, DeviceOptions& o) {
  line.section("Device");
  line.option("--name", "NAME", "what the device is called",
              [&](const std::string& v) { o.name = v; });
  line.option("--source", "TEXT", "where its figures come from",
              [&](const std::string& v) { o.source = v; });
  line.option(
      "--kind", list_names(kDisplayKinds, "|"), "default: emissive",
      [&](const std::string& v) { o.kind = member(kDisplayKinds, "--kind", "kind", v).kind; });
  line.option("--packing", "NAME", "of its codes: " + list_names(kPackings),
              [&](const std::string& v) { o.packing = packing_option(v); });
  line.option("--bit-order", list_names(kBitOrders, "|"), "first pixel of a byte; default: msb",
              [&](const std::string& v) {
                o.bit_order = member(kBitOrders, "--bit-order", "order", v).order;
              });
  line.option("--byte-order", list_names(kByteOrders, "|"), "of 16-bit words; default: big",
              [&](const std::string& v) {
                o.byte_order = member(kByteOrders, "--byte-order", "order", v).order;
              });
  line.option("--size", "WxH", "pixels of the panel",
              [&](const std::string& v) { o.size = size_option(v); });
  line.section("Primaries");
  line.option("--set", "NAME", "a published set (convert --list shows all); default: srgb",
              [&](const std::string& v) { o.set = primaries_option(v); });
  const auto place = [&](const std::string& option, const std::string& help,
                         std::optional<Chromaticity>& c) {
    line.option(option, "x,y", help,
                [option, &c](const std::string& v) { c = chromaticity_option(option, v); });
  };
  place("--red", "chromaticity of the red primary", o.red);
  place("--green", "of the green one", o.green);
  place("--blue", "of the blue one", o.blue);
  place("--white", "of all three together, or a name such as d65", o.white);
}

void apply_device_options(const DeviceOptions& o, Display& display) {
  if (o.name) display.name = *o.name;
  if (o.source) display.source = *o.source;
  if (o.kind) display.kind = *o.kind;
  if (o.packing) display.frame.packing = *o.packing;
  if (o.bit_order) display.frame.bit_order = *o.bit_order;
  if (o.byte_order) display.frame.byte_order = *o.byte_order;
  if (o.size) display.panel = *o.size;
  Primaries& p = display.primaries;
  p = o.set.value_or(p);
  p = {o.red.value_or(p.red), o.green.value_or(p.green), o.blue.value_or(p.blue),
       o.white.value_or(p.white)};
  (void)xyz_from_rgb(p);  // throws where they lie on a line
}

void write_device_file(const Display& display, const std::string& remarks,
                       const std::string& output, bool force) {
  const std::string text = display_text(display, remarks);
  check_file(text);
  OutputFile file(output, force);
  file.write(text);
  file.commit();
}

}  // namespace tristim::tools
