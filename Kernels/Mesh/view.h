// The view that a stroke carries: how world space is seen, in pixels and camera-space depth.
#ifndef oversketch_view_h
#define oversketch_view_h

#include "Mesh/mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace oversketch
{

class View
{
public:
  // world -> camera and camera -> clip (column vectors), viewport size in pixels. Throws
  // Error(Failure::BadStroke) when a matrix is singular or not finite or the size is not positive.
  View(const Eigen::Matrix4d& viewTransform,
    const Eigen::Matrix4d& projectionTransform,
    int width,
    int height);

  int width() const { return this->width_; }
  int height() const { return this->height_; }
  bool perspective() const { return this->perspective_; }

  // Unit vector towards the viewer along the view-plane normal, in world space.
  const Vector3& normal() const { return this->normal_; }
  // The eye in world space; meaningful for a perspective view only.
  const Vector3& eye() const { return this->eye_; }

  // d(v) of the specification: the unit vector towards the viewer when orthographic, eye - v, not
  // normalised, when perspective.
  Vector3 towardsViewer(const Vector3& world) const
  {
    return this->perspective_ ? Vector3(this->eye_ - world) : this->normal_;
  }

  // (x px, y px, camera-space z): display coordinates from the lower left corner, y up; z grows towards
  // the viewer and is negative in front of the eye.
  Vector3 toDisplay(const Vector3& world) const;
  // (x px, y px, d) where d is affine on screen over a plane, also in perspective: camera z when
  // orthographic, -1/z when perspective (grows towards the viewer).
  Vector3 toScreen(const Vector3& world) const;
  // The world point at display position (x, y) on the plane of camera depth z.
  Vector3 toWorld(const Vector2& display, double z) const;
  double depth(const Vector3& world) const;
  // False for a point at or behind the eye of a perspective view: it has no place on screen.
  bool inFront(const Vector3& world) const { return !this->perspective_ || this->depth(world) < 0.0; }

  const Eigen::Matrix4d& viewTransform() const { return this->view_; }
  const Eigen::Matrix4d& projectionTransform() const { return this->projection_; }

private:
  Eigen::Matrix4d view_, projection_, viewInverse_;
  Vector3 normal_, eye_;
  int width_, height_;
  bool perspective_;
};

} // namespace oversketch
#endif
