#include "vtkOversketchDrawingTools.h"

#include "Stroke/enclosed.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

namespace oversketch
{
namespace
{

const char* const classArrays[] = { "Role", "RegionId", "ChildRegionId", "ObjectId" };

template <typename Value>
std::vector<Value> valuesOf(vtkImageData* image, const char* name)
{
  vtkDataArray* array = RequireArray(image->GetPointData(),
    name,
    1,
    image->GetNumberOfPoints(),
    "distance image",
    "take it from vtkOversketchDistance");
  std::vector<Value> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  // As it was written: a virtual call for each of a million samples costs more than the step that reads them.
  if (auto* plain = vtkAOSDataArrayTemplate<Value>::FastDownCast(array))
  {
    std::copy_n(plain->GetPointer(0), values.size(), values.begin());
    return values;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<Value>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return values;
}

[[noreturn]] void contradiction(std::size_t stroke, const std::string& what)
{
  throw Error(Failure::BadStroke,
    "{Stroke %1} %2; take the curves from vtkOversketchClassify as it put them out.",
    stroke,
    what);
}

} // namespace

Frame RasterOf(vtkPolyData* curves)
{
  vtkDataArray* array = curves->GetFieldData()->GetArray("Resolution");
  const bool given = array && array->GetNumberOfTuples() > 0;
  return given ? frameOf(CanvasOf(curves), static_cast<int>(array->GetComponent(0, 0)))
               : frameOf(CanvasOf(curves));
}

std::vector<Treatment> TreatmentsOf(vtkPolyData* curves)
{
  std::vector<Treatment> treatments(static_cast<std::size_t>(curves->GetNumberOfCells()), Treatment::Fill);
  if (curves->GetCellData()->HasArray("Treatment"))
  {
    vtkDataArray* array = RequireArray(curves->GetCellData(),
      "Treatment",
      1,
      curves->GetNumberOfCells(),
      "drawing",
      "it is one number for each stroke");
    for (std::size_t i = 0; i < treatments.size(); ++i)
    {
      const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
      if (value != 0.0 && value != 1.0 && value != 2.0)
      {
        throw Error(
          Failure::BadStroke, "Treatment of {stroke %1} is none: 0 fills, 1 is a hole, 2 a tunnel.", i);
      }
      treatments[i] = static_cast<Treatment>(static_cast<int>(value));
    }
  }
  return treatments;
}

std::vector<int> StrokeNumbers(std::string list, const char* parameter, int strokes)
{
  std::replace(list.begin(), list.end(), ',', ' ');
  std::vector<int> numbers;
  const char* at = list.data();
  const char* const end = at + list.size();
  while (at = std::find_if(at, end, [](char c) { return c != ' '; }), at != end)
  {
    int number = 0;
    const std::from_chars_result read = std::from_chars(at, end, number);
    if (read.ec != std::errc() || (read.ptr != end && *read.ptr != ' '))
    {
      throw Error(
        Failure::BadStroke, "{%1} is \"%2\"; give numbers of strokes, such as \"1 4\".", parameter, list);
    }
    if (number < 0 || number >= strokes)
    {
      const Message who("{%1} names {stroke %2}", parameter, number);
      throw Error(Failure::BadStroke, "%1, but there are %2, numbered from 0.", who, strokes);
    }
    numbers.push_back(number);
    at = read.ptr;
  }
  return numbers;
}

std::vector<int> LayersOfStrokes(vtkPolyData* curves)
{
  const std::vector<DrawnLine> lines = ReadStrokes(curves, 1);
  const std::size_t count = lines.size();
  const auto says = [&](const char* name, std::size_t i)
  {
    vtkDataArray* array = curves->GetCellData()->GetArray(name);
    return array && array->GetComponent(static_cast<vtkIdType>(i), 0) > 0.0;
  };
  const auto isIn = [&](std::size_t inner, std::size_t outer)
  {
    if (inner == outer || !lines[outer].Closed)
    {
      return false;
    }
    const std::vector<char> in = enclosedBy(lines[outer].Samples, lines[inner].Samples, ThreadsOnly());
    return std::find(in.begin(), in.end(), 0) == in.end(); // on the line is in it
  };
  std::vector<int> layers(count, -1);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      layers[i] = layers[j] == static_cast<int>(j) && isIn(i, j) ? layers[j] : layers[i];
    }
    layers[i] = says("Depth", i) && lines[i].Closed ? static_cast<int>(i) : layers[i];
  }
  // Outlines in the plane that are made in another way than the rest of it, and what lies in them.
  const std::vector<int> over = layers;
  for (std::size_t i = 0; i < count; ++i)
  {
    bool is = over[i] < 0 && lines[i].Closed && (says("Height", i) || says("CrossSection", i));
    for (std::size_t j = 0; is && j < count; ++j)
    {
      is = over[j] >= 0 || !isIn(i, j);
    }
    for (std::size_t j = 0; is && j < count; ++j)
    {
      layers[j] = over[j] < 0 && (j == i || isIn(j, i)) ? static_cast<int>(i) : layers[j];
    }
  }
  return layers;
}

std::vector<DrawnStroke> StrokesOf(vtkPolyData* curves)
{
  vtkDataArray* nodes = curves->GetPointData()->GetArray("Node");
  vtkDataArray* names = curves->GetCellData()->GetArray("StrokeId");
  std::vector<DrawnStroke> strokes;
  for (const DrawnLine& line : ReadStrokes(curves, 1))
  {
    DrawnStroke stroke{ line.Samples, line.Closed };
    for (std::size_t k = 0; nodes && k < line.Ids.size(); ++k)
    {
      if (nodes->GetComponent(line.Ids[k], 0) != 0.0)
      {
        stroke.nodes.push_back(static_cast<int>(k));
      }
    }
    const double name = names ? names->GetComponent(static_cast<vtkIdType>(strokes.size()), 0) : -1.0;
    stroke.number = name >= 0.0 && name < 1e9 ? static_cast<int>(name) : -1;
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

Drawing DrawingOf(vtkPolyData* curves)
{
  Drawing drawing;
  drawing.Rectangle = CanvasOf(curves);
  drawing.Raster = RasterOf(curves);
  drawing.Strokes = StrokesOf(curves);
  drawing.Treatments = TreatmentsOf(curves);
  return drawing;
}

Classification ClassificationOf(vtkPolyData* curves)
{
  const vtkIdType count = curves->GetNumberOfCells();
  vtkDataArray* arrays[4];
  std::transform(std::begin(classArrays),
    std::end(classArrays),
    arrays,
    [&](const char* name)
    {
      return RequireArray(
        curves->GetCellData(), name, 1, count, "drawing", "take the curves from vtkOversketchClassify");
    });
  Classification result;
  result.strokes.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < result.strokes.size(); ++i)
  {
    const auto value = [&](int array)
    { return static_cast<int>(arrays[array]->GetComponent(static_cast<vtkIdType>(i), 0)); };
    StrokeClass& stroke = result.strokes[i];
    if (value(0) < static_cast<int>(Role::Rejected) || value(0) > static_cast<int>(Role::OpenFeature) ||
        value(0) == static_cast<int>(Role::Unknown))
    {
      contradiction(i, "has no Role");
    }
    stroke.role = static_cast<Role>(value(0));
    stroke.region = value(1);
    stroke.childRegion = value(2);
    stroke.object = value(3);
    result.objects = std::max(result.objects, stroke.object + 1);
    const bool bounds = stroke.role == Role::Boundary || stroke.role == Role::ClosedFeature;
    if (bounds)
    {
      // Regions are numbered in the strokes' order.
      Region region;
      region.stroke = static_cast<int>(i);
      region.parent = stroke.role == Role::ClosedFeature ? stroke.region : -1;
      region.object = stroke.object;
      const int number = stroke.role == Role::Boundary ? stroke.region : stroke.childRegion;
      if (number != static_cast<int>(result.regions.size()))
      {
        contradiction(i, "does not bound the next region");
      }
      result.regions.push_back(region);
    }
  }
  const int regions = static_cast<int>(result.regions.size());
  for (std::size_t i = 0; i < result.strokes.size(); ++i)
  {
    const StrokeClass& stroke = result.strokes[i];
    if (stroke.role == Role::Rejected)
    {
      continue;
    }
    if (stroke.region < 0 || stroke.region >= regions || stroke.object < 0 ||
        result.regions[stroke.region].object != stroke.object)
    {
      contradiction(i, "lies in a region that there is not, or that is of another object");
    }
    Region& region = result.regions[stroke.region];
    if (stroke.role != Role::Boundary)
    {
      region.features.push_back(static_cast<int>(i));
    }
    if (stroke.role == Role::ClosedFeature)
    {
      region.children.push_back(stroke.childRegion);
    }
  }
  for (int r = 0; r < regions; ++r)
  {
    Region& region = result.regions[r];
    for (int around = region.parent; around >= 0; around = result.regions[around].parent)
    {
      if (++region.depth > regions)
      {
        contradiction(region.stroke, "lies in a region that it is round");
      }
    }
  }
  return result;
}

void WriteClassification(const Classification& classification, vtkPolyData* curves)
{
  const auto add = [&](int array, const auto& value) {
    curves->GetCellData()->AddArray(ArrayOf<vtkIntArray>(classArrays[array], classification.strokes, value));
  };
  add(0, &StrokeClass::role);
  add(1, &StrokeClass::region);
  add(2, &StrokeClass::childRegion);
  add(3, &StrokeClass::object);
}

MeshKey DrawingKey(vtkPolyData* curves)
{
  std::vector<vtkDataArray*> arrays{ curves->GetFieldData()->GetArray("Canvas"),
    curves->GetFieldData()->GetArray("Resolution"),
    curves->GetCellData()->GetArray("Treatment"),
    curves->GetCellData()->GetArray("StrokeId"),
    curves->GetPointData()->GetArray("Node") };
  for (const char* name : classArrays)
  {
    arrays.push_back(curves->GetCellData()->GetArray(name));
  }
  return MeshKey(curves, arrays);
}

DistanceMaps DistanceMapsOf(vtkImageData* image)
{
  DistanceMaps maps;
  maps.frame = FrameOf(image);
  maps.object = valuesOf<int>(image, "Object");
  maps.distance = valuesOf<float>(image, "T");
  maps.thickness = valuesOf<float>(image, "LocalMax");
  maps.skeleton = valuesOf<std::uint8_t>(image, "Skeleton");
  return maps;
}

const DistanceMaps& KeptMaps::Of(vtkImageData* image)
{
  return this->Maps.Provide(StepKey({ ImageKey(image) }, {}), [image] { return DistanceMapsOf(image); });
}

DistanceMaps UphillMapsOf(vtkImageData* image, const Context& context)
{
  DistanceMaps maps = DistanceMapsOf(image);
  std::vector<float> thickness = std::move(maps.thickness);
  std::vector<std::uint8_t> skeleton = std::move(maps.skeleton);
  findThickness(maps, ThicknessMode::Local, context); // writes these, too
  maps.thickness = std::move(thickness);
  maps.skeleton = std::move(skeleton);
  return maps;
}

void WriteDistanceMaps(const DistanceMaps& maps, vtkImageData* image)
{
  WriteFrame(maps.frame, image);
  vtkPointData* data = image->GetPointData();
  data->AddArray(ArrayOf<vtkFloatArray>("T", maps.distance));
  data->AddArray(ArrayOf<vtkFloatArray>("LocalMax", maps.thickness));
  data->AddArray(ArrayOf<vtkUnsignedCharArray>("Skeleton", maps.skeleton));
  data->AddArray(ArrayOf<vtkIntArray>("Object", maps.object));
  data->SetActiveScalars("T");
}

MeshKey ImageKey(vtkImageData* image)
{
  std::vector<vtkDataArray*> arrays(static_cast<std::size_t>(image->GetPointData()->GetNumberOfArrays()));
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    arrays[i] = image->GetPointData()->GetArray(static_cast<int>(i));
  }
  vtkNew<vtkPolyData> none;
  return MeshKey(none, arrays);
}

void WriteFrame(const Frame& frame, vtkImageData* image)
{
  image->SetDimensions(frame.width, frame.height, 1);
  image->SetOrigin(frame.origin[0], frame.origin[1], 0.0);
  image->SetSpacing(frame.spacing, frame.spacing, frame.spacing);
}

Frame FrameOf(vtkImageData* image)
{
  const PicturePlace place = PlaceOf(image);
  if (place.Spacing[0] != place.Spacing[1] || place.Columns < 3 || place.Rows < 3)
  {
    throw Error(Failure::BadStroke,
      "The distance image has no square pixels or too few of them; take it from vtkOversketchDistance.");
  }
  return { place.Origin, place.Spacing[0], place.Columns, place.Rows };
}

int DescribeImage(vtkAlgorithm* self,
  vtkInformation* output,
  int scalarType,
  const std::function<Frame(vtkPolyData* curves)>& frame)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  double origin[3] = { 0.0, 0.0, 0.0 }, spacing[3] = { 1.0, 1.0, 1.0 };
  if (self->GetNumberOfInputConnections(0) > 0)
  {
    vtkAlgorithmOutput* source = self->GetInputConnection(0, 0);
    if (!source->GetProducer()->GetExecutive()->Update(source->GetIndex()))
    {
      return 0;
    }
    auto* curves = vtkPolyData::SafeDownCast(self->GetInputDataObject(0, 0));
    if (curves && curves->GetNumberOfPoints() > 0)
    {
      try
      {
        const Frame raster = frame(curves);
        extent[1] = raster.width - 1;
        extent[3] = raster.height - 1;
        extent[5] = 0;
        std::copy_n(raster.origin.data(), 2, origin);
        std::fill_n(spacing, 3, raster.spacing);
      }
      catch (const Error&)
      {
        extent[1] = -1;
      }
    }
  }
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  output->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(output, scalarType, 1);
  return 1;
}

} // namespace oversketch
