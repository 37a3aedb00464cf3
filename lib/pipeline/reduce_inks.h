#pragma once

#include <cstdint>
#include <vector>

#include "lib/pipeline/channel_reducer.h"
#include "lib/pipeline/ink_planes.h"

namespace tristim::detail {

/// Light to the dots of a press: bit i of a code is ink i.
class InkReducer {
 public:
  /// `options` must outlive this.
  InkReducer(const Display& display, const ReduceOptions& options, int width);

  void reduce(Band band, ImageView<std::uint16_t> codes, int threads = 1);

 private:
  void reduce_whole(const Band& band, ImageView<std::uint16_t> codes, int threads);

  const ReduceOptions* options_;
  InkPlanes planes_;
  std::vector<ChannelReducer> inks_;
};

}  // namespace tristim::detail
