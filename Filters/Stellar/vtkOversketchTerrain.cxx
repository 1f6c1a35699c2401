#include "vtkOversketchTerrain.h"

#include "Image/heights.h"
#include "Stellar/pairing.h"
#include "vtkOversketchStellarSource.h"
#include "vtkOversketchStellarTools.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchTerrain::Cache
{
  StellarStep Step;
  vtkSmartPointer<vtkPolyData> Source;
  Message Warning;
};

namespace
{

// Says what became of missing samples; empty where none was.
Message judged(const FilledSamples& samples, const Terrain& terrain, std::size_t quads)
{
  std::vector<Message> said;
  if (samples.filled > 0)
  {
    said.emplace_back("%1 missing samples were filled, each from those beside it.", samples.filled);
  }
  if (samples.left > 0)
  {
    const std::size_t all = static_cast<std::size_t>(terrain.columns()) * terrain.rows();
    said.emplace_back(
      "%1 missing samples, three and more side by side in both directions, are holes; %2 of %3 "
      "quads there are left out.",
      samples.left,
      all - quads,
      all);
  }
  return Message::joined(said);
}

} // namespace

vtkStandardNewMacro(vtkOversketchTerrain);

vtkOversketchTerrain::vtkOversketchTerrain()
{
  this->SetNumberOfOutputPorts(2);
  DeclareInput(this, 0, { Port::Image });
}

int vtkOversketchTerrain::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return this->RunSystem(
    [&]
    {
      vtkImageData* image = vtkImageData::GetData(inputs[0]);
      if (image->GetNumberOfPoints() == 0)
      {
        return;
      }
      Cache& cache = this->Kept<Cache>();
      vtkDataArray* scalars = image->GetPointData()->GetScalars();
      const Context context = ContextOf(this);
      vtkNew<vtkPolyData> none; // of which arrays go to the terrain
      const StepKey key({ MeshKey(none, { scalars }) },
        { static_cast<double>(image->GetDimensions()[0]),
          static_cast<double>(image->GetDimensions()[1]),
          static_cast<double>(image->GetDimensions()[2]),
          image->GetSpacing()[0],
          image->GetSpacing()[1],
          image->GetOrigin()[0],
          image->GetOrigin()[1],
          static_cast<double>(this->Columns),
          static_cast<double>(this->Rows),
          this->QuadX,
          this->QuadY,
          this->Scale,
          this->Offset });
      cache.Step.Provide(key,
        none,
        vtkPolyData::GetData(outputs, 0),
        [&]
        {
          ++this->TerrainCount;
          HeightImage heights = HeightsOf(image);
          const FilledSamples samples = fillNarrowGaps(heights, context);
          TerrainRules rules;
          rules.columns = this->Columns;
          rules.rows = this->Rows;
          rules.quad = Vector2(this->QuadX, this->QuadY);
          rules.scale = this->Scale;
          rules.offset = this->Offset;
          const Terrain terrain(heights, rules);
          StellarStep::Made made;
          const Mesh base = terrain.baseMesh(context);
          cache.Warning = judged(samples, terrain, base.triangles.size() / 2);
          made.forest = std::make_shared<const Forest>(forestOfPairs(base));
          rules.columns = terrain.columns();
          rules.rows = terrain.rows();
          cache.Source = vtkSmartPointer<vtkPolyData>::New();
          WriteTerrain(heights, rules, cache.Source);
          const double* const origin = image->GetOrigin();
          if (origin[0] != 0.0 || origin[1] != 0.0)
          {
            const auto place = NewArray<vtkDoubleArray>("MapOrigin", 3);
            place->InsertNextTuple3(origin[0], origin[1], 0.0);
            cache.Source->GetFieldData()->AddArray(place);
          }
          return made;
        });
      if (!cache.Warning.empty())
      {
        Warn(this, cache.Warning);
      }
      vtkPolyData::GetData(outputs, 1)->ShallowCopy(cache.Source);
      vtkFieldData* fields = vtkPolyData::GetData(outputs, 0)->GetFieldData();
      for (int i = 0; i < cache.Source->GetFieldData()->GetNumberOfArrays(); ++i)
      {
        fields->AddArray(cache.Source->GetFieldData()->GetAbstractArray(i));
      }
    });
}

void vtkOversketchTerrain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Columns: " << this->Columns << "\n";
  os << indent << "Rows: " << this->Rows << "\n";
  os << indent << "QuadX: " << this->QuadX << "\n";
  os << indent << "QuadY: " << this->QuadY << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "TerrainCount: " << this->TerrainCount << "\n";
}
