#include "tools/device_fit_report.h"

#include <algorithm>
#include <cmath>

#include "tools/device_actions.h"
#include "tools/report.h"
#include "tristim/color/gamut.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

Json residuals_json(const ResponseFit& fit) {
  Json rows = Json::array();
  for (const FitResidual& r : fit.residuals) {
    rows.push_back({{"code", r.code},
                    {"measured", r.measured},
                    {"fitted", r.fitted},
                    {"lstar", r.lstar},
                    {"ciede2000", r.ciede2000}});
  }
  return rows;
}

Json channel_json(const ChannelFit& channel) {
  const ResponseFit& fit = channel.fit;
  Json json = Json::object();
  if (!channel.name.empty()) json["channel"] = channel.name;
  json.update({{"model", fit.model->name},
               {"formula", fit.model->formula},
               {"Vmax", channel.code_max},
               {"K", fit.k},
               {"gamma", fit.response.gamma},
               {"gain", 1 - fit.response.offset},
               {"offset", fit.response.offset},
               {"white", fit.white},
               {"black", fit.black},
               {"rms_luminance", fit.rms_luminance},
               {"rms_lstar", fit.rms_lstar},
               {"largest_lstar", fit.largest_lstar},
               {"largest_ciede2000", fit.largest_ciede2000},
               {"residuals", residuals_json(fit)}});
  return json;
}

Json matrix_json(const Eigen::Matrix3d& m) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({m(i, 0), m(i, 1), m(i, 2)});
  return rows;
}

Json gamut_json(const Primaries& primaries) {
  Json planes = Json::object();
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    Json coverage = Json::object();
    for (const std::string_view name : kPictureSets) {
      const Primaries& set = find_by_name(primaries_list(), name)->primaries;
      coverage[std::string(name)] = number_json(gamut_coverage(primaries, set, plane));
    }
    planes["cie" + std::string(plane.name)] = {{"area", gamut_area(primaries, plane)},
                                               {"coverage", coverage}};
  }
  return planes;
}

Json primaries_json(const FitReport& report) {
  const Primaries& p = report.display.primaries;
  const auto xy = [](Chromaticity c) { return Json::array({c.x, c.y}); };
  Json json{{"red", xy(p.red)},
            {"green", xy(p.green)},
            {"blue", xy(p.blue)},
            {"white", xy(p.white)},
            {"xyz_from_rgb", matrix_json(xyz_from_rgb(p))},
            {"rgb_from_xyz", matrix_json(rgb_from_xyz(p))},
            {"gamut", gamut_json(p)}};
  if (!report.measured) return json;
  if (const auto add = additivity_of(*report.measured)) {
    json["additivity"] = {{"sum", {add->sum.x, add->sum.y, add->sum.z}},
                          {"white", {add->white.x, add->white.y, add->white.z}},
                          {"excess", add->excess},
                          {"ciede2000", add->ciede2000}};
  }
  return json;
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 1, ' ') + text;
}

std::string channel_text(const ChannelFit& channel) {
  const ResponseFit& fit = channel.fit;
  std::string text =
      (channel.name.empty() ? "" : channel.name + ": ") + std::string(fit.model->name) + ", " +
      std::string(fit.model->formula) + "\n  gamma " + rounded(fit.response.gamma, 6) + ", Lw " +
      rounded(fit.white, 6) + ", Lb " + rounded(fit.black, 6) + ", gain " +
      rounded(1 - fit.response.offset, 6) + ", offset " + rounded(fit.response.offset, 6) + ", K " +
      rounded(fit.k, 6) + "\n      code    measured      fitted        L*  CIEDE2000\n";
  for (const FitResidual& r : fit.residuals) {
    text += right(shortest(r.code), 10) + right(rounded(r.measured, 6), 12) +
            right(rounded(r.fitted, 6), 12) + right(rounded(r.lstar, 3), 10) +
            right(rounded(r.ciede2000, 3), 11) + "\n";
  }
  return text + "  RMS " + rounded(fit.rms_luminance, 3) + " in luminance, " +
         rounded(fit.rms_lstar, 3) + " L*; largest " + rounded(fit.largest_lstar, 3) + " L*, " +
         rounded(fit.largest_ciede2000, 3) + " CIEDE2000\n";
}

std::string matrix_text(const Eigen::Matrix3d& m) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += " ";
    for (int k = 0; k < 3; ++k) text += right(rounded(m(i, k), 7), 13);
    text += "\n";
  }
  return text;
}

std::string coverage_text(const Primaries& primaries) {
  std::string text;
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    text += "coverage, CIE " + std::string(plane.name) + ":";
    for (const std::string_view name : kPictureSets) {
      const Primaries& set = find_by_name(primaries_list(), name)->primaries;
      text += (name == kPictureSets[0] ? " " : ", ") + std::string(name) + " " +
              rounded(100 * gamut_coverage(primaries, set, plane), 4) + " %";
    }
    text += ", area " + rounded(gamut_area(primaries, plane), 4) + "\n";
  }
  return text;
}

std::string primaries_text(const FitReport& report) {
  const Primaries& p = report.display.primaries;
  std::string text = "XYZ from RGB, white Y = 1\n" + matrix_text(xyz_from_rgb(p)) +
                     "RGB from XYZ\n" + matrix_text(rgb_from_xyz(p)) + coverage_text(p);
  if (!report.measured) return text;
  if (const auto add = additivity_of(*report.measured)) {
    text +=
        "additivity: red + green + blue exceed the white by " + rounded(100 * add->excess[0], 3) +
        " % in X, " + rounded(100 * add->excess[1], 3) + " % in Y, " +
        rounded(100 * add->excess[2], 3) + " % in Z, " + rounded(add->ciede2000, 3) + " CIEDE2000" +
        (add->ciede2000 > 2 ? ": channels are not independent, a matrix fits them badly\n" : "\n");
  }
  return text;
}

}  // namespace

Json fit_json(const FitReport& report) {
  Json json = Json::object();
  if (report.channels.size() == 1) {
    json = channel_json(report.channels[0]);
  } else {
    json["channels"] = Json::array();
    for (const ChannelFit& channel : report.channels) {
      json["channels"].push_back(channel_json(channel));
    }
  }
  json["recommended"] = report.largest_ciede2000 > kGoodFit ? "table" : "model";
  json["written"] = report.writes_table ? "table" : "model";
  if (report.has_primaries) json["primaries"] = primaries_json(report);
  return json;
}

std::string fit_text(const FitReport& report) {
  std::string text;
  for (const ChannelFit& channel : report.channels) text += channel_text(channel);
  const bool bad = report.largest_ciede2000 > kGoodFit;
  text += bad ? "the model misses a row by more than " + shortest(kGoodFit) +
                    " CIEDE2000: take the table"
              : "the model is within " + shortest(kGoodFit) + " CIEDE2000 of every row";
  text += report.writes_table == bad ? "\n"
          : report.writes_table      ? "; the table was asked for\n"
                                     : "; the model was asked for\n";
  return report.has_primaries ? text + primaries_text(report) : text;
}

}  // namespace tristim::tools
