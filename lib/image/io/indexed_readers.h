#pragma once

#include <optional>
#include <string>

#include "lib/image/io/readers.h"
#include "tristim/image/io/indexed.h"

namespace tristim::detail {

/// Each reads a file of its format: nothing where its pixels are no positions in a palette. Throws
/// Error (kContent).
std::optional<IndexedPicture> read_indexed_png(InputFilePtr file);
std::optional<IndexedPicture> read_indexed_gif(InputFilePtr file);
std::optional<IndexedPicture> read_indexed_bmp(InputFilePtr file);
std::optional<IndexedPicture> read_indexed_tiff(InputFilePtr file);

/// The format of a file by its first bytes, one of kSignatures in read.cpp; "" where it is unknown.
std::string sniff_format(const InputFile& file);

/// A raster for the positions of such a picture. Throws Error (kContent) where the size is no
/// picture's or needs more than kMaxHeldBytes.
Raster<std::uint8_t> position_raster(const std::string& name, std::int64_t width,
                                     std::int64_t height);

/// Throws Error (kContent): "is damaged or cut off at row 7: <why>".
[[noreturn]] void fail_at_row(const std::string& name, int row, const std::string& why);

}  // namespace tristim::detail
