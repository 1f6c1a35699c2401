#include "vtkOversketchLayerTools.h"

#include "Ray/surface_rays.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchInflateDrawing.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStepRunner.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace oversketch
{
namespace
{

const char* const arraysOfLayers[] = { "Depth", "Height", "CrossSection" };

// Values of a cell array, 0 where there is none; of one whose values have meanings whole numbers up to
// `most`.
std::vector<double> saidBy(vtkPolyData* drawing, const char* name, int most, const Message& remedy)
{
  const vtkIdType count = drawing->GetNumberOfCells();
  std::vector<double> values(static_cast<std::size_t>(count), 0.0);
  vtkDataArray* array =
    OptionalArray(drawing->GetCellData(), name, 1, count, "drawing", "it is one number for each stroke");
  for (std::size_t i = 0; array && i < values.size(); ++i)
  {
    const double value = values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(value >= 0.0) || !std::isfinite(value) ||
        (most > 0 && (value > most || value != std::floor(value))))
    {
      throw Error(Failure::BadStroke, "%1 of {stroke %2} is none: %3.", name, i, remedy);
    }
  }
  return values;
}

vtkSmartPointer<vtkPolyData> strokesOf(vtkPolyData* drawing, const std::vector<int>& numbers)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const int number : numbers)
  {
    append->AddInputData(StrokeAlone(drawing, number));
  }
  auto strokes = vtkSmartPointer<vtkPolyData>::New();
  if (!numbers.empty())
  {
    append->Update();
    strokes->ShallowCopy(append->GetOutput());
  }
  for (const char* name : arraysOfLayers)
  {
    strokes->GetCellData()->RemoveArray(name);
  }
  strokes->GetFieldData()->ShallowCopy(drawing->GetFieldData());
  return strokes;
}

} // namespace

std::string DrawingLayer::Own(const std::vector<int>& list) const
{
  std::string own;
  for (const int number : list)
  {
    const auto it = std::lower_bound(this->Numbers.begin(), this->Numbers.end(), number);
    if (it != this->Numbers.end() && *it == number)
    {
      own += std::to_string(it - this->Numbers.begin()) + " ";
    }
  }
  return own;
}

std::vector<DrawingLayer> LayersOf(vtkPolyData* drawing, vtkImageData* picture, const DepthLists& lists)
{
  std::vector<double> depths =
    saidBy(drawing, "Depth", inFront | isBehind, "0 is in the plane, 1 in front, 2 behind, 3 both");
  const std::vector<double> heights =
                              saidBy(drawing, "Height", 0, "a factor above 0, or 0 for the drawing's"),
                            sections = saidBy(drawing,
                              "CrossSection",
                              3,
                              "0 is the drawing's, 1 a circle, 2 linear, 3 a step");
  const std::size_t count = depths.size();
  // Strokes that lists name, which go before the array, and what they say together.
  std::vector<const char*> named(count, nullptr);
  for (std::size_t k = 0; k < lists.size(); ++k)
  {
    const char* parameter = std::array{ "InFront", "Behind", "BothSides" }[k];
    for (const int stroke : StrokeNumbers(lists[k], parameter, static_cast<int>(count)))
    {
      const int already = named[stroke] ? static_cast<int>(depths[stroke]) : 0;
      depths[stroke] = already | static_cast<int>(k + 1);
      named[stroke] = parameter;
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    any = any || depths[i] > 0.0 || heights[i] > 0.0 || sections[i] > 0.0;
  }
  if (!any)
  {
    return {};
  }
  vtkNew<vtkOversketchCanvas> canvas;
  canvas->SetInputData(0, drawing);
  canvas->SetInputData(1, picture);
  StepRunner(canvas, {}).Run();
  const std::vector<DrawnLine> lines = ReadStrokes(canvas->GetOutput(), 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (named[i] && !lines[i].Closed)
    {
      throw Error(Failure::BadStroke,
        "{%1} names {stroke %2}, which is open; close it, or name one that is closed.",
        named[i],
        i);
    }
  }
  canvas->GetOutput()->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("Depth", depths));
  const std::vector<int> of = LayersOfStrokes(canvas->GetOutput());
  std::vector<DrawingLayer> layers(1);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (of[i] == static_cast<int>(i))
    {
      layers.push_back({ static_cast<int>(i),
        static_cast<int>(depths[i]),
        heights[i] > 0.0 ? heights[i] : 1.0,
        static_cast<int>(sections[i]),
        {},
        {} });
    }
  }
  for (DrawingLayer& layer : layers)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (of[i] == layer.Line)
      {
        layer.Numbers.push_back(static_cast<int>(i));
      }
    }
    layer.Strokes = strokesOf(drawing, layer.Numbers);
  }
  return layers.size() > 1 ? layers : std::vector<DrawingLayer>();
}

void TakeSystems(std::vector<DrawingLayer>& layers, std::vector<DrawingLayer>& before)
{
  if (!layers.empty() && !before.empty() && SameLines(layers[0].Strokes, before[0].Strokes))
  {
    layers[0].Strokes = before[0].Strokes;
  }
  for (const bool same : { true, false })
  {
    for (std::size_t k = 1; k < layers.size(); ++k)
    {
      DrawingLayer& layer = layers[k];
      for (std::size_t j = 1; !layer.System && j < before.size(); ++j)
      {
        if (before[j].System && (!same || SameLines(layer.Strokes, before[j].Strokes)))
        {
          std::swap(layer.System, before[j].System);
          layer.Strokes = same ? before[j].Strokes : layer.Strokes;
        }
      }
      if (!same && !layer.System)
      {
        layer.System = vtkSmartPointer<vtkOversketchInflateDrawing>::New();
      }
    }
  }
}

namespace
{

// A body that has been placed.
struct Lying
{
  std::shared_ptr<const SurfaceRays> Rays; // of it in the plane
  double Z;                                // that it was moved by
};

// The mean height, over the area that a body covers in the plane, of what is seen of the others along z: from
// the front (sign 1) or from behind (-1). Places over nothing do not count.
std::optional<double> heightUnder(const Mesh& body,
  vtkDataArray* sides,
  const std::vector<Lying>& others,
  double sign,
  const Context& context)
{
  std::vector<Vector2> parts(body.triangles.size(), Vector2::Zero()); // area and area times height
  context.eachUntilCancelled(static_cast<int>(parts.size()),
    [&](int t)
    {
      if (sides->GetComponent(t, 0) <= 0.0)
      {
        return;
      }
      const auto at = [&](int k) -> Vector3 { return body.points[body.triangles[t][k]]; };
      const Vector3 middle = (at(0) + at(1) + at(2)) / 3.0;
      double highest = -std::numeric_limits<double>::infinity();
      for (const Lying& other : others)
      {
        const Vector3 from(
          middle[0], middle[1], other.Rays->centre()[2] + 2.0 * sign * other.Rays->diagonal());
        const SurfaceHit hit = other.Rays->nearest({ from, Vector3(0.0, 0.0, -sign) });
        highest = hit.found() ? std::max(highest, sign * (hit.position[2] + other.Z)) : highest;
      }
      if (std::isfinite(highest))
      {
        const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0))[2];
        parts[static_cast<std::size_t>(t)] = { area, area * highest };
      }
    });
  context.checkpoint(1.0);
  Vector2 sum = Vector2::Zero();
  for (const Vector2& part : parts)
  {
    sum += part;
  }
  return sum[0] > 0.0 ? std::optional<double>(sign * sum[1] / sum[0]) : std::nullopt;
}

vtkSmartPointer<vtkPolyData> placedAt(const LayerBody& body, const DrawingLayer& layer, double z)
{
  auto placed = vtkSmartPointer<vtkPolyData>::New();
  placed->ShallowCopy(body.Made);
  const double rows[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, z, 0.0, 0.0, 0.0, 1.0 };
  const auto placement = NewArray<vtkDoubleArray>("Placement", 16, 1);
  placement->SetTypedTuple(0, rows);
  placed->GetFieldData()->AddArray(placement);
  const auto numbers =
    NewArray<vtkIntArray>("LayerId", 1, static_cast<std::size_t>(placed->GetNumberOfCells()));
  numbers->FillValue(body.Layer);
  placed->GetCellData()->AddArray(numbers);
  vtkDataArray* curves = body.Made->GetPointData()->GetArray("StrokeId");
  vtkDataArray* strokes = body.Curves->GetCellData()->GetArray("StrokeId");
  const auto ids =
    NewArray<vtkIntArray>("StrokeId", 1, static_cast<std::size_t>(placed->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < placed->GetNumberOfPoints(); ++i)
  {
    const auto curve = static_cast<vtkIdType>(curves->GetComponent(i, 0));
    ids->SetValue(
      i, curve < 0 ? -1 : layer.Numbers[static_cast<std::size_t>(strokes->GetComponent(curve, 0))]);
  }
  placed->GetPointData()->AddArray(ids);
  return placed;
}

} // namespace

std::vector<vtkSmartPointer<vtkPolyData>> PlacedBodies(const std::vector<DrawingLayer>& layers,
  const std::vector<LayerBody>& bodies,
  const std::function<void(const Message& message)>& warn,
  const Context& context)
{
  std::vector<vtkSmartPointer<vtkPolyData>> placed;
  std::vector<Lying> lying;
  for (const LayerBody& body : bodies)
  {
    const DrawingLayer& layer = layers[static_cast<std::size_t>(body.Layer)];
    vtkNew<vtkPolyData> bare; // of normals and all else that triangles need not have
    bare->SetPoints(body.Made->GetPoints());
    bare->SetPolys(body.Made->GetPolys());
    bare->GetCellData()->AddArray(body.Made->GetCellData()->GetArray("Side"));
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(bare);
    triangles->Update();
    const std::shared_ptr<const Mesh> mesh = SharedMesh(triangles->GetOutput())->KeptSurface();
    const auto rays = std::make_shared<const SurfaceRays>(mesh, context);
    // Rounded, so that both sides of a symmetric body have one height.
    const double grid = std::exp2(std::ilogb(rays->diagonal()) - 30);
    std::vector<double> heights;
    for (const int side : { inFront, isBehind })
    {
      if (!lying.empty() && (layer.Depth & side) != 0)
      {
        const std::optional<double> z = heightUnder(*mesh,
          triangles->GetOutput()->GetCellData()->GetArray("Side"),
          lying,
          side == inFront ? 1.0 : -1.0,
          context);
        if (z)
        {
          heights.push_back(grid * std::nearbyint(*z / grid));
        }
        else if (side == inFront || layer.Depth == isBehind) // once
        {
          warn({ "{Stroke %1} lies over nothing, so it stays in the plane; draw it over what it lies on.",
            layer.Line });
        }
      }
    }
    if (heights.empty())
    {
      heights.push_back(0.0);
    }
    for (const double z : heights)
    {
      placed.push_back(placedAt(body, layer, z));
      lying.push_back({ rays, z });
    }
  }
  return placed;
}

} // namespace oversketch
