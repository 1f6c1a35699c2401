#include "vtkOversketchTrace.h"

#include "Raster/trace.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPolylines.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTrace);

namespace
{

// The samples in 8 bits; of 16 bits the upper ones count.
std::vector<std::uint8_t> bytesOf(vtkImageData* picture)
{
  vtkDataArray* scalars = picture->GetPointData()->GetScalars();
  if (!scalars)
  {
    throw Error(Failure::MissingArray, "The picture has no scalars: read it from a file, or name them.");
  }
  const int type = scalars->GetDataType(), components = scalars->GetNumberOfComponents();
  if ((type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT) || components > 4)
  {
    throw Error(Failure::BadStroke,
      "The picture's scalars are of type %1 and have %2 components; give 1 to 4 unsigned numbers of 8 or 16 "
      "bits.",
      scalars->GetDataTypeAsString(),
      components);
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(scalars->GetNumberOfValues()));
  if (type == VTK_UNSIGNED_CHAR)
  {
    std::copy_n(static_cast<const std::uint8_t*>(scalars->GetVoidPointer(0)), bytes.size(), bytes.begin());
    return bytes;
  }
  const auto* values = static_cast<const std::uint16_t*>(scalars->GetVoidPointer(0));
  std::transform(values,
    values + bytes.size(),
    bytes.begin(),
    [](std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); });
  return bytes;
}

// The view that looks straight down and shows exactly the picture: display px are its own.
View viewOfAll(const PicturePlace& place)
{
  const Canvas& shown = place.Rectangle;
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity(), projection = Eigen::Matrix4d::Identity();
  view.block<2, 1>(0, 3) = -(shown.corner + 0.5 * shown.size);
  view(2, 3) = -1.0;
  projection.diagonal() << 2.0 / shown.size[0], 2.0 / shown.size[1], -1.0, 1.0;
  return View(view, projection, place.Columns, place.Rows);
}

void writeStrokesOf(const std::vector<TracedRim>& rims,
  int holes,
  const PicturePlace& place,
  vtkPolyData* output)
{
  const Vector2 half(0.5, 0.5); // from a pixel's corner to its middle
  Polylines lines;
  std::vector<int> treatments;
  for (const TracedRim& rim : rims)
  {
    if (rim.isHole && holes == vtkOversketchTrace::Fill)
    {
      continue;
    }
    Polyline shown;
    std::transform(rim.points.begin(),
      rim.points.end(),
      std::back_inserter(shown),
      [&](const Vector2& pixel) -> Vector2 { return pixel + half; });
    lines.Add(shown, true);
    treatments.push_back(rim.isHole ? holes : 0);
  }
  lines.Put(output);
  const std::size_t count = treatments.size();
  const auto samples = static_cast<std::size_t>(output->GetNumberOfPoints());
  WriteView(viewOfAll(place), output);
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Magnetic", std::vector<int>(count, 0)));
  output->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("SnapRadius", std::vector<double>(count, 10.0)));
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Treatment", treatments));
  output->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Pressure", std::vector<float>(samples, 1.0F)));
  output->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("Time", std::vector<double>(samples, 0.0)));
}

} // namespace

vtkOversketchTrace::vtkOversketchTrace()
{
  DeclareInput(this, 0, { Port::Image });
}

int vtkOversketchTrace::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkImageData* picture = vtkImageData::GetData(inputs[0]);
      if (picture->GetNumberOfPoints() == 0)
      {
        return;
      }
      const PicturePlace place = PlaceOf(picture);
      RequireFinite(this->Place[0], "Place");
      RequireFinite(this->Place[1], "Place");
      std::optional<Vector2> at;
      if (this->Place[0] >= 0.0 && this->Place[1] >= 0.0)
      {
        if (this->Place[0] > place.Columns || this->Place[1] > place.Rows)
        {
          throw Error(Failure::BadStroke,
            "The place (%1, %2) is beyond the picture, which has %3 x %4 px; give one in it, counted from "
            "its lower left corner.",
            this->Place[0],
            this->Place[1],
            place.Columns,
            place.Rows);
        }
        at = Vector2(this->Place[0] - 0.5, this->Place[1] - 0.5);
      }
      vtkNew<vtkPolyData> none; // of which arrays are read
      const StepKey key({ MeshKey(none, { picture->GetPointData()->GetScalars() }) },
        { place.Origin[0],
          place.Origin[1],
          place.Spacing[0],
          place.Spacing[1],
          static_cast<double>(place.Columns),
          static_cast<double>(place.Rows),
          this->Place[0],
          this->Place[1],
          static_cast<double>(this->Holes) });
      this->Kept<KeptOutput>().Provide(key,
        vtkPolyData::GetData(outputs),
        [&](vtkPolyData* result)
        {
          ++this->TraceCount;
          const std::vector<std::uint8_t> bytes = bytesOf(picture);
          const int components = picture->GetPointData()->GetScalars()->GetNumberOfComponents();
          const PictureSamples samples{ bytes.data(), place.Columns, place.Rows, components };
          const Context context = ContextOf(this);
          context.checkpoint(0.0);
          writeStrokesOf(traced(samples, at, context), this->Holes, place, result);
        });
    });
}

void vtkOversketchTrace::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Place: " << this->Place[0] << " " << this->Place[1] << "\n";
  os << indent << "Holes: " << this->Holes << "\n";
  os << indent << "TraceCount: " << this->TraceCount << "\n";
}
