#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tristim/image/flatten.h"
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

/// Refuses an output whose format, by --format or its extension, is none, and a proof that is not
/// called .png. Throws Error (kMisuse).
void check_format(const ProcessOptions& options, const std::string& output);
void check_proof_format(const std::string& proof);

/// The files that an output becomes: itself, or one for each ink of a press.
std::vector<std::string> output_files(const ProcessOptions& options, const Display& device,
                                      const std::string& output);
/// Whether the format of an output has a palette, and whether it has nothing else: GIF.
bool is_indexed_format(const ProcessOptions& options, const std::string& output);
bool is_indexed_only(const ProcessOptions& options, const std::string& output);

/// Reads one picture, writes its output and proof, and prints what was asked for. Throws Error.
void process_picture(const ProcessOptions& options, const Display& device, Job job);

/// The pictures of `jobs`, all with one output, one after the other in one file, with one palette
/// and at the size of the first. Throws Error.
void process_animation(const ProcessOptions& options, const Display& device,
                       const std::vector<Job>& jobs);

}  // namespace tristim::tools
