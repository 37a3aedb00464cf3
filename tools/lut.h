#pragma once

#include <string>
#include <vector>

#include "tools/cli.h"
#include "tristim/lut/bake.h"
#include "tristim/lut/io/file.h"

namespace tristim::tools {

// Each in its file tools/lut_<name>.cpp.
void run_lut_bake(Arguments arguments);
void run_lut_apply(Arguments arguments);
void run_lut_invert(Arguments arguments);
void run_lut_compose(Arguments arguments);
void run_lut_info(Arguments arguments);
void run_lut_convert(Arguments arguments);
void run_lut_formats(Arguments arguments);
void run_lut_ocio_config(Arguments arguments);

/// What `tristim lut` does. The command and its help read this list.
inline constexpr Command kLutJobs[] = {
    {"lut bake", "-o OUT --device D|--to MODEL|--ocio CONFIG [options]",
     "a table of a pipeline, a device, a conversion or an OCIO config", run_lut_bake},
    {"lut apply", "IN LUT... -o OUT [options]", "a picture through tables", run_lut_apply},
    {"lut invert", "LUT -o OUT [options]", "the table that undoes a table", run_lut_invert},
    {"lut compose", "LUT LUT... -o OUT [options]", "several tables as one", run_lut_compose},
    {"lut info", "LUT... [options]",
     "what a table is: sizes, ranges, monotone, how far from the "
     "identity",
     run_lut_info},
    {"lut convert", "IN OUT [options]", "a table in another format", run_lut_convert},
    {"lut formats", "[--json]", "every format, and what it holds", run_lut_formats},
    {"lut ocio-config", "[D...] -o OUT [options]", "devices as displays of an OpenColorIO config",
     run_lut_ocio_config},
};

/// The job of kLutJobs called `name`, without "lut "; nullptr where there is none.
const Command* lut_job(std::string_view name) noexcept;

/// A table as a file: where, in which format, and how its numbers lie.
struct LutOutput {
  std::string path;
  std::string format;  // "": by the extension
  LutFileOptions file;
  bool force = false;
};

/// Declares -o, --format, --bits, --progmem and --force.
void declare_lut_output(CommandLine& line, LutOutput& output);

/// Refuses before any work is done what cannot be written. Throws Error. The format.
const LutFormat& check_lut_output(const LutOutput& output, const std::vector<std::string>& inputs);

/// A file that is ready to be written, and the table that it holds.
struct LutFile {
  std::string bytes;
  Lut stored;
};

/// Throws Error (kMisuse) where the format does not hold the table.
LutFile lut_file(const Lut& lut, const LutFormat& format, const LutOutput& output);

/// How finely a table is sampled anew.
struct LutSampling {
  int curves = 4096;  // entries
  int cube = 33;      // points of an edge
};

/// `lut` as the format holds it: sampled as curves where each channel depends on itself alone and
/// the format has curves, else as a cube; never finer than the format can be. Throws Error
/// (kMisuse) where it cannot hold it at all.
Lut sampled_lut(const Lut& lut, const LutFormat& format, LutSampling sampling,
                const std::string& path);

/// Puts the bytes where they belong.
void write_lut_file(const LutFile& file, const LutOutput& output);

/// The interpolation of that name. Throws Error (kMisuse).
const LutInterpolation& interpolation_option(const std::string& name);

/// A model of three components that tells what a table's results look like. Throws Error (kMisuse).
using Look = std::function<Lab(Rgb)>;
Look look_of(const std::string& model, std::string_view option);

/// "cube of 33 points behind curves of 4096 entries".
std::string lut_words(const Lut& lut);

}  // namespace tristim::tools
