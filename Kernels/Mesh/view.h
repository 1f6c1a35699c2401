// The view that a stroke carries: how world space is seen, in pixels and camera-space depth.
#ifndef oversketch_kernels_mesh_view_h
#define oversketch_kernels_mesh_view_h

#include "Mesh/mesh.h"

#include <Eigen/Geometry>

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

  int width() const { return this->Width; }
  int height() const { return this->Height; }
  bool perspective() const { return this->Perspective; }

  // Unit vector towards the viewer along the view-plane normal, in world space.
  const Vector3& normal() const { return this->Normal; }
  // The eye in world space; meaningful for a perspective view only.
  const Vector3& eye() const { return this->Eye; }

  // d(v) of the specification: the unit vector towards the viewer when orthographic, eye - v, not
  // normalised, when perspective.
  Vector3 towardsViewer(const Vector3& world) const
  {
    return this->Perspective ? Vector3(this->Eye - world) : this->Normal;
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
  bool inFront(const Vector3& world) const { return !this->Perspective || this->depth(world) < 0.0; }

  const Eigen::Matrix4d& viewTransform() const { return this->ViewFromWorld; }
  const Eigen::Matrix4d& projectionTransform() const { return this->Projection; }

private:
  Eigen::Matrix4d ViewFromWorld, Projection, ViewInverse;
  Vector3 Normal, Eye;
  int Width, Height;
  bool Perspective;
};

// The size of a pixel where a point of the world is [model length].
inline double pixelSize(const View& view, const Vector3& world)
{
  const Vector3 display = view.toDisplay(world);
  return (view.toWorld({ display[0] + 1.0, display[1] }, display[2]) - world).norm();
}

// The line of sight through a pixel, away from the viewer, from a place on it that is about as far off as
// another one.
using Sight = Eigen::ParametrizedLine<double, 3>;
Sight sightAt(const View& view, const Vector2& display, const Vector3& near);

// For a hand that drags along a unit axis through a place, or round it. How far from the place the axis comes
// nearest to the line of sight through a pixel; 0 where it looks along the axis.
double alongAxis(const View& view, const Vector2& display, const Vector3& place, const Vector3& axis);
// Degrees from one pixel to another in the axis' normal plane; about an axis that lies across the view, from
// whose rim that plane is seen edge on, a degree for a pixel sideways, as the near side of a wheel turns.
double degreesAbout(const View& view,
  const Vector2& from,
  const Vector2& to,
  const Vector3& place,
  const Vector3& axis);

} // namespace oversketch
#endif
