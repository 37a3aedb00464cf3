// Light to the bytes of an sRGB display: the chain as a program runs it that links the library,
// beside other libraries with the same work, and what memory alone allows. bench/table.py reads it.
//
// W1 is float RGB through a matrix, clipped, through sRGB's curve to 8 bits; W2 has an ordered
// dither, W3 error diffusion. `growth` is W1 of pictures of 1 to 134 million pixels. The count of
// wrong codes is among all i/2^24 from 0 to 1, with primaries that stay.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/peers/peers.h"
#include "bench/pictures.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/frame/pack.h"
#include "tristim/pipeline/run.h"

namespace tristim::bench {
namespace {

// Light and the bytes that it becomes, both whole in memory.
struct Picture {
  Picture(int w, int h)
      : width(w),
        height(h),
        light(std::size_t{3} * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
        codes(light.size()) {}
  int width, height;
  Samples<float> light;
  Samples<std::uint8_t> codes;
};

// Noise of that size. One picture at a time: the largest has 2 GB.
const Picture& noise_picture(int width, int height) {
  static std::unique_ptr<Picture> picture;
  if (!picture || picture->width != width || picture->height != height) {
    picture.reset();
    picture = std::make_unique<Picture>(width, height);
    const std::vector<float> some = noise(1 << 20);
    for (std::size_t i = 0; i < picture->light.size(); i += some.size()) {
      const std::size_t count = std::min(some.size(), picture->light.size() - i);
      std::copy_n(some.data(), count, picture->light.data() + i);
    }
  }
  return *picture;
}

class LightRows : public RowSource {
 public:
  LightRows(const DisplayJob& job, const float* light) : next_(light) {
    info_.width = job.width;
    info_.height = job.height;
  }
  const PictureInfo& info() const noexcept override { return info_; }
  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y) {
      std::memcpy(rows.row(y).data(), next_, rows.row(y).size_bytes());
      next_ += rows.row(y).size();
    }
  }

 private:
  PictureInfo info_;
  const float* next_;
};

class ByteRows : public CodeSink {
 public:
  ByteRows(const FrameInfo& info, std::uint8_t* bytes)
      : layout_(info.layout),
        row_bytes_(packed_row_bytes(info.layout.packing, info.width)),
        next_(bytes) {}
  void write(ImageView<const std::uint16_t> rows) override {
    for (int y = 0; y < rows.height; ++y) {
      pack_row(rows.row(y), layout_, {next_, row_bytes_});
      next_ += row_bytes_;
    }
  }
  void finish() override {}

 private:
  FrameLayout layout_;
  std::size_t row_bytes_;
  std::uint8_t* next_;
};

ToBytes tristim_to_bytes(const DisplayJob& job, const char* dither, int threads) {
  const Display display = load_display("srgb");
  const ConvertPrimaries primaries{rgb_from_rgb(Primaries{}, job.from, Adaptation::kBradford),
                                   job.from};
  const std::vector<Stage> stages{primaries, GamutMap{}};
  ReduceOptions options;
  options.dither = find_by_name(dither_methods(), dither)->method;
  return [=](const float* in, std::uint8_t* out) {
    LightRows source(job, in);
    ByteRows sink(frame_info(display, job.width, job.height), out);
    Reducer reducer(display, options, job.width);
    run(source, stages, reducer, sink, {}, {.threads = threads});
  };
}

#if defined(__x86_64__)
#define TRISTIM_WIDEST __attribute__((target_clones("arch=skylake-avx512", "avx2", "default")))
#else
#define TRISTIM_WIDEST
#endif

// What memory alone allows: every float read once, a byte written for each.
TRISTIM_WIDEST void truncate(const float* in, std::size_t count, std::uint8_t* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<std::uint8_t>(in[i]);
}

ToBytes floor_to_bytes(const DisplayJob& job, int threads) {
  const std::size_t row = std::size_t{3} * static_cast<std::size_t>(job.width);
  return [=, height = job.height](const float* in, std::uint8_t* out) {
    share_rows(height, threads, [=](int first, int count) {
      const std::size_t begin = row * static_cast<std::size_t>(first);
      truncate(in + begin, row * static_cast<std::size_t>(count), out + begin);
    });
  };
}

// The loop that everybody writes first.
ToBytes powf_to_bytes(const DisplayJob& job) {
  const Eigen::Matrix3f m =
      rgb_from_rgb(Primaries{}, job.from, Adaptation::kBradford).cast<float>();
  return [m, pixels = std::int64_t{job.width} * job.height](const float* in, std::uint8_t* out) {
    for (std::int64_t i = 0; i < pixels; ++i, in += 3, out += 3) {
      for (int c = 0; c < 3; ++c) {
        const float sum = m(c, 0) * in[0] + m(c, 1) * in[1] + m(c, 2) * in[2];
        const float x = std::clamp(sum, 0.0F, 1.0F);
        const float e = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
        out[c] = static_cast<std::uint8_t>(255 * e + 0.5F);
      }
    }
  };
}

using Make = std::function<ToBytes(const DisplayJob&)>;

Make tristim(const char* dither, int threads) {
  return [=](const DisplayJob& job) { return tristim_to_bytes(job, dither, threads); };
}

Make zimg(ZimgDither dither) {
  return [=](const DisplayJob& job) { return zimg_to_bytes(job, dither); };
}

Make floor_of(int threads) {
  return [=](const DisplayJob& job) { return floor_to_bytes(job, threads); };
}

void convert(benchmark::State& state, int width, int height, const Make& make) {
  const Picture& picture = noise_picture(width, height);
  const ToBytes convert_all =
      make({width, height, find_by_name(primaries_list(), "bt2020")->primaries});
  for (auto _ : state) {
    convert_all(picture.light.data(), picture.codes.data());
    benchmark::ClobberMemory();
  }
  count_pixels(state, width, height);
}

constexpr int kSteps = 1 << 24;  // of light, from 0 to 1

// The smallest i of light i/2^24 that is to get each code: 255 E + 1/2 rounded down, in 64 bits.
std::vector<int> first_steps() {
  const auto code = [](int i) {
    const long double light = static_cast<long double>(i) / kSteps;
    const long double e =
        light <= .0031308L ? 12.92L * light : 1.055L * std::pow(light, 1 / 2.4L) - .055L;
    return static_cast<int>(255 * e + .5L);
  };
  std::vector<int> first(256);
  for (int wanted = 1; wanted < 256; ++wanted) {
    int below = 0;
    for (int at = kSteps; at - below > 1;) {
      const int middle = below + (at - below) / 2;
      (code(middle) < wanted ? below : at) = middle;
      first[static_cast<std::size_t>(wanted)] = at;
    }
  }
  return first;
}

void wrong_codes(benchmark::State& state, const Make& make) {
  constexpr int kRows = (kSteps + 3 * kWidth) / (3 * kWidth);
  Picture ramp(kWidth, kRows);
  for (int i = 0; i <= kSteps; ++i) {
    ramp.light[static_cast<std::size_t>(i)] = static_cast<float>(i) / kSteps;
  }
  const ToBytes convert_all = make({kWidth, kRows, Primaries{}});
  const std::vector<int> first = first_steps();
  std::int64_t wrong = 0;
  for (auto _ : state) {
    convert_all(ramp.light.data(), ramp.codes.data());
    int right = 0;
    for (int i = 0; i <= kSteps; ++i) {
      while (right < 255 && i >= first[static_cast<std::size_t>(right) + 1]) ++right;
      wrong += ramp.codes[static_cast<std::size_t>(i)] != right ? 1 : 0;
    }
  }
  state.counters["wrong"] = static_cast<double>(wrong);
}

void add(const std::string& name, const Make& make, int width = kWidth, int height = kHeight) {
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { convert(state, width, height, make); })
      ->UseRealTime()
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
}

void add_workload_1() {
  const std::pair<const char*, Make> who[] = {
      {"tristim", tristim("none", 1)}, {"zimg", zimg(ZimgDither::kNone)},
      {"OpenColorIO", ocio_to_bytes},  {"OpenImageIO", oiio_to_bytes},
      {"Little CMS", lcms_to_bytes},   {"powf", powf_to_bytes}};
  for (const auto& [name, make] : who) {
    add(std::string("W1/") + name, make);
    benchmark::RegisterBenchmark(
        (std::string("wrong/") + name).c_str(),
        [make = make](benchmark::State& state) { wrong_codes(state, make); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const int threads : {1, 2}) {
    const std::string suffix = threads == 1 ? "" : ", 2 threads";
    add("floor" + suffix, floor_of(threads));
    if (threads == 2) add("W1/tristim" + suffix, tristim("none", threads));
    add("W2/tristim" + suffix, tristim("bayer8", threads));
    add("W3/tristim" + suffix, tristim("floyd-steinberg", threads));
  }
  add_workload_1();
  add("W2/zimg", zimg(ZimgDither::kOrdered));
  add("W3/zimg", zimg(ZimgDither::kErrorDiffusion));
  constexpr int kSizes[][2] = {{1280, 800}, {kWidth, kHeight}, {7680, 4320}, {16384, 8192}};
  for (const auto& [width, height] : kSizes) {
    const std::string name = "growth/" + std::to_string(width * height / 1'000'000) + " Mpixel/";
    for (const int threads : {1, 2}) {
      const std::string suffix = threads == 1 ? "" : ", 2 threads";
      add(name + "floor" + suffix, floor_of(threads), width, height);
      add(name + "tristim" + suffix, tristim("none", threads), width, height);
    }
  }
  return true;
}();

}  // namespace
}  // namespace tristim::bench
