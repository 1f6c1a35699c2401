#include "Mesh/view.h"

#include "Mesh/context.h"

#include <Eigen/LU>

#include <cmath>

namespace oversketch
{

View::View(const Eigen::Matrix4d& viewTransform,
  const Eigen::Matrix4d& projectionTransform,
  int width,
  int height)
  : ViewFromWorld(viewTransform)
  , Projection(projectionTransform)
  , Width(width)
  , Height(height)
{
  constexpr double largest = 1e30; // its products still are finite
  if (!(viewTransform.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= largest) ||
      !(projectionTransform.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= largest))
  {
    throw Error(Failure::BadStroke,
      "The stroke's ViewTransform or ProjectionTransform holds a value that is not finite, or beyond 1e30; "
      "record the stroke again.");
  }
  if (width <= 0 || height <= 0)
  {
    throw Error(Failure::BadStroke, "The stroke's ViewportSize must be positive in both components.");
  }
  const Eigen::Matrix3d rotation = viewTransform.topLeftCorner<3, 3>();
  const double scale = std::cbrt(std::abs(rotation.determinant()));
  // Only the x, y, w rows of the projection count: near and far mean nothing here.
  const double focal = projectionTransform(0, 0) * projectionTransform(1, 1) -
                       projectionTransform(0, 1) * projectionTransform(1, 0);
  const Eigen::RowVector4d w = projectionTransform.row(3);
  this->Perspective = w[0] != 0.0 || w[1] != 0.0 || w[2] != 0.0;
  if (!(scale > 0.0) || !(std::abs(focal) > 0.0) || (!this->Perspective && w[3] == 0.0))
  {
    throw Error(Failure::BadStroke,
      "The stroke's ViewTransform or ProjectionTransform is singular; record the stroke again.");
  }
  this->ViewInverse = viewTransform.inverse();
  // The plane of constant camera z has this normal in world space, whatever the scale in the matrix.
  this->Normal = rotation.row(2).transpose().normalized();
  this->Eye = this->ViewInverse.topRightCorner<3, 1>() / this->ViewInverse(3, 3);
}

Vector3 View::toDisplay(const Vector3& world) const
{
  const Eigen::Vector4d camera = this->ViewFromWorld * world.homogeneous();
  const Eigen::Vector4d clip = this->Projection * camera;
  return {
    (clip[0] / clip[3] + 1.0) * 0.5 * this->Width, (clip[1] / clip[3] + 1.0) * 0.5 * this->Height, camera[2]
  };
}

Vector3 View::toScreen(const Vector3& world) const
{
  Vector3 display = this->toDisplay(world);
  if (this->Perspective)
  {
    display[2] = -1.0 / display[2];
  }
  return display;
}

double View::depth(const Vector3& world) const
{
  return this->ViewFromWorld.row(2).dot(world.homogeneous());
}

Vector3 View::toWorld(const Vector2& display, double z) const
{
  const double x = 2.0 * display[0] / this->Width - 1.0;
  const double y = 2.0 * display[1] / this->Height - 1.0;
  // Solve the two rows (P_x - x P_w) . (cx, cy, z, 1) = 0 and (P_y - y P_w) . (...) = 0 for cx, cy.
  const Eigen::RowVector4d rowX = this->Projection.row(0) - x * this->Projection.row(3);
  const Eigen::RowVector4d rowY = this->Projection.row(1) - y * this->Projection.row(3);
  Eigen::Matrix2d a;
  a << rowX[0], rowX[1], rowY[0], rowY[1];
  const Vector2 b(-(rowX[2] * z + rowX[3]), -(rowY[2] * z + rowY[3]));
  const Vector2 c = a.inverse() * b;
  return (this->ViewInverse * Eigen::Vector4d(c[0], c[1], z, 1.0)).head<3>();
}

Sight sightAt(const View& view, const Vector2& display, const Vector3& near)
{
  const Vector3 at = view.toWorld(display, view.depth(near));
  return { at, -view.towardsViewer(at).normalized() };
}

double alongAxis(const View& view, const Vector2& display, const Vector3& place, const Vector3& axis)
{
  const Sight sight = sightAt(view, display, place);
  const double slope = axis.dot(sight.direction()), apart = 1.0 - slope * slope;
  const Vector3 between = sight.origin() - place;
  return apart > 1e-9 ? (between.dot(axis) - slope * between.dot(sight.direction())) / apart : 0.0;
}

double degreesAbout(const View& view,
  const Vector2& from,
  const Vector2& to,
  const Vector3& place,
  const Vector3& axis)
{
  constexpr double leastFacing = 0.5; // cosine of the angle to the viewer
  const Vector3 toViewer = view.towardsViewer(place).normalized();
  if (std::abs(toViewer.dot(axis)) > leastFacing)
  {
    const Eigen::Hyperplane<double, 3> plane(axis, place);
    const Vector3 a = sightAt(view, from, place).intersectionPoint(plane) - place,
                  b = sightAt(view, to, place).intersectionPoint(plane) - place;
    return std::atan2(a.cross(b).dot(axis), a.dot(b)) * 180.0 / M_PI;
  }
  const Vector3 rim = pixelSize(view, place) * axis.cross(toViewer).normalized();
  const Vector2 sideways = (view.toDisplay(place + rim) - view.toDisplay(place)).head<2>();
  return (to - from).dot(sideways.normalized());
}

} // namespace oversketch
