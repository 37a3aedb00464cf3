#include "lib/color/edges.h"

namespace tristim::detail {

Components matrix_edge(const Components& c, const ModelContext& context) {
  const Eigen::Vector3d v = context.matrix * Eigen::Vector3d(c[0], c[1], c[2]);
  return {v.x(), v.y(), v.z(), 0};
}

Components decode_edge(const Components& c, const ModelContext& context) {
  return {decode(context.curve, c[0]), decode(context.curve, c[1]), decode(context.curve, c[2]), 0};
}

Components encode_edge(const Components& c, const ModelContext& context) {
  return {encode(context.curve, c[0]), encode(context.curve, c[1]), encode(context.curve, c[2]), 0};
}

}  // namespace tristim::detail
