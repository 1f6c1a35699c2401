#include "vtkOversketchStellarSource.h"

#include "vtkOversketchFilterTools.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace oversketch
{

namespace
{

const char* const grayName = "TerrainGray";
const char* const rulesName = "TerrainRules";
constexpr int ruleCount = 10;

} // namespace

HeightImage HeightsOf(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw Error(Failure::MissingArray, "The height image has no scalars; give it gray values, one a point.");
  }
  if (size[2] != 1)
  {
    throw Error(Failure::BadMesh,
      "The height image has " + std::to_string(size[2]) + " slices; one is needed, across z.");
  }
  HeightImage result;
  result.width = size[0];
  result.height = size[1];
  result.spacing = Vector2(image->GetSpacing()[0], image->GetSpacing()[1]);
  result.samples.resize(static_cast<std::size_t>(image->GetNumberOfPoints()));
  const bool colour = scalars->GetNumberOfComponents() >= 3;
  for (std::size_t i = 0; i < result.samples.size(); ++i)
  {
    const auto at = [&](int component)
    { return scalars->GetComponent(static_cast<vtkIdType>(i), component); };
    result.samples[i] = colour ? 0.299 * at(0) + 0.587 * at(1) + 0.114 * at(2) : at(0);
  }
  return result;
}

void WriteTerrain(const HeightImage& image, const TerrainRules& rules, vtkPolyData* source)
{
  auto gray = vtkSmartPointer<vtkDoubleArray>::New();
  gray->SetName(grayName);
  gray->SetNumberOfValues(static_cast<vtkIdType>(image.samples.size()));
  std::copy(image.samples.begin(), image.samples.end(), gray->GetPointer(0));
  auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  numbers->SetName(rulesName);
  for (const double value : { static_cast<double>(image.width),
         static_cast<double>(image.height),
         image.spacing[0],
         image.spacing[1],
         static_cast<double>(rules.columns),
         static_cast<double>(rules.rows),
         rules.quad[0],
         rules.quad[1],
         rules.scale,
         rules.offset })
  {
    numbers->InsertNextValue(value);
  }
  source->SetPoints(vtkSmartPointer<vtkPoints>::New()); // readers of files complain where there are none
  source->GetFieldData()->AddArray(gray);
  source->GetFieldData()->AddArray(numbers);
}

Source TerrainSource(vtkPolyData* source)
{
  vtkDataArray* gray = source->GetFieldData()->GetArray(grayName);
  vtkDataArray* numbers = source->GetFieldData()->GetArray(rulesName);
  if (!gray && !numbers)
  {
    return nullptr;
  }
  if (!gray || !numbers || numbers->GetNumberOfValues() != ruleCount || gray->GetNumberOfComponents() != 1)
  {
    throw Error(Failure::MissingArray,
      "The source lacks field array TerrainGray or TerrainRules, or one has another shape; pass output 1 of "
      "vtkOversketchTerrain as it is.");
  }
  double v[ruleCount];
  for (int i = 0; i < ruleCount; ++i)
  {
    v[i] = numbers->GetComponent(i / numbers->GetNumberOfComponents(), i % numbers->GetNumberOfComponents());
  }
  for (const int i : { 0, 1, 4, 5 })
  {
    if (!(v[i] >= 1.0 && v[i] <= 1e9 && v[i] == std::floor(v[i])))
    {
      throw Error(Failure::BadMesh,
        "Field array TerrainRules of the source has no count at " + std::to_string(i) +
          "; pass output 1 of vtkOversketchTerrain as it is.");
    }
  }
  HeightImage image;
  image.width = static_cast<int>(v[0]);
  image.height = static_cast<int>(v[1]);
  image.spacing = Vector2(v[2], v[3]);
  image.samples.resize(static_cast<std::size_t>(gray->GetNumberOfTuples()));
  for (std::size_t i = 0; i < image.samples.size(); ++i)
  {
    image.samples[i] = gray->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  TerrainRules rules;
  rules.columns = static_cast<int>(v[4]);
  rules.rows = static_cast<int>(v[5]);
  rules.quad = Vector2(v[6], v[7]);
  rules.scale = v[8];
  rules.offset = v[9];
  const auto terrain = std::make_shared<const Terrain>(std::move(image), rules);
  return [terrain](const SourcePlace& place)
  {
    const double z = terrain->heightAt(place.position[0], place.position[1]);
    return std::isfinite(z) ? Vector3(place.position[0], place.position[1], z) : place.position;
  };
}

} // namespace oversketch
