#include "lib/image/plane.h"

#include <zimg.h>

#include <utility>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

static_assert(kPointFilter.zimg_filter == ZIMG_RESIZE_POINT);
static_assert(kBilinearFilter.zimg_filter == ZIMG_RESIZE_BILINEAR);
static_assert(kHermiteFilter.zimg_filter == ZIMG_RESIZE_BICUBIC);
static_assert(kMitchellFilter.zimg_filter == ZIMG_RESIZE_BICUBIC);
static_assert(kBicubicFilter.zimg_filter == ZIMG_RESIZE_BICUBIC);
static_assert(kSpline36Filter.zimg_filter == ZIMG_RESIZE_SPLINE36);
static_assert(kLanczosFilter.zimg_filter == ZIMG_RESIZE_LANCZOS);

struct FreeGraph {
  void operator()(zimg_filter_graph* graph) const noexcept { zimg_filter_graph_free(graph); }
};

}  // namespace

struct PlaneResizer::State {
  std::unique_ptr<zimg_filter_graph, FreeGraph> graph;
  Plane scratch{0};
  std::string name;

  [[noreturn]] void fail() const {
    char text[256] = "";
    zimg_get_last_error(text, sizeof text);
    throw Error(ErrorKind::kContent, name, std::string("cannot be resampled: ") + text,
                "use another size or the filter point");
  }
};

PlaneResizer::PlaneResizer(Along along, const PlaneAxis& axis, std::size_t other,
                           const ResampleFilter& filter, std::string name)
    : state_(new State) {
  state_->name = std::move(name);
  zimg_image_format in;
  zimg_image_format_default(&in, ZIMG_API_VERSION);
  in.pixel_type = ZIMG_PIXEL_FLOAT;
  in.width = in.height = static_cast<unsigned>(other);
  zimg_image_format out = in;
  const bool columns = along == Along::kColumns;
  (columns ? in.width : in.height) = static_cast<unsigned>(axis.in);
  (columns ? out.width : out.height) = static_cast<unsigned>(axis.out);
  (columns ? in.active_region.left : in.active_region.top) = axis.start;
  (columns ? in.active_region.width : in.active_region.height) = axis.length;

  zimg_graph_builder_params params;
  zimg_graph_builder_params_default(&params, ZIMG_API_VERSION);
  params.resample_filter = static_cast<zimg_resample_filter_e>(filter.zimg_filter);
  params.filter_param_a = filter.a;
  params.filter_param_b = filter.b;
  // The vector versions fuse or reorder the sums: half of their samples differ in the last bits.
  params.cpu_type = ZIMG_CPU_NONE;

  std::size_t bytes = 0;
  state_->graph.reset(zimg_filter_graph_build(&in, &out, &params));
  if (state_->graph == nullptr ||
      zimg_filter_graph_get_tmp_size(state_->graph.get(), &bytes) != ZIMG_ERROR_SUCCESS) {
    state_->fail();
  }
  state_->scratch = Plane(bytes / sizeof(float) + 1);
  state_->scratch.resize(1);
}

PlaneResizer::~PlaneResizer() = default;

void PlaneResizer::run(Plane& in, Plane& out) {
  zimg_image_buffer_const from{.version = ZIMG_API_VERSION, .plane = {}};
  zimg_image_buffer to{.version = ZIMG_API_VERSION, .plane = {}};
  from.plane[0] = {in.row(0), in.stride() * std::ptrdiff_t{sizeof(float)}, ZIMG_BUFFER_MAX};
  to.plane[0] = {out.row(0), out.stride() * std::ptrdiff_t{sizeof(float)}, ZIMG_BUFFER_MAX};
  if (zimg_filter_graph_process(state_->graph.get(), &from, &to, state_->scratch.row(0), nullptr,
                                nullptr, nullptr, nullptr) != ZIMG_ERROR_SUCCESS) {
    state_->fail();
  }
}

}  // namespace tristim::detail
