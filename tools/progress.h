#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "tristim/pipeline/run.h"

namespace tristim::tools {

/// Progress on standard error, where that is a terminal and the picture takes a while: the part
/// that is done, and where the width is known the rate and the time left.
class Progress : public BandObserver {
 public:
  Progress(const std::string& name, int height, int width = 0);
  ~Progress() override;
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) override;
  void advance(int rows);
  void erase();  // what is drawn, so that something else may be printed

 private:
  std::string name_;
  int height_;
  int width_;
  int done_ = 0;
  bool shown_;
  std::size_t drawn_ = 0;  // characters
  std::chrono::steady_clock::time_point first_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = first_;
};

/// Progress of a picture, see MakeWatcher.
std::unique_ptr<BandObserver> make_progress(const std::string& input, int height);

}  // namespace tristim::tools
