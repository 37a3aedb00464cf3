#include <algorithm>
#include <deque>

#include "lib/dither/level_rows.h"
#include "tristim/dither/levels.h"

namespace tristim {

// The fast rows, where they take what is asked for.
const detail::LevelRows* LevelDiffusion::fast_rows() {
  if (options_.serpentine || !tones_.empty()) return nullptr;
  if (table_ == nullptr) {
    table_ =
        std::make_shared<detail::LevelTable>(levels_.light, search_.thresholds(), levels_.code);
  }
  const bool takes_jitter = options_.jitter == 0 || table_->few();
  return table_->usable() && takes_jitter ? detail::level_rows() : nullptr;
}

void LevelDiffusion::rows(ImageView<const float> in, ImageView<std::uint16_t> out, int threads) {
  constexpr int kLeast = 4;  // rows that are worth the way through lanes
  int y = 0;
  const auto definition = [&] {
    row({in.row(y).data(), width_, 1}, {out.row(y).data(), width_, 1});
    ++y;
  };
  // What a picture begins with is known only there.
  while (y < in.height && (y_ == 0 || errors_.keeps())) definition();
  const detail::LevelRows* fast = in.height - y >= kLeast ? fast_rows() : nullptr;
  if (fast == nullptr) {
    while (y < in.height) definition();
    return;
  }
  const detail::LevelRowsPlan plan{detail::SkewedRows(errors_, options_.kernel->closed),
                                   table_.get(), options_.jitter, seed_};
  const int groups = (in.height - y + fast->most - 1) / fast->most;
  std::deque<detail::MeetingRows> meeting;
  for (int g = 0; g <= groups; ++g) meeting.emplace_back(width_, plan.rows, fast->most);
  meeting.front().load(errors_, 0);
  detail::in_turn(groups, threads, [&] {
    return [&](int group) {
      const int first = group * fast->most;
      const int count = std::min(fast->most, in.height - y - first);
      const auto at = static_cast<std::size_t>(group);
      fast->run(plan, {y_ + first, in.rows(y + first, count), out.rows(y + first, count)},
                meeting[at], meeting[at + 1]);
    };
  });
  y_ += in.height - y;
  meeting.back().store(errors_, 0);
}

}  // namespace tristim
