#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tristim/image/flatten.h"
#include "tristim/pipeline/run.h"
#include "tristim/pipeline/settings.h"
#include "tristim/pipeline/stage.h"

namespace tristim::tools {

/// What `tristim process` was asked for.
struct ProcessOptions {
  std::vector<std::string> inputs;
  std::string output, device, proof, format;
  Settings settings;
  int threads = 0;
  int png_level = 6;
  double delay_s = 0.1;  // of each picture that moves
  bool explain = false, json = false, force = false;
  bool resume = false;  // leave out pictures whose files are there already
};

/// One picture on its way: what is known before its rows, and what was counted with them.
struct Job {
  std::string input, output, proof;  // proof may be empty
  OddValues odd;
  StageCounts counts;
  std::uint64_t pixels = 0;
  double mean_ciede2000 = 0;
  double seconds = 0;
};

/// A picture that has been written, and what there is to say of it.
struct Processed {
  Job job;
  Display display;
  PictureInfo picture;            // as it was written
  std::vector<StepReport> steps;  // where --explain asked for them
};

/// Makes what sees the bands of a picture of so many rows go by. What it throws ends the picture.
using MakeWatcher =
    std::function<std::unique_ptr<BandObserver>(const std::string& input, int height)>;

/// Reads one picture and writes its output and proof. Throws Error.
Processed process_picture(const ProcessOptions& options, const Display& device, Job job,
                          const MakeWatcher& watcher);

/// The pictures of `jobs`, all with one output, one after the other in one file, with one palette
/// and at the size of the first; prints what was asked for. Throws Error.
void process_animation(const ProcessOptions& options, const Display& device,
                       const std::vector<Job>& jobs);

}  // namespace tristim::tools
