#include "tools/convert_picture.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "tools/cli.h"
#include "tools/outputs.h"
#include "tristim/color/rows.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/image/io/exr.h"
#include "tristim/image/io/read.h"

namespace tristim::tools {
namespace {

void check_output(const std::string& output) {
  refuse_terminal(output);
  const std::filesystem::path path(output);
  const bool stream = output == "-" || output.starts_with("/dev/");
  if (stream || same_name(path.extension().string(), ".exr")) return;
  throw Error(ErrorKind::kMisuse, output, "does not end in .exr",
              "components of models are written as floats of EXR; process makes codes of pictures");
}

// Whether the file holds codes, which were decoded to light where they were read.
bool holds_codes(const std::string& input) {
  const PictureFacts facts = picture_facts(input);
  return std::none_of(facts.channels.begin(), facts.channels.end(), [](const std::string& channel) {
    return channel.ends_with(":half") || channel.ends_with(":float");
  });
}

// The model that the rows are in: light of the file where none is named. Codes come as light of the
// file's primaries, which is encoded again by the model that is named.
ModelReference model_of_rows(const PictureJob& job, const PictureInfo& picture) {
  if (job.from.empty()) {
    ModelReference light = parse_model("linear", "--from");
    light.primaries = picture.primaries;
    light.white = picture.primaries.white;
    return light;
  }
  return parse_model(job.from, "--from");
}

// What turns the light that codes were decoded to back into numbers of the model that is named.
std::unique_ptr<RowConversion> encoding(const PictureJob& job, const ModelReference& from) {
  if (job.from.empty() || !holds_codes(job.input)) return nullptr;
  if (from.model->name != "rgb" && from.model->name != "linear") {
    throw Error(ErrorKind::kMisuse, "--from",
                "the codes of " + job.input + " are no " + std::string(from.model->name),
                "codes are RGB: give rgb:SET or linear:SET");
  }
  ModelReference light = from;
  light.model = find_by_name(color_models(), "linear");
  return std::make_unique<RowConversion>(light, from, Adaptation::kNone);
}

PictureInfo result_info(const PictureInfo& picture, const ColorConversion& conversion,
                        std::size_t components) {
  PictureInfo info = picture;
  info.grey = false;
  info.channels = std::max(picture.channels, static_cast<int>(components));
  info.primaries = conversion.to_reference().primaries.value_or(Primaries{});
  return info;
}

}  // namespace

void convert_picture(const PictureJob& job) {
  check_output(job.output);
  const std::unique_ptr<RowSource> source = open_picture(job.input);
  const PictureInfo& picture = source->info();
  const ModelReference from = model_of_rows(job, picture);
  const ModelReference to = parse_model(job.to, "--to");
  const std::unique_ptr<RowConversion> encode = encoding(job, from);
  const RowConversion rows(from, to, job.adaptation, {.keep_undefined = job.keep_undefined});
  const PictureInfo info = result_info(picture, rows.conversion(), component_count(*to.model));
  const auto sink =
      open_exr_sink(job.output, info, {.pixel = ExrPixel::kFloat, .replace = job.replace});

  if (job.explain && job.output != "-") {
    for (const std::string& step : rows.conversion().explain()) print(step + "\n");
  }
  const int band_rows = std::clamp(picture.chunk_rows, 16, 256);
  Image in(picture.width, band_rows, picture.channels);
  Image out(picture.width, band_rows, info.channels);
  const auto in_channels = static_cast<std::size_t>(picture.channels);
  const auto out_channels = static_cast<std::size_t>(info.channels);
  for (int y = 0; y < picture.height; y += band_rows) {
    const int count = std::min(band_rows, picture.height - y);
    source->read(in.view().rows(0, count));
    for (int i = 0; i < count; ++i) {
      const std::span<float> row = in.view().row(i);
      if (encode != nullptr) (*encode)(row, in_channels, row, in_channels);
      rows(row, in_channels, out.view().row(i), out_channels);
    }
    sink->write(out.view().rows(0, count));
  }
  sink->finish();
}

}  // namespace tristim::tools
