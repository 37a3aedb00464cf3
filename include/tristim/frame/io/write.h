#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tristim/frame/code.h"

namespace tristim {

/// A file format for codes.
struct FrameFormat {
  std::string_view name;
  std::string_view extensions;  // separated by spaces, without the dot
  std::string_view what;
  bool indexed = false;  // holds a palette and positions in it
  bool moves = false;    // holds several pictures one after the other: FrameInfo::frames
};

/// Every format. The command line and the docs read this list.
inline constexpr FrameFormat kFrameFormats[] = {
    {"png", "png", "PNG: 1, 2, 4, 8 bits indexed or grey, 8 and 16 bits grey and RGB", true},
    {"gif", "gif", "GIF: up to 256 colours in the palette's order, also moving pictures", true,
     true},
    {"bmp", "bmp dib", "BMP: 1, 4, 8 bits indexed or grey, 24 bits RGB", true},
    {"tiff", "tif tiff", "TIFF: 1 bit (Group 4), 2 to 16 bits grey, indexed, RGB", true},
    {"pnm", "pnm pbm pgm ppm", "PBM, PGM or PPM (binary), as the codes need"},
    {"raw", "raw bin", "the bytes of the frame buffer, nothing else"},
    {"c", "h hpp c inc", "a C header: array, width, height, stride, palette"},
};

struct FrameWriteOptions {
  std::string format;  // a name of kFrameFormats; "" : by the extension of the path
  bool replace = false;
  int threads = 0;    // that compress PNG; 0: one for each processor. The bytes are the same
  int png_level = 6;  // 0..9, zlib's
};

/// Opens `path` ("-": standard output) for codes. PNG depths that a packing lacks (rgb565, gray
/// levels of 3 bits) are widened by bit replication-like rounding, c (2^8-1)/(2^b-1) + 1/2, with
/// sBIT telling the true depth.
///
/// Throws Error: kMisuse for an unknown format or one that cannot hold the codes or several
/// pictures (the text says what can); kSystem as OutputFile does.
std::unique_ptr<CodeSink> open_code_sink(const std::string& path, const FrameInfo& info,
                                         const FrameWriteOptions& options = {});

}  // namespace tristim
