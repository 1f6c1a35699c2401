#include "vtkOversketchScanFill.h"

#include "vtkOversketchFilterTools.h"

#include "Shading/scan_fill.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchPolylines.h"
#include "vtkOversketchShadingTools.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <string>

using namespace oversketch;

// The last mask, and what it was made of.
struct vtkOversketchScanFill::Cache
  : KeptValue<std::pair<vtkSmartPointer<vtkPolyData>, vtkSmartPointer<vtkImageData>>>
{
};

vtkStandardNewMacro(vtkOversketchScanFill);

namespace
{

constexpr std::size_t mostAreas = 64;
constexpr double farthest = 100.0; // [disc's radii]
const char* const viewArrays[] = { "ViewTransform", "ProjectionTransform", "ViewportSize" };

// A stroke's samples on the disc's plane.
Polyline onDisc(vtkPolyData* strokes, const DrawnLine& line, std::size_t stroke)
{
  bool hasView = false;
  for (const char* name : viewArrays)
  {
    hasView = hasView || strokes->GetCellData()->HasArray(name);
  }
  Polyline samples = line.Samples;
  const auto refuse = [&](std::size_t sample, const std::string& what)
  { throw Error(Failure::BadStroke, "Sample %1 of area %2 %3; draw the area again.", sample, stroke, what); };
  if (hasView)
  {
    const View view = ViewOf(StrokeAlone(strokes, static_cast<vtkIdType>(stroke)));
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const auto place = ontoCanvas(view, line.Samples[i]);
      if (!place)
      {
        refuse(i, "does not meet the disc in the view that it was drawn in");
      }
      samples[i] = *place;
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!(samples[i].cwiseAbs().maxCoeff() <= farthest))
    {
      refuse(i, "lies far outside the disc");
    }
  }
  return samples;
}

vtkSmartPointer<vtkPolyData> areasOf(vtkPolyData* strokes, const std::vector<Polyline>& outlines)
{
  auto areas = vtkSmartPointer<vtkPolyData>::New();
  Polylines lines;
  for (const Polyline& outline : outlines)
  {
    lines.Add(outline, true);
  }
  lines.Put(areas);
  areas->GetCellData()->PassData(strokes->GetCellData());
  for (const char* name : viewArrays)
  {
    areas->GetCellData()->RemoveArray(name);
  }
  return areas;
}

vtkSmartPointer<vtkImageData> maskOf(const std::vector<Polyline>& outlines, int size, const Context& context)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  LayOnDisc(mask, size);
  const auto array = NewArray<vtkUnsignedCharArray>("Area");
  const int areas = static_cast<int>(outlines.size());
  array->SetNumberOfComponents(areas);
  array->SetNumberOfTuples(mask->GetNumberOfPoints());
  array->Fill(0.0);
  for (int area = 0; area < areas; ++area)
  {
    context.checkpoint(static_cast<double>(area) / areas);
    std::vector<Pixel> pixels;
    for (const Vector2& p : outlines[static_cast<std::size_t>(area)])
    {
      pixels.push_back({ static_cast<int>(std::floor(0.5 * (p[0] + 1.0) * size)),
        static_cast<int>(std::floor(0.5 * (p[1] + 1.0) * size)) });
    }
    const std::vector<char> selected = filledMask(pixels, size, size);
    for (std::size_t i = 0; i < selected.size(); ++i)
    {
      if (selected[i])
      {
        array->SetTypedComponent(static_cast<vtkIdType>(i), area, 1);
      }
    }
  }
  mask->GetPointData()->SetScalars(array);
  return mask;
}

} // namespace

vtkOversketchScanFill::vtkOversketchScanFill()
{
  this->SetNumberOfOutputPorts(2);
  DeclareOutput(this, 1, { Port::Image });
}

vtkImageData* vtkOversketchScanFill::GetMaskOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkOversketchScanFill::RequestInformation(vtkInformation*,
  vtkInformationVector**,
  vtkInformationVector* outputs)
{
  DescribeDiscImage(outputs->GetInformationObject(1), this->Resolution, VTK_UNSIGNED_CHAR);
  return 1;
}

void vtkOversketchScanFill::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* strokes = vtkPolyData::GetData(inputs[0]);
  const StepKey key({ WholeKey(strokes) }, { static_cast<double>(this->Resolution) });
  const auto& [areas, mask] = this->Kept<Cache>().Provide(key,
    [&]
    {
      ++this->FillCount;
      const std::vector<DrawnLine> lines = ReadStrokes(strokes, 1);
      if (lines.size() > mostAreas)
      {
        throw Error(Failure::BadStroke, "There are %1 areas; there can be 64, remove some.", lines.size());
      }
      std::vector<Polyline> outlines;
      for (std::size_t i = 0; i < lines.size(); ++i)
      {
        outlines.push_back(onDisc(strokes, lines[i], i));
      }
      return std::make_pair(areasOf(strokes, outlines), maskOf(outlines, this->Resolution, ContextOf(this)));
    });
  vtkPolyData::GetData(outputs, 0)->ShallowCopy(areas);
  vtkImageData::GetData(outputs, 1)->ShallowCopy(mask);
}

void vtkOversketchScanFill::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "FillCount: " << this->FillCount << "\n";
}
