#include "tristim/frame/io/separations.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "lib/frame/io/file_sink.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::string_view kSeparatedFormats[] = {"tiff", "pnm"};

const FrameFormat* format_of(const std::string& path, const FrameWriteOptions& options) {
  if (!options.format.empty()) return find_by_name(kFrameFormats, options.format);
  const std::string extension = detail::extension_of(path);
  for (const FrameFormat& format : kFrameFormats) {
    for (const std::string_view known : split(format.extensions, ' ')) {
      if (known == extension) return &format;
    }
  }
  return nullptr;
}

FrameInfo plate_info(const FrameInfo& info, const std::string& ink) {
  FrameInfo plate = info;
  plate.layout.packing = *find_by_name(kPackings, "mono1");
  plate.palette = {{{255, 255, 255}, 0, "paper"}, {{0, 0, 0}, 1, ink}};
  plate.device += (plate.device.empty() ? "" : ", ") + ink;
  return plate;
}

class SeparationSink final : public CodeSink {
 public:
  SeparationSink(std::vector<std::string> paths, const FrameInfo& info,
                 std::span<const std::string> inks, const FrameWriteOptions& options)
      : paths_(std::move(paths)) {
    for (std::size_t i = 0; i < inks.size(); ++i) {
      plates_.push_back(open_code_sink(paths_[i], plate_info(info, inks[i]), options));
    }
  }

  void write(ImageView<const std::uint16_t> rows) override {
    std::vector<std::uint16_t> bits(static_cast<std::size_t>(rows.width));
    for (int y = 0; y < rows.height; ++y) {
      const std::span<const std::uint16_t> codes = rows.row(y);
      for (std::size_t i = 0; i < plates_.size(); ++i) {
        for (std::size_t x = 0; x < bits.size(); ++x) {
          bits[x] = static_cast<std::uint16_t>(codes[x] >> i & 1);
        }
        plates_[i]->write({bits.data(), rows.width, 1, 1, rows.width});
      }
    }
  }

  void finish() override {
    std::size_t done = 0;
    try {
      for (; done < plates_.size(); ++done) plates_[done]->finish();
    } catch (...) {
      for (std::size_t i = 0; i < done; ++i) {
        std::error_code ignored;
        std::filesystem::remove(paths_[i], ignored);
      }
      throw;
    }
  }

 private:
  std::vector<std::string> paths_;
  std::vector<std::unique_ptr<CodeSink>> plates_;
};

}  // namespace

bool is_separated(const std::string& path, const FrameWriteOptions& options) {
  const FrameFormat* format = format_of(path, options);
  return format != nullptr &&
         std::ranges::find(kSeparatedFormats, format->name) != std::end(kSeparatedFormats);
}

std::vector<std::string> separation_paths(const std::string& path,
                                          std::span<const std::string> inks) {
  const std::filesystem::path name(path);
  std::vector<std::string> paths;
  for (const std::string& ink : inks) {
    std::filesystem::path of_ink = name;
    of_ink.replace_filename(name.stem().string() + "." + ink + name.extension().string());
    paths.push_back(of_ink.string());
  }
  return paths;
}

std::unique_ptr<CodeSink> open_separations(const std::string& path, const FrameInfo& info,
                                           std::span<const std::string> inks,
                                           const FrameWriteOptions& options) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (path == "-" || std::filesystem::is_other(status) ||
      std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status)) {
    throw Error(ErrorKind::kMisuse, path == "-" ? "standard output" : path,
                "cannot take a file for each of " + std::to_string(inks.size()) + " inks",
                "give a name, such as -o page.tif, or --format png for all inks in one");
  }
  return std::make_unique<SeparationSink>(separation_paths(path, inks), info, inks, options);
}

}  // namespace tristim
