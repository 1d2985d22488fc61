// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

namespace segdf {

namespace {

constexpr float kNearest = 0.05F;  // metres

RTCScene buildMesh(RTCDevice device, const Mesh& mesh) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(mesh.vertices[0]), mesh.vertices.size()));
  for (const Eigen::Vector3f& v : mesh.vertices) vertices = std::copy_n(v.data(), 3, vertices);
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.triangles[0]), mesh.triangles.size());
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

std::array<float, 12> columnMajor(const Pose& pose) {
  std::array<float, 12> values{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      values[3 * column + row] = static_cast<float>(
          pose.matrix()(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
    }
  }
  return values;
}

}  // namespace

class World::Impl {
 public:
  explicit Impl(Scene scene)
      // One thread builds: with more, which of two coincident triangles is hit could change run by
      // run.
      : device_(rtcNewDevice("threads=1")), scene_(std::move(scene)) {
    if (device_ == nullptr) throw std::runtime_error("Embree cannot be started");
    top_ = rtcNewScene(device_);
    rtcSetSceneFlags(top_,
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
    addStanding();
    for (const SceneObject& object : scene_.objects) {
      if (object.moves()) addMover(object);
    }
    moveTo(0.0);
  }
  ~Impl() {
    for (Part& part : parts_) {
      rtcReleaseGeometry(part.instance);
      rtcReleaseScene(part.scene);
    }
    rtcReleaseScene(top_);
    rtcReleaseDevice(device_);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void moveTo(double time) {
    for (Part& part : parts_) {
      const Pose pose = poseOf(part, time);
      const std::array<float, 12> transform = columnMajor(pose);
      part.to_local = pose.linear().transpose().cast<float>();
      rtcSetGeometryTransform(part.instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, transform.data());
      rtcCommitGeometry(part.instance);
    }
    rtcCommitScene(top_);
  }

  std::optional<RayHit> cast(const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction,
                             double reach) const {
    RTCRayHit query = makeQuery(origin, direction, reach);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(top_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const Part& part = parts_[query.hit.instID[0]];
    const Eigen::Vector3f normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    // The normal is in the part's own frame, and rotations keep angles.
    const Eigen::Vector3f local = part.to_local * direction.cast<float>();
    RayHit hit;
    hit.range = static_cast<double>(query.ray.tfar);
    hit.cos_incidence = static_cast<double>(std::abs(normal.dot(local)) / normal.norm());
    hit.material = part.materials[query.hit.primID];
    return hit;
  }

 private:
  /// A mesh in the top-level scene: all that stands, or one mover.
  struct Part {
    RTCScene scene = nullptr;
    RTCGeometry instance = nullptr;
    const SceneObject* object = nullptr;  ///< null: stands
    const Limb* limb = nullptr;           ///< null: the object's body
    std::vector<Material> materials;
    Eigen::Matrix3f to_local = Eigen::Matrix3f::Identity();
  };

  static RTCRayHit makeQuery(const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction,
                             double reach) {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(origin.x());
    query.ray.org_y = static_cast<float>(origin.y());
    query.ray.org_z = static_cast<float>(origin.z());
    query.ray.dir_x = static_cast<float>(direction.x());
    query.ray.dir_y = static_cast<float>(direction.y());
    query.ray.dir_z = static_cast<float>(direction.z());
    query.ray.tnear = kNearest;
    query.ray.tfar = static_cast<float>(reach);
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
  }

  Pose poseOf(const Part& part, double time) const {
    if (part.object == nullptr) return Pose::Identity();
    Pose body = scene_.poseOf(*part.object, time);
    if (part.limb == nullptr) return body;
    const double cycles = part.object->at(time).way / part.limb->cycle;
    const double angle =
        part.limb->swing * std::sin(2.0 * 3.14159265358979323846 * cycles + part.limb->phase);
    const Eigen::Translation3d hip(0.0, 0.0, part.limb->pivot);
    return body * hip * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()) * hip.inverse();
  }

  void addStanding() {
    Mesh mesh;
    addGround(scene_.ground, mesh);
    for (const SceneObject& object : scene_.objects) {
      if (object.moves()) continue;
      const Pose pose = scene_.poseOf(object, 0.0);
      addSolids(object.solids, object.label(), pose, mesh);
      for (const Limb& limb : object.limbs) addSolids(limb.solids, object.label(), pose, mesh);
    }
    addPart(mesh, nullptr, nullptr);
  }

  void addMover(const SceneObject& object) {
    Mesh body;
    addSolids(object.solids, object.label(), Pose::Identity(), body);
    addPart(body, &object, nullptr);
    for (const Limb& limb : object.limbs) {
      Mesh mesh;
      addSolids(limb.solids, object.label(), Pose::Identity(), mesh);
      addPart(mesh, &object, &limb);
    }
  }

  void addPart(const Mesh& mesh, const SceneObject* object, const Limb* limb) {
    Part part;
    part.scene = buildMesh(device_, mesh);
    part.object = object;
    part.limb = limb;
    part.materials = mesh.materials;
    part.instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(part.instance, part.scene);
    rtcSetGeometryTimeStepCount(part.instance, 1);
    rtcCommitGeometry(part.instance);
    rtcAttachGeometryByID(top_, part.instance, static_cast<unsigned>(parts_.size()));
    parts_.push_back(std::move(part));
  }

  RTCDevice device_;
  Scene scene_;
  RTCScene top_ = nullptr;
  std::vector<Part> parts_;
};

World::World(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
World::~World() = default;

void World::moveTo(double time) { impl_->moveTo(time); }

std::optional<RayHit> World::cast(const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction,
                                  double reach) const {
  return impl_->cast(origin, direction, reach);
}

}  // namespace segdf
