#pragma once

#include <embree3/rtcore.h>

#include "tristim/render/mesh.h"

namespace tristim {

/// A mesh as Embree searches it, on one thread.
class EmbreeMesh {
 public:
  explicit EmbreeMesh(const Mesh& mesh, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, flags);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.positions.size()));
    for (const Eigen::Vector3d& p : mesh.positions) {
      for (int axis = 0; axis < 3; ++axis) *places++ = static_cast<float>(p[axis]);
    }
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (const MeshTriangle& triangle : mesh.triangles) {
      for (const MeshCorner& corner : triangle.corners) *corners++ = corner.position;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeMesh() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeMesh(const EmbreeMesh&) = delete;
  EmbreeMesh& operator=(const EmbreeMesh&) = delete;

  RTCScene scene() const noexcept { return scene_; }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace tristim
