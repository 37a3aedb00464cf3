#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/process_job.h"
#include "tristim/frame/code.h"
#include "tristim/image/picture.h"
#include "tristim/palette/histogram.h"

namespace tristim::tools {

/// A device with the palette that its pictures are reduced to.
struct PaletteDisplay {
  Display display;                 // without an entry for transparent pixels
  std::optional<int> transparent;  // the position of such an entry in files
  std::optional<StepReport> step;  // where the palette comes from, where it is not the device's
};

/// The palette that `options` ask for, of a file or chosen for all inputs together; else the
/// device's. A device with three channels becomes one with indices where `indexed` says that the
/// result's format has them. Throws Error (kMisuse) where the palette does not fit the device.
PaletteDisplay choose_palette(const ProcessOptions& options, const Display& device,
                              const std::vector<std::string>& inputs, bool indexed);

/// What counts of a picture beside its settings.
struct Counting {
  AlphaMode alpha = AlphaMode::kOver;  // over the background, or as CountOptions has it
  std::string mask;                    // a picture: how much pixels count; empty: all alike
};

/// Counts the colours of a picture as the device will be asked for them; see histogram(). Throws
/// Error (kContent) for a mask of another size.
Histogram count_colors(const Settings& settings, const Display& display, const std::string& input,
                       int threads, const Counting& counting = {});

/// What writers need to know of such a frame: its palette has the transparent entry in its place.
FrameInfo palette_frame_info(const PaletteDisplay& palette, int width, int height);

/// Takes the codes of one picture for a file that has a transparent entry.
class TransparentSink final : public CodeSink {
 public:
  /// `coverage`: the picture's alpha, see open_coverage; null: all is opaque. `file` outlives this.
  TransparentSink(CodeSink& file, int transparent, std::unique_ptr<RowSource> coverage);

  /// Positions from the transparent one on move up by one; pixels that are less than half covered
  /// become it.
  void write(ImageView<const std::uint16_t> rows) override;
  void finish() override {}

 private:
  CodeSink* file_;
  std::uint16_t transparent_;
  std::unique_ptr<RowSource> coverage_;
  Image light_;
  std::vector<std::uint16_t> codes_;
};

/// The alpha of a picture as its first channel, fitted as the picture is; null where it has none.
std::unique_ptr<RowSource> open_coverage(const std::string& input, const Display& display,
                                         Settings settings, int threads);

}  // namespace tristim::tools
