#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lib/image/io/input_file.h"
#include "tristim/image/io/read.h"

namespace tristim::detail {

/// What a reader makes of a file: its facts, and its rows where it has some.
struct OpenedPicture {
  PictureFacts facts;
  std::unique_ptr<RowSource> rows;  // null: the file has no picture in what was asked for
  std::string why_no_rows;          // then: what is wrong ...
  std::string remedy;               // ... and what to do
};

using InputFilePtr = std::shared_ptr<const InputFile>;

/// Each throws Error (kContent) where the file is damaged, too large or of a kind it does not read.
OpenedPicture open_exr(InputFilePtr file, const ReadOptions& options);
OpenedPicture open_png(InputFilePtr file, const ReadOptions& options);
OpenedPicture open_pnm(InputFilePtr file, const ReadOptions& options);
OpenedPicture open_npy(InputFilePtr file, const ReadOptions& options);
/// `format` is OpenImageIO's name of it.
OpenedPicture open_with_oiio(InputFilePtr file, const std::string& format,
                             const ReadOptions& options);

/// Refuses, before anything is allocated, a size that is no picture's.
/// Throws Error (kContent) where a side is below 1 or above kMaxSide, or there are more than
/// kMaxPixels.
void check_picture_size(const std::string& name, std::int64_t width, std::int64_t height);

inline constexpr std::int64_t kMaxSide = std::int64_t{1} << 20;
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 32;

/// What may be held at once, whatever the file says: the rows of one chunk, or a whole picture
/// where its format cannot be read in rows.
inline constexpr std::uint64_t kMaxHeldBytes = std::uint64_t{512} << 20;

/// Refuses primaries that make no colours. Throws Error (kContent).
void check_primaries(const std::string& name, const Primaries& primaries);

}  // namespace tristim::detail
