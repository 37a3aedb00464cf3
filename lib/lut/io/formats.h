#pragma once

#include <string>
#include <string_view>

#include "tristim/lut/io/file.h"

// A reader and a writer of each format, as LutFormat describes them.
namespace tristim::detail {

Lut read_cube(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_cube(const Lut& lut, const LutFileOptions& options);
std::string write_resolve(const Lut& lut, const LutFileOptions& options);
Lut read_spi1d(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_spi1d(const Lut& lut, const LutFileOptions& options);
Lut read_spi3d(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_spi3d(const Lut& lut, const LutFileOptions& options);
Lut read_3dl(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_3dl(const Lut& lut, const LutFileOptions& options);
Lut read_csp(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_csp(const Lut& lut, const LutFileOptions& options);
Lut read_clf(std::string_view bytes, const std::string& file, const LutFileOptions& options);
Lut read_ctf(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_clf(const Lut& lut, const LutFileOptions& options);
std::string write_ctf(const Lut& lut, const LutFileOptions& options);
Lut read_hald(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_hald(const Lut& lut, const LutFileOptions& options);
Lut read_icc(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_icc(const Lut& lut, const LutFileOptions& options);
Lut read_ramp(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_ramp(const Lut& lut, const LutFileOptions& options);
Lut read_xrandr(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_xrandr(const Lut& lut, const LutFileOptions& options);
Lut read_drm(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_drm(const Lut& lut, const LutFileOptions& options);
Lut read_raw(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_raw(const Lut& lut, const LutFileOptions& options);
Lut read_c_lut(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_c_lut(const Lut& lut, const LutFileOptions& options);
std::string write_cpp_lut(const Lut& lut, const LutFileOptions& options);
Lut read_json_lut(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_json_lut(const Lut& lut, const LutFileOptions& options);
Lut read_csv_lut(std::string_view bytes, const std::string& file, const LutFileOptions& options);
std::string write_csv_lut(const Lut& lut, const LutFileOptions& options);

}  // namespace tristim::detail
