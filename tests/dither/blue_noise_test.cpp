#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "lib/dither/void_and_cluster.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

using Ranks = std::vector<std::uint16_t>;

ThresholdMatrix blue(int size, std::uint64_t seed = 0, int channel = 0) {
  return blue_noise_matrix({.size = size, .seed = seed, .channel = channel});
}

bool every_rank_equally_often(const ThresholdMatrix& matrix) {
  std::vector<std::size_t> count(static_cast<std::size_t>(matrix.ranks));
  for (const std::uint16_t rank : matrix.rank) ++count.at(rank);
  const auto [least, most] = std::ranges::minmax(count);
  return most - least <= 1 && least >= 1;
}

// The mean power of a pattern below and above half of the frequency at which its dots repeat,
// sqrt(density) or 1/2, relative to white noise: a discrete Fourier transform, rows and then
// columns.
struct Spectrum {
  double low, high;
};

Spectrum spectrum(const ThresholdMatrix& matrix, double density) {
  const int n = matrix.width;
  const auto size = static_cast<std::size_t>(n);
  const auto at = [size](int x, int y) {
    return static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
  };
  std::vector<std::complex<double> > turn(size);
  for (std::size_t i = 0; i < size; ++i) {
    turn[i] = std::polar(1.0, -2 * M_PI * static_cast<double>(i) / static_cast<double>(size));
  }
  std::vector<std::complex<double> > rows(size * size);
  for (int y = 0; y < n; ++y) {
    for (int u = 0; u < n; ++u) {
      for (int x = 0; x < n; ++x) {
        const bool lit = matrix.row(y)[x] < density * matrix.ranks;
        if (lit) rows[at(u, y)] += turn[static_cast<std::size_t>(u * x % n)];
      }
    }
  }
  Spectrum sum{0, 0};
  double low_count = 0;
  double high_count = 0;
  for (int u = 0; u < n; ++u) {
    for (int v = 0; v < n; ++v) {
      if (u == 0 && v == 0) continue;
      std::complex<double> value;
      for (int y = 0; y < n; ++y)
        value += rows[at(u, y)] * turn[static_cast<std::size_t>(v * y % n)];
      const double white = density * (1 - density) * n * n;
      const double frequency = std::hypot(std::min(u, n - u), std::min(v, n - v)) / n;
      const bool low = frequency < std::min(std::sqrt(std::min(density, 1 - density)), 0.5) / 2;
      (low ? sum.low : sum.high) += std::norm(value) / white;
      (low ? low_count : high_count) += 1;
    }
  }
  return {sum.low / low_count, sum.high / high_count};
}

TEST(BlueNoise, TheBuiltInMaskIsMadeByTheProgram) {
  const auto order = detail::void_and_cluster({128, 128, 1}, 0);
  Ranks ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<std::uint16_t>(i);
  EXPECT_EQ(blue(128).rank, ranks);
}

TEST(BlueNoise, HasEveryRankEquallyOftenInEverySize) {
  for (const int size : {1, 2, 3, 5, 8, 31, 64, 100}) {
    const ThresholdMatrix matrix = blue(size, 7);
    EXPECT_EQ(matrix.rank.size(), static_cast<std::size_t>(size * size));
    EXPECT_TRUE(every_rank_equally_often(matrix)) << size;
  }
  // More cells than ranks: 300 x 300.
  const ThresholdMatrix large = blue(300);
  EXPECT_EQ(large.ranks, 65536);
  EXPECT_TRUE(every_rank_equally_often(large));
}

TEST(BlueNoise, DiffersBySeedAndIsTheSameForOne) {
  EXPECT_EQ(blue(32, 5).rank, blue(32, 5).rank);
  EXPECT_NE(blue(32, 5).rank, blue(32, 6).rank);
}

TEST(BlueNoise, HasLittlePowerAtLowFrequencies) {
  const ThresholdMatrix matrix = blue(64, 3);
  for (const double density : {1.0 / 256, 1.0 / 64, 1.0 / 16, 0.25, 0.5, 0.75, 0.95}) {
    const auto [low, high] = spectrum(matrix, density);
    EXPECT_LT(low, 0.15) << density;  // white noise has 1; .13 at most measured
    EXPECT_GT(high, 0.9) << density;
  }
}

double correlation(const ThresholdMatrix& a, const ThresholdMatrix& b) {
  const double mean = (a.ranks - 1) / 2.0;
  double product = 0;
  double square = 0;
  for (std::size_t i = 0; i < a.rank.size(); ++i) {
    product += (a.rank[i] - mean) * (b.rank[i] - mean);
    square += (a.rank[i] - mean) * (a.rank[i] - mean);
  }
  return product / square;
}

TEST(BlueNoise, ChannelsAreNotCorrelated) {
  for (const int size : {64, 100, 128}) {
    std::vector<ThresholdMatrix> channels;
    for (int channel = 0; channel < 4; ++channel) channels.push_back(blue(size, 0, channel));
    for (std::size_t a = 0; a < channels.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_LT(std::fabs(correlation(channels[a], channels[b])), 0.04) << size << a << b;
      }
    }
  }
}

// Every slice is a mask of its own, blue in space ...
TEST(BlueNoiseFrames, AreMasks) {
  for (const int frame : {0, 5, 15}) {
    const ThresholdMatrix slice = blue_noise_matrix({.size = 32, .frame = frame});
    EXPECT_TRUE(every_rank_equally_often(slice));
    for (const double density : {1.0 / 16, 0.25, 0.5}) {
      const auto [low, high] = spectrum(slice, density);
      EXPECT_LT(low, 0.3) << density;
      EXPECT_GT(high, 0.9) << density;
    }
  }
  EXPECT_EQ(blue_noise_matrix({.size = 16, .frame = 3}).rank,
            blue_noise_matrix({.size = 16, .frame = 3 + kBlueNoiseFrames}).rank);
}

// ... and in time: of a pixel that is lit now the next frames are lit less often than by chance, so
// that a few of them together are even.
TEST(BlueNoiseFrames, AreBlueAlongTime) {
  constexpr int kSize = 32;
  std::vector<ThresholdMatrix> slices;
  for (int frame = 0; frame < kBlueNoiseFrames; ++frame) {
    slices.push_back(blue_noise_matrix({.size = kSize, .frame = frame}));
  }
  for (const double density : {0.25, 0.5}) {
    // The variance of how often a pixel is lit in four frames that follow each other.
    double squares = 0;
    for (std::size_t i = 0; i < slices[0].rank.size(); ++i) {
      for (std::size_t first = 0; first < slices.size(); ++first) {
        double lit = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          const ThresholdMatrix& slice = slices[(first + k) % slices.size()];
          lit += slice.rank[i] < density * slice.ranks ? 1 : 0;
        }
        squares += (lit - 4 * density) * (lit - 4 * density);
      }
    }
    const double chance = 4 * density * (1 - density);
    const double variance = squares / (kSize * kSize * kBlueNoiseFrames);
    EXPECT_LT(variance, 0.5 * chance) << density;
  }
}

}  // namespace
}  // namespace tristim
