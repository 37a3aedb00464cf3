#pragma once

#include <string>
#include <string_view>

#include "tristim/palette/palette.h"

// A reader and a writer of each format, as PaletteFormat describes them.
namespace tristim::detail {

Palette read_gpl(std::string_view bytes, const std::string& file);
std::string write_gpl(const Palette& palette);
Palette read_hex(std::string_view bytes, const std::string& file);
std::string write_hex(const Palette& palette);
Palette read_act(std::string_view bytes, const std::string& file);
std::string write_act(const Palette& palette);
Palette read_aco(std::string_view bytes, const std::string& file);
std::string write_aco(const Palette& palette);
Palette read_ase(std::string_view bytes, const std::string& file);
std::string write_ase(const Palette& palette);
Palette read_jasc(std::string_view bytes, const std::string& file);
std::string write_jasc(const Palette& palette);
Palette read_riff(std::string_view bytes, const std::string& file);
std::string write_riff(const Palette& palette);
Palette read_csv(std::string_view bytes, const std::string& file);
std::string write_csv(const Palette& palette);
Palette read_json(std::string_view bytes, const std::string& file);
std::string write_json(const Palette& palette);
Palette read_toml(std::string_view bytes, const std::string& file);
std::string write_toml(const Palette& palette);
Palette read_sheet(std::string_view bytes, const std::string& file);
std::string write_sheet(const Palette& palette);
Palette read_c_header(std::string_view bytes, const std::string& file);
std::string write_c_header(const Palette& palette);

}  // namespace tristim::detail
