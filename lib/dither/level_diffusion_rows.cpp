#include "lib/dither/floyd_steinberg_rows.h"
#include "tristim/dither/levels.h"

namespace tristim {
namespace {

bool plain_floyd_steinberg(const DiffusionOptions& options) noexcept {
  return options.kernel->weight == kFloydSteinberg.weight &&
         options.kernel->divisor == kFloydSteinberg.divisor && !options.serpentine &&
         !options.kernel->closed && options.jitter == 0;
}

}  // namespace

void LevelDiffusion::rows(ImageView<const float> in, ImageView<std::uint16_t> out) {
  constexpr int kLeast = 4;  // rows that are worth the way through lanes
  const auto definition = [&](int y) {
    row({in.row(y).data(), width_, 1}, {out.row(y).data(), width_, 1});
  };
  int y = 0;
  // What a picture begins with is known only there.
  while (y < in.height && (y_ == 0 || errors_.keeps())) definition(y++);
  const detail::FloydSteinbergRows* fast =
      plain_floyd_steinberg(options_) && in.height - y >= kLeast ? detail::floyd_steinberg_rows()
                                                                 : nullptr;
  if (fast != nullptr && table_ == nullptr) {
    table_ =
        std::make_shared<detail::LevelTable>(levels_.light, search_.thresholds(), levels_.code);
  }
  if (fast != nullptr && table_->usable()) {
    const int count = in.height - y;
    const auto in_size = static_cast<std::size_t>(width_);
    fast->run(*table_, in.rows(y, count), out.rows(y, count),
              errors_.row(1, 0).subspan(ErrorRows::kMargin - 1, in_size + 2));
    y_ += count;
    return;
  }
  while (y < in.height) definition(y++);
}

}  // namespace tristim
