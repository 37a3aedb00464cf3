#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

// Transforms as the config of OpenColorIO 2 has them, each on one line of YAML [OCIO].
namespace tristim::detail {

/// A word of YAML that may hold anything.
std::string yaml_text(std::string_view text);

/// RGB to m RGB + offset.
std::string ocio_matrix(const Eigen::Matrix3d& m, const Eigen::Vector3d& offset = {0, 0, 0});

/// x to scale x + offset, by channel.
std::string ocio_line(const Eigen::Vector3d& scale, const Eigen::Vector3d& offset);
std::string ocio_line(double scale, double offset);

/// x to [0, 1].
std::string ocio_clip();

/// x to x^exponent, or its inverse; x below 0 gives 0.
std::string ocio_power(double exponent, bool inverse);

/// A table of a file beside the config.
std::string ocio_table(const std::string& file);

}  // namespace tristim::detail
