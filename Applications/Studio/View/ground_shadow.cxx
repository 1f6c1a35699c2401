#include "ground_shadow.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace oversketch_studio
{

namespace
{

constexpr int shadowSide = 256;       // px of the picture
constexpr double shadowMargin = 0.25; // of the models' width, on each side, for what is blurred
constexpr double shadowNear = 0.12;   // of the models' height: what is lower touches the ground, nearly
constexpr double nearBlur = 3.0, farBlur = 12.0;  // px
constexpr double nearDark = 0.45, farDark = 0.35; // alpha
constexpr double fromBelow = 0.35;                // of the darkness, seen from below
// Faces of a mesh that are drawn, for time: of a larger one each second, third, …; what gaps there are is
// blurred.
constexpr vtkIdType mostFaces = 150'000;

// Where the models stand: the corner of a square of the ground, and how high they are above it.
struct Stand
{
  std::array<int, 2> axes{}; // that lie in the ground
  std::array<double, 2> low{};
  double width = 0.0, height = 0.0;
};

Stand standOf(const vtkBoundingBox& box, int up, double ground)
{
  Stand square;
  square.axes = { 0, 3 - up };
  const double* low = box.GetMinPoint();
  const double* high = box.GetMaxPoint();
  const auto across = [&](int axis) { return high[axis] - low[axis]; };
  square.width = (1.0 + 2.0 * shadowMargin) * std::max(across(0), across(3 - up));
  for (std::size_t i = 0; i < 2; ++i)
  {
    const int axis = square.axes[i];
    square.low[i] = 0.5 * (low[axis] + high[axis] - square.width);
  }
  square.height = high[up] - ground;
  return square;
}

// Draws what a mesh covers of the square, and what its low parts do. Faces of a pixel or two, nearly all of a
// fine mesh, are drawn by their corners, which takes less time.
void project(vtkPolyData* mesh, const Stand& square, int up, double ground, cv::Mat& all, cv::Mat& low)
{
  const double scale = shadowSide / square.width;
  const double touching = ground + shadowNear * square.height;
  const vtkIdType step = 1 + mesh->GetNumberOfPolys() / mostFaces;
  const auto faces = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  std::vector<cv::Point> corners;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); face += step)
  {
    faces->GoToCell(face);
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    faces->GetCurrentCell(count, points);
    corners.clear();
    double lowest = VTK_DOUBLE_MAX;
    bool isTiny = true;
    for (vtkIdType i = 0; i < count; ++i)
    {
      double place[3];
      mesh->GetPoint(points[i], place);
      const auto pixel = [&](std::size_t axis)
      {
        const double at = scale * (place[square.axes[axis]] - square.low[axis]);
        return std::clamp(static_cast<int>(at), 0, shadowSide - 1);
      };
      corners.emplace_back(pixel(0), pixel(1));
      lowest = std::min(lowest, place[up]);
      const cv::Point across = corners.back() - corners.front();
      isTiny = isTiny && std::abs(across.x) < 2 && std::abs(across.y) < 2;
    }
    for (cv::Mat* picture : { &all, lowest < touching ? &low : nullptr })
    {
      if (picture && isTiny)
      {
        for (const cv::Point& corner : corners)
        {
          picture->at<unsigned char>(corner) = 255;
        }
      }
      else if (picture)
      {
        cv::fillConvexPoly(*picture, corners, 255);
      }
    }
  }
}

} // namespace

GroundShadow::GroundShadow(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Picture->SetDimensions(shadowSide, shadowSide, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  this->Texture->SetInputData(this->Picture);
  this->Texture->SetColorModeToDirectScalars();
  this->Texture->InterpolateOn();
  this->Texture->RepeatOff();
  this->Texture->EdgeClampOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(this->Plane->GetOutputPort());
  // Lines of the ground, and what stands on it, are in front.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 200.0);
  this->Actor->SetMapper(mapper);
  this->Actor->SetTexture(this->Texture);
  this->Actor->ForceTranslucentOn();
  this->Actor->GetProperty()->LightingOff();
  this->Actor->PickableOff();
  this->Actor->VisibilityOff();
  renderer->AddActor(this->Actor);
}

GroundShadow::~GroundShadow()
{
  this->Renderer->RemoveActor(this->Actor);
}

void GroundShadow::setGround(int up, double height)
{
  this->Up = up;
  this->Height = height;
  this->Stale = true;
}

void GroundShadow::cast(const std::vector<vtkPolyData*>& meshes)
{
  std::vector<std::pair<vtkPolyData*, vtkMTimeType>> of;
  vtkBoundingBox box;
  for (vtkPolyData* mesh : this->Shown ? meshes : std::vector<vtkPolyData*>())
  {
    if (mesh->GetNumberOfPolys() > 0)
    {
      of.emplace_back(mesh, mesh->GetMTime());
      box.AddBounds(mesh->GetBounds());
    }
  }
  if (!this->Stale && of == this->Of)
  {
    return;
  }
  this->Stale = false;
  this->Of = std::move(of);
  const Stand square = box.IsValid() ? standOf(box, this->Up, this->Height) : Stand();
  const bool isSeen = square.width > 0.0 && std::isfinite(square.width);
  this->Actor->SetVisibility(isSeen);
  if (!isSeen)
  {
    return;
  }
  cv::Mat all = cv::Mat::zeros(shadowSide, shadowSide, CV_8U), low = all.clone();
  for (const auto& [mesh, time] : this->Of)
  {
    project(mesh, square, this->Up, this->Height, all, low);
  }
  cv::GaussianBlur(all, all, {}, farBlur, farBlur, cv::BORDER_CONSTANT);
  cv::GaussianBlur(low, low, {}, nearBlur, nearBlur, cv::BORDER_CONSTANT);
  auto* pixels = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
  for (int i = 0; i < shadowSide * shadowSide; ++i)
  {
    std::fill_n(pixels + 4 * i, 3, static_cast<unsigned char>(0));
    const double dark = farDark * all.data[i] + nearDark * low.data[i];
    pixels[4 * i + 3] = static_cast<unsigned char>(std::lround(dark));
  }
  this->Picture->GetPointData()->GetScalars()->Modified();
  this->Picture->Modified();
  double corners[3][3];
  for (double* corner : corners)
  {
    corner[square.axes[0]] = square.low[0];
    corner[square.axes[1]] = square.low[1];
    corner[this->Up] = this->Height;
  }
  corners[1][square.axes[0]] += square.width;
  corners[2][square.axes[1]] += square.width;
  this->Plane->SetOrigin(corners[0]);
  this->Plane->SetPoint1(corners[1]);
  this->Plane->SetPoint2(corners[2]);
  this->Renderer->ResetCameraClippingRange();
}

void GroundShadow::look()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const bool isAbove = camera->GetParallelProjection() ? camera->GetDirectionOfProjection()[this->Up] < 0.0
                                                       : camera->GetPosition()[this->Up] > this->Height;
  this->Actor->GetProperty()->SetOpacity(isAbove ? 1.0 : fromBelow);
}

} // namespace oversketch_studio
