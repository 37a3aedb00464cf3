#pragma once

#include <openexr.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/image/io/pixel_window.h"
#include "lib/image/io/readers.h"
#include "tristim/color/primaries.h"

namespace tristim::detail {

struct ExrChannel {
  std::string name;
  exr_pixel_type_t type = EXR_PIXEL_HALF;
  bool subsampled = false;
};

/// What the header says of one part.
struct ExrPart {
  int index = 0;
  std::string name;
  bool deep = false;
  bool tiled = false;
  std::string compression;
  std::vector<ExrChannel> channels;  // in the file's order
  PixelWindow data;
  PixelWindow display;
  double pixel_aspect = 1;
  std::optional<Primaries> chromaticities;
  std::optional<Chromaticity> adopted_neutral;
  int chunk_width = 0;  // pixels of a tile; of a row where it is not tiled
  int chunk_rows = 1;
};

/// A file opened by OpenEXR's core library, which prints nothing here. Several threads may read its
/// chunks.
class ExrFile {
 public:
  /// Throws Error (kContent) where the header is damaged.
  explicit ExrFile(InputFilePtr file);
  ~ExrFile();
  ExrFile(const ExrFile&) = delete;
  ExrFile& operator=(const ExrFile&) = delete;

  exr_const_context_t context() const noexcept { return context_; }
  const InputFile& file() const noexcept { return *file_; }
  int part_count() const;

  /// Throws Error (kContent) where the part's header is damaged.
  ExrPart part(int index) const;

 private:
  void check(exr_result_t result) const;
  void read_windows(ExrPart& part) const;
  void read_channels(ExrPart& part) const;
  void read_colour(ExrPart& part) const;
  void read_chunks(ExrPart& part) const;

  InputFilePtr file_;
  exr_context_t context_ = nullptr;
};

}  // namespace tristim::detail
