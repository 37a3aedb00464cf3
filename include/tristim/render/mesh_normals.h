#pragma once

#include "tristim/render/polygon_model.h"

namespace tristim {

/// Gives every corner of a model a normal that is averaged over the faces at its vertex
/// [Gouraud71, Shoaff 4.1]; those it had are dropped, and vertices in one place count as one where
/// they have the same number.
///
/// `smoothing_deg`, 0..180: of the faces at a vertex only those are averaged that hang together by
/// edges at which their normals differ by that angle at the most; so a vertex on a crease has a
/// normal on each side. At 180 all are, whatever joins them: the vertex_normals of light/normals.h.
/// Where the faces of a group cancel, the corner has kNoIndex, which is the normal of its face.
///
/// Throws std::invalid_argument where kPlaneNormals finds no planes.
void average_normals(PolygonModel& model, const NormalWeighting& weighting,
                     double smoothing_deg = 180);

/// Takes the normals of all corners away: every face has its own.
void drop_normals(PolygonModel& model) noexcept;

/// Whether every corner has a normal.
bool has_normals(const PolygonModel& model) noexcept;

}  // namespace tristim
