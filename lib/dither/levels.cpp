#include "tristim/dither/levels.h"

#include "lib/dither/step_table.h"

namespace tristim {

NearestLevel::NearestLevel(std::span<const float> threshold, std::span<const std::uint16_t> code)
    : search_(threshold), code_(code.begin(), code.end()) {
  if (auto table = detail::step_table(threshold, code)) {
    table_ = std::make_shared<const detail::StepTable>(*std::move(table));
  }
}

void NearestLevel::row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out) const noexcept {
  if (!table_) {
    for (int x = 0; x < in.width; ++x) {
      out[x] = code_[static_cast<std::size_t>(search_.count_not_above(in[x]))];
    }
  } else if (in.step == 1 && out.step == 1) {
    detail::step_kernel().row(*table_, in.data, static_cast<std::size_t>(in.width), out.data);
  } else {
    for (int x = 0; x < in.width; ++x) out[x] = (*table_)(in[x]);
  }
}

}  // namespace tristim
