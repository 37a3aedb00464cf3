#include <zimg.h>

#include <memory>
#include <stdexcept>

#include "bench/peers/peers.h"
#include "bench/pictures.h"

namespace tristim::bench {
namespace {

using Graph = std::shared_ptr<zimg_filter_graph>;

Graph build(const zimg_image_format& from, const zimg_image_format& to, ZimgDither dither) {
  zimg_graph_builder_params params;
  zimg_graph_builder_params_default(&params, ZIMG_API_VERSION);
  params.dither_type = dither == ZimgDither::kOrdered          ? ZIMG_DITHER_ORDERED
                       : dither == ZimgDither::kErrorDiffusion ? ZIMG_DITHER_ERROR_DIFFUSION
                                                               : ZIMG_DITHER_NONE;
  params.cpu_type = ZIMG_CPU_AUTO_64B;
  params.allow_approximate_gamma = 1;
  Graph graph(zimg_filter_graph_build(&from, &to, &params), &zimg_filter_graph_free);
  if (graph) return graph;
  char why[256];
  zimg_get_last_error(why, sizeof(why));
  throw std::runtime_error(std::string("zimg: ") + why);
}

zimg_image_format floats(int width, int height) {
  zimg_image_format format;
  zimg_image_format_default(&format, ZIMG_API_VERSION);
  format.width = static_cast<unsigned>(width);
  format.height = static_cast<unsigned>(height);
  format.pixel_type = ZIMG_PIXEL_FLOAT;
  format.depth = 32;
  format.pixel_range = ZIMG_RANGE_FULL;
  return format;
}

zimg_image_format bytes(zimg_image_format format, int bits) {
  format.pixel_type = ZIMG_PIXEL_BYTE;
  format.depth = static_cast<unsigned>(bits);
  return format;
}

// Rows are as long as they must be for vectors where the width is a multiple of 64.
ToBytes process(const Graph& graph, int planes, std::ptrdiff_t width, std::ptrdiff_t height) {
  std::size_t scratch_bytes = 0;
  zimg_filter_graph_get_tmp_size(graph.get(), &scratch_bytes);
  const auto scratch = std::make_shared<Samples<std::uint8_t>>(scratch_bytes);
  return [=](const float* in, std::uint8_t* out) {
    zimg_image_buffer_const source{ZIMG_API_VERSION, {}};
    zimg_image_buffer target{ZIMG_API_VERSION, {}};
    for (int plane = 0; plane < planes; ++plane) {
      source.plane[plane] = {in + plane * width * height,
                             width * static_cast<std::ptrdiff_t>(sizeof(float)), ZIMG_BUFFER_MAX};
      target.plane[plane] = {out + plane * width * height, width, ZIMG_BUFFER_MAX};
    }
    zimg_filter_graph_process(graph.get(), &source, &target, scratch->data(), nullptr, nullptr,
                              nullptr, nullptr);
  };
}

}  // namespace

ToBytes zimg_to_bytes(const DisplayJob& job, ZimgDither dither) {
  zimg_image_format from = floats(job.width, job.height);
  from.color_family = ZIMG_COLOR_RGB;
  from.matrix_coefficients = ZIMG_MATRIX_RGB;
  from.transfer_characteristics = ZIMG_TRANSFER_LINEAR;
  from.color_primaries = job.from == Primaries{} ? ZIMG_PRIMARIES_BT709 : ZIMG_PRIMARIES_BT2020;
  zimg_image_format to = bytes(from, 8);
  to.transfer_characteristics = ZIMG_TRANSFER_IEC_61966_2_1;
  to.color_primaries = ZIMG_PRIMARIES_BT709;
  return process(build(from, to, dither), 3, job.width, job.height);
}

ToBytes zimg_plane(int width, int height, int bits, ZimgDither dither) {
  const zimg_image_format from = floats(width, height);
  return process(build(from, bytes(from, bits), dither), 1, width, height);
}

}  // namespace tristim::bench
