#pragma once

#include <chrono>
#include <string>

#include "tristim/pipeline/run.h"

namespace tristim::tools {

/// Progress on standard error, where that is a terminal and the picture takes a while.
class Progress : public BandObserver {
 public:
  Progress(const std::string& name, int height);
  ~Progress() override;
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) override;

 private:
  std::string name_;
  int height_;
  int done_ = 0;
  bool shown_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tristim::tools
