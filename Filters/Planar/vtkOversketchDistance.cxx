#include "vtkOversketchDistance.h"

#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchFilterTools.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

using namespace oversketch;

// The last maps and all that they were made of.
struct vtkOversketchDistance::Cache
{
  std::vector<Rim> Rims;
  Frame Raster;
  int Mode = LOCAL;
  vtkSmartPointer<vtkImageData> Image;

  bool Answers(const std::vector<Rim>& rims, const Frame& raster, int mode) const
  {
    return this->Image && mode == this->Mode && raster.origin == this->Raster.origin &&
           raster.spacing == this->Raster.spacing && raster.width == this->Raster.width &&
           raster.height == this->Raster.height &&
           std::equal(rims.begin(),
             rims.end(),
             this->Rims.begin(),
             this->Rims.end(),
             [](const Rim& a, const Rim& b) { return a.object == b.object && a.points == b.points; });
  }
};

vtkStandardNewMacro(vtkOversketchDistance);

vtkOversketchDistance::vtkOversketchDistance()
{
  this->SetNumberOfOutputPorts(2);
  DeclareOutput(this, 1, { Port::Image });
}

vtkImageData* vtkOversketchDistance::GetDistanceOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkOversketchDistance::RequestInformation(vtkInformation*,
  vtkInformationVector**,
  vtkInformationVector* outputs)
{
  return DescribeImage(this, outputs->GetInformationObject(1), VTK_FLOAT, RasterOf);
}

void vtkOversketchDistance::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkImageData* image = vtkImageData::GetData(outputs, 1);
  const Drawing drawing = DrawingOf(curves);
  std::vector<Rim> rims = rimsOf(ClassificationOf(curves), drawing.Strokes, drawing.Treatments);
  Cache& cache = this->Kept<Cache>();
  if (!cache.Answers(rims, drawing.Raster, this->LocalMaxMode))
  {
    ++this->DistanceCount;
    cache.Image = nullptr; // so that nothing stale is left when making fails
    const ThicknessMode mode = this->LocalMaxMode == LOCAL ? ThicknessMode::Local : ThicknessMode::Global;
    const auto made = vtkSmartPointer<vtkImageData>::New();
    WriteDistanceMaps(distanceMaps(drawing.Raster, rims, mode, ContextOf(this)), made);
    cache.Image = made;
    cache.Rims = std::move(rims);
    cache.Raster = drawing.Raster;
    cache.Mode = this->LocalMaxMode;
  }
  vtkPolyData::GetData(outputs, 0)->ShallowCopy(curves);
  image->ShallowCopy(cache.Image);
}

void vtkOversketchDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LocalMaxMode: " << this->LocalMaxMode << "\n";
  os << indent << "DistanceCount: " << this->DistanceCount << "\n";
}
