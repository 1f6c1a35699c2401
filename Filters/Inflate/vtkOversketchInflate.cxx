#include "vtkOversketchInflate.h"

#include "vtkOversketchFilterTools.h"

#include "Inflate/heights.h"
#include "Inflate/solid.h"
#include "Inflate/swap_edges.h"
#include "Inflate/unstretch.h"
#include "Raster/grid_smoothing.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchSolidTools.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

using namespace oversketch;

// Maps that heights are read from, each made anew when what is before it is.
// Pixels along a cell of the grid on which smoothing and Poisson's equation are solved.
constexpr int gridStep = 2;

struct vtkOversketchInflate::Cache
{
  StepKey MapsKey, ThicknessKey, RatioKey;
  DistanceMaps Maps;
  std::unique_ptr<GridSmoothing> Grid; // refers to the maps
  std::vector<float> Smooth, Thickness, Ratio;
  vtkSmartPointer<vtkImageData> Image;
  KeptOutput Surface;

  // Makes what the key does not answer; true where it did.
  template <typename Make>
  static bool Provide(StepKey& known, const StepKey& key, const Make& make)
  {
    if (known == key)
    {
      return false;
    }
    known = StepKey();
    make();
    known = key;
    return true;
  }
};

vtkStandardNewMacro(vtkOversketchInflate);

namespace
{

// Squares over T [px], 1 where T is 0.
std::vector<float> OverDistance(const DistanceMaps& maps, std::vector<float> squares)
{
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    squares[i] = maps.distance[i] > 0.0f ? squares[i] / maps.distance[i] : 1.0f;
  }
  return squares;
}

vtkSmartPointer<vtkImageData> imageOf(const Frame& frame,
  const std::vector<float>& thickness,
  const std::vector<float>& ratio)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  WriteFrame(frame, image);
  image->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("LocalMaxSmooth", thickness));
  image->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Ratio", ratio));
  image->GetPointData()->SetActiveScalars("LocalMaxSmooth");
  return image;
}

} // namespace

vtkOversketchInflate::vtkOversketchInflate()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  DeclareInput(this, 1, { Port::Image });
  DeclareOutput(this, 1, { Port::Image });
}

vtkImageData* vtkOversketchInflate::GetHeightsOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkOversketchInflate::SetProfile(const char* text)
{
  SetText(this, this->Profile, text);
}

int vtkOversketchInflate::RequestInformation(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkInformation* distance = inputs[1]->GetInformationObject(0);
  vtkInformation* heights = outputs->GetInformationObject(1);
  heights->CopyEntry(distance, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  heights->CopyEntry(distance, vtkDataObject::ORIGIN());
  heights->CopyEntry(distance, vtkDataObject::SPACING());
  vtkDataObject::SetPointDataActiveScalarInfo(heights, VTK_FLOAT, 1);
  return 1;
}

void vtkOversketchInflate::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkImageData* image = vtkImageData::GetData(inputs[1]);
  vtkImageData* heights = vtkImageData::GetData(outputs, 1);
  RequireFinite(this->HeightFactor, "HeightFactor");
  RequireFinite(this->LocalMaxSmoothing, "LocalMaxSmoothing");
  RequireFinite(this->ProfileSmoothing, "ProfileSmoothing");
  const CrossSection section = CrossSection::parse(this->Profile);
  const PlanarMesh planar = PlanarMeshOf(mesh);
  const bool poisson = this->Mode == Poisson;
  const double spread = this->AsPublished ? 0.0 : std::max(0.0, this->LocalMaxSmoothing);
  const double round = this->AsPublished            ? 0.0
                       : this->ProfileSmoothing < 0 ? section.smoothing()
                                                    : this->ProfileSmoothing;
  const bool bySection = !poisson && !(round > 0.0);
  const bool unstretched = this->UnstretchedRims && !this->AsPublished && (!bySection || section.isUpright());
  Cache& cache = this->Kept<Cache>();

  const Frame frame = FrameOf(image);
  std::vector<double> values{ frame.origin[0], frame.origin[1], frame.spacing, 1.0 * frame.width };
  const auto key = [&] { return StepKey({ ImageKey(image) }, values); };
  Cache::Provide(cache.MapsKey,
    key(),
    [&]
    {
      cache.ThicknessKey = cache.RatioKey = StepKey();
      cache.Image = nullptr;
      cache.Grid = nullptr;
      cache.Maps = UphillMapsOf(image, ContextOf(this, 0.0, 0.05));
      cache.Grid = std::make_unique<GridSmoothing>(cache.Maps, gridStep, ContextOf(this, 0.05, 0.2));
    });
  // A smoothed circle's heights do not ask for the thickness.
  if (!poisson && !(round > 0.0 && section.isCircle()))
  {
    values.push_back(spread);
    this->ThicknessCount += Cache::Provide(cache.ThicknessKey,
      key(),
      [&]
      {
        cache.RatioKey = StepKey();
        cache.Smooth = cache.Grid->thickness(spread, ContextOf(this, 0.2, 0.5));
      });
  }
  values.push_back(this->Mode);
  if (!poisson)
  {
    values.push_back(round);
    AddText(values, this->Profile);
  }
  this->RatioCount += Cache::Provide(cache.RatioKey,
    key(),
    [&]
    {
      cache.Image = nullptr;
      const Context context = ContextOf(this, 0.5, 0.9);
      const auto squares = [&]
      {
        return round > 0.0 && section.isCircle() ? roundSquares(cache.Maps, context)
                                                 : sectionSquares(cache.Maps, cache.Smooth, section, context);
      };
      cache.Ratio = poisson       ? cache.Grid->poissonRatio(context)
                    : round > 0.0 ? cache.Grid->profileRatio(squares(), round, context)
                                  : OverDistance(cache.Maps, squares());
      cache.Thickness = bySection ? cache.Smooth : roundThickness(cache.Maps, cache.Ratio);
      cache.Image = imageOf(frame, cache.Thickness, cache.Ratio);
    });
  values.push_back(this->HeightFactor);
  values.push_back(unstretched);
  cache.Surface.Provide(StepKey({ WholeKey(mesh), ImageKey(image) }, values),
    vtkPolyData::GetData(outputs, 0),
    [&](vtkPolyData* result)
    {
      ++this->InflateCount;
      const HeightMaps maps{
        cache.Maps, cache.Thickness, cache.Ratio, bySection ? Inflation::Section : Inflation::Ratio
      };
      const Context context = ContextOf(this, 0.9, 1.0);
      PlanarMesh moved = unstretched ? unstretch(planar, maps, context) : planar;
      const std::vector<double> points = heightsOf(moved, maps, section, this->HeightFactor, context);
      if (unstretched)
      {
        swapEdges(moved, points, maps, section, this->HeightFactor, context);
      }
      WriteSolid(inflate(moved, points), mesh, result);
    });
  heights->ShallowCopy(cache.Image);
}

void vtkOversketchInflate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Profile: " << this->Profile << "\n";
  os << indent << "HeightFactor: " << this->HeightFactor << "\n";
  os << indent << "LocalMaxSmoothing: " << this->LocalMaxSmoothing << "\n";
  os << indent << "ProfileSmoothing: " << this->ProfileSmoothing << "\n";
  os << indent << "UnstretchedRims: " << this->UnstretchedRims << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "ThicknessCount: " << this->ThicknessCount << "\n";
  os << indent << "RatioCount: " << this->RatioCount << "\n";
  os << indent << "InflateCount: " << this->InflateCount << "\n";
}
