#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "lib/image/io/exr_colour.h"
#include "tristim/image/view.h"

namespace tristim::detail {

/// Pixels and where the first of them lies in the file's coordinates.
struct PlacedView {
  ImageView<float> view;
  std::int64_t x = 0, y = 0;
};

/// Decodes the chunks (blocks of rows, or tiles of level 0) of one part into interleaved light.
class ExrChunks {
 public:
  ExrChunks(const ExrFile& file, const ExrPart& part, const ExrSelection& selection,
            const ExrColour& colour);
  ~ExrChunks();

  /// Chunks beside each other.
  int columns() const noexcept { return columns_; }

  /// Bytes that the largest chunk holds once it is unpacked.
  std::uint64_t unpacked_bytes() const noexcept { return unpacked_bytes_; }

  /// Writes the part of a chunk that lies in `target`, with alpha 1 where the file has none. `row`
  /// counts rows of chunks. Returns false where the chunk is damaged. Several threads may call it
  /// at once.
  bool decode(int row, int column, const PlacedView& target);

 private:
  struct Decoder;
  std::unique_ptr<Decoder> take_decoder();
  void give_back(std::unique_ptr<Decoder> decoder);

  const ExrFile& file_;
  const ExrPart& part_;
  const ExrSelection& selection_;
  const ExrColour& colour_;
  int columns_ = 1;
  std::uint64_t unpacked_bytes_ = 0;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Decoder>> idle_;
};

}  // namespace tristim::detail
