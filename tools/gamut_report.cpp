#include "tools/gamut_report.h"

#include <algorithm>
#include <cmath>

#include "tools/report.h"
#include "tristim/color/gamut.h"
#include "tristim/color/macadam.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 6;  // of the text; JSON has all

// What all sets have in common.
Polygon common_polygon(const std::vector<DiagramGamut>& sets, const ChromaticityPlane& plane) {
  Polygon common = gamut_triangle(sets.front().primaries, plane);
  for (const DiagramGamut& set : sets) {
    common = convex_intersection(common, gamut_triangle(set.primaries, plane));
  }
  return common;
}

// A colour as a set of primaries sees it, adapted to their white.
GamutPosition position_of(const GamutColor& color, const DiagramGamut& set,
                          const GamutQuestion& question) {
  const Eigen::Vector3d xyz =
      adaptation_matrix(question.white, set.primaries.white, question.adaptation) *
      Eigen::Vector3d(color.xyz.x, color.xyz.y, color.xyz.z);
  return gamut_position({xyz.x(), xyz.y(), xyz.z()}, set.primaries);
}

Json polygon_json(const Polygon& polygon) {
  Json corners = Json::array();
  for (const PlanePoint& p : polygon) corners.push_back({p.x, p.y});
  return corners;
}

Json plane_json(const GamutQuestion& question, const ChromaticityPlane& plane) {
  Json areas = Json::object();
  Json coverage = Json::object();
  for (const DiagramGamut& row : question.sets) {
    areas[row.name] = gamut_area(row.primaries, plane);
    for (const DiagramGamut& column : question.sets) {
      coverage[row.name][column.name] =
          number_json(gamut_coverage(row.primaries, column.primaries, plane));
    }
  }
  const Polygon common = common_polygon(question.sets, plane);
  return {{"plane", plane.name},
          {"formula", plane.formula},
          {"area", areas},
          {"coverage", coverage},
          {"common", {{"area", polygon_area(common)}, {"corners", polygon_json(common)}}}};
}

Json position_json(const GamutPosition& position) {
  return {{"inside", position.inside()},
          {"rgb",
           {number_json(position.rgb.r), number_json(position.rgb.g), number_json(position.rgb.b)}},
          {"below_0", number_json(position.below)},
          {"above_1", number_json(position.above)},
          {"distance_uv76", number_json(position.distance)}};
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 1, ' ') + text;
}

std::size_t name_width(const std::vector<DiagramGamut>& sets) {
  std::size_t width = 8;
  for (const DiagramGamut& set : sets) width = std::max(width, set.name.size());
  return width + 2;
}

std::string areas_text(const std::vector<DiagramGamut>& sets) {
  const std::size_t width = name_width(sets);
  std::string text = padded("area", width);
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    text += right("CIE " + std::string(plane.name), 12);
  }
  for (const DiagramGamut& set : sets) {
    text += "\n" + padded(set.name, width);
    for (const ChromaticityPlane& plane : kChromaticityPlanes) {
      text += right(rounded(gamut_area(set.primaries, plane), kDigits), 12);
    }
  }
  return text + "\n";
}

std::string coverage_text(const std::vector<DiagramGamut>& sets, const ChromaticityPlane& plane) {
  const std::size_t width = name_width(sets);
  std::string text = "\ncoverage of the column by the row in percent, CIE " +
                     std::string(plane.name) + "\n" + padded("", width);
  for (const DiagramGamut& column : sets) text += right(column.name, width);
  for (const DiagramGamut& row : sets) {
    text += "\n" + padded(row.name, width);
    for (const DiagramGamut& column : sets) {
      const double part = gamut_coverage(row.primaries, column.primaries, plane);
      text += right(rounded(100 * part, kDigits), width);
    }
  }
  return text + "\n";
}

std::string common_text(const std::vector<DiagramGamut>& sets) {
  std::string text = "\ncommon to all\n";
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    const Polygon common = common_polygon(sets, plane);
    text += "  CIE " + std::string(plane.name) + ": area " +
            rounded(polygon_area(common), kDigits) + (common.empty() ? "" : ", corners");
    for (const PlanePoint& p : common) {
      text += (&p == &common.front() ? " " : ", ") + rounded(p.x, kDigits) + " " +
              rounded(p.y, kDigits);
    }
    text += "\n";
  }
  return text;
}

std::string position_text(const GamutPosition& position) {
  std::string text = position.inside() ? "inside" : "outside";
  if (position.distance > 0) {
    text += ", " + rounded(position.distance, 4) + " in u' v' from the triangle";
  }
  if (position.below > 0) text += ", " + rounded(position.below, 4) + " below 0";
  if (position.above > 0) text += ", " + rounded(position.above, 4) + " above 1";
  text += "; linear r g b";
  for (const double light : {position.rgb.r, position.rgb.g, position.rgb.b}) {
    text += " " + rounded(std::fabs(light) < kGamutSlack ? 0 : light, kDigits);
  }
  return text + "\n";
}

std::string limit_text(double luminance, double limit, const Illuminant& illuminant) {
  return ", MacAdam limit " + rounded(100 * limit, kDigits) + " % under " +
         std::string(illuminant.name) +
         (luminance > limit ? ": brighter than any surface\n" : "\n");
}

std::string colors_text(const GamutQuestion& question) {
  const OptimalColors optimal = optimal_colors(*question.illuminant);
  std::string text;
  for (const GamutColor& color : question.colors) {
    const Xyy xyy = xyz_to_xyy(color.xyz);
    text += "\n" + color.name + ": x " + rounded(xyy.x, kDigits) + " y " + rounded(xyy.y, kDigits) +
            " Y " + rounded(100 * xyy.luminance, kDigits) + " %" +
            limit_text(xyy.luminance, optimal.limit({xyy.x, xyy.y}), *question.illuminant);
    for (const DiagramGamut& set : question.sets) {
      text += "  " + padded(set.name, name_width(question.sets)) +
              position_text(position_of(color, set, question));
    }
  }
  return text;
}

Json colors_json(const GamutQuestion& question) {
  const OptimalColors optimal = optimal_colors(*question.illuminant);
  Json colors = Json::array();
  for (const GamutColor& color : question.colors) {
    const Xyy xyy = xyz_to_xyy(color.xyz);
    Json sets = Json::object();
    for (const DiagramGamut& set : question.sets) {
      sets[set.name] = position_json(position_of(color, set, question));
    }
    colors.push_back({{"name", color.name},
                      {"xyY", {number_json(xyy.x), number_json(xyy.y), number_json(xyy.luminance)}},
                      {"macadam_limit", number_json(optimal.limit({xyy.x, xyy.y}))},
                      {"sets", sets}});
  }
  return colors;
}

}  // namespace

Json gamut_json(const GamutQuestion& question) {
  Json json = Json::object();
  json["planes"] = Json::array();
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    json["planes"].push_back(plane_json(question, plane));
  }
  if (!question.colors.empty()) {
    json["illuminant"] = question.illuminant->name;
    json["colors"] = colors_json(question);
  }
  return json;
}

std::string gamut_text(const GamutQuestion& question) {
  std::string text = areas_text(question.sets);
  if (question.sets.size() > 1) {
    for (const ChromaticityPlane& plane : kChromaticityPlanes) {
      text += coverage_text(question.sets, plane);
    }
    text += common_text(question.sets);
  }
  return question.colors.empty() ? text : text + colors_text(question);
}

}  // namespace tristim::tools
