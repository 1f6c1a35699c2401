#include "vtkOversketchShadingLevels.h"

#include "vtkOversketchFilterTools.h"

#include "Shading/layer_list.h"
#include "Shading/texels.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchShadingTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <map>

using namespace oversketch;

namespace
{

// The disc's texels and vertices, and where on the way from curve to boundary they are.
ShadedPlaces placesOf(vtkPolyData* mesh, vtkPolyData* disc, int size, const Context& context)
{
  const auto refuse = [](const Message& what)
  {
    throw Error(
      Failure::BadMesh, "%1; take mesh and disc from the same vtkOversketchFlatten, not a later one.", what);
  };
  const std::vector<char> labels = ReadEditRegion(mesh);
  vtkDataArray* distance = RequireArray(mesh->GetPointData(),
    "CurveDistance",
    1,
    mesh->GetNumberOfPoints(),
    "mesh",
    "take it from vtkOversketchDistanceField");
  vtkDataArray* ids = RequireArray(disc->GetPointData(),
    "VertexId",
    1,
    disc->GetNumberOfPoints(),
    "disc",
    "take it from vtkOversketchFlatten");
  const auto shape = SharedMesh(disc);
  std::vector<Vector2> flat;
  std::vector<double> shares;
  std::vector<char> inside;
  for (int i = 0; i < shape->Surface().vertexCount(); ++i)
  {
    const double id = ids->GetComponent(i, 0);
    if (!(id >= 0.0 && id < static_cast<double>(labels.size())))
    {
      refuse({ "Point %1 of the disc names no vertex of the mesh", i });
    }
    const auto vertex = static_cast<std::size_t>(id);
    flat.emplace_back(shape->Surface().points[i].head<2>());
    shares.push_back(distance->GetComponent(static_cast<vtkIdType>(vertex), 0));
    inside.push_back(labels[vertex] == EditLabel::Inside);
    if (!(shares.back() >= 0.0 && shares.back() <= 1.0))
    {
      refuse({ "CurveDistance of vertex %1 is not within 0 and 1", vertex });
    }
  }
  return shadedPlaces(flat, shape->Surface().triangles, shares, inside, size, context);
}

AreaShares sharesOf(vtkImageData* image,
  int area,
  double feather,
  const ShadedPlaces& places,
  const Context& context)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  std::vector<char> selected(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (std::size_t i = 0; i < selected.size(); ++i)
  {
    selected[i] = scalars->GetComponent(static_cast<vtkIdType>(i), area) != 0.0;
  }
  return areaShares(AreaMask(selected, image->GetDimensions()[0], feather, context), places, context);
}

vtkSmartPointer<vtkImageData> imageOf(vtkDataArray* texels, int size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  LayOnDisc(image, size);
  image->GetPointData()->SetScalars(texels);
  return image;
}

// How many areas an image has; 0 without one.
int areasIn(vtkImageData* image)
{
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return 0;
  }
  const auto [columns, rows] = SidesOf(image, "area");
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || columns != rows || columns > 4096)
  {
    throw Error(Failure::BadStroke,
      "The image of areas has no scalars, is not square or larger than 4096; take it from "
      "vtkOversketchScanFill.");
  }
  return scalars->GetNumberOfComponents();
}

} // namespace

// Work that does not depend on the layers, and the last result.
struct vtkOversketchShadingLevels::Cache
{
  StepKey PlacesKey, AreasKey, Key;
  bool HasPlaces = false;
  ShadedPlaces Places;
  std::vector<int> Vertices;       // of the mesh, for those of the places
  std::map<int, AreaShares> Areas; // those that have been asked for
  vtkSmartPointer<vtkDoubleArray> Weights;
  vtkSmartPointer<vtkImageData> Image, Display;
};

vtkStandardNewMacro(vtkOversketchShadingLevels);

vtkOversketchShadingLevels::vtkOversketchShadingLevels()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
  DeclareInput(this, 2, { Port::Image, Port::Optional });
  DeclareOutput(this, 1, { Port::Image });
  DeclareOutput(this, 2, { Port::Image });
}

void vtkOversketchShadingLevels::SetLayers(const char* text)
{
  SetText(this, this->Layers, text);
}

vtkImageData* vtkOversketchShadingLevels::GetWeightsOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkImageData* vtkOversketchShadingLevels::GetDisplayOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkOversketchShadingLevels::RequestInformation(vtkInformation*,
  vtkInformationVector**,
  vtkInformationVector* outputs)
{
  DescribeDiscImage(outputs->GetInformationObject(1), this->Resolution, VTK_FLOAT);
  DescribeDiscImage(outputs->GetInformationObject(2), this->Resolution, VTK_UNSIGNED_CHAR);
  return 1;
}

int vtkOversketchShadingLevels::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  RequestWholeImage(inputs[2]);
  return done;
}

void vtkOversketchShadingLevels::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* disc = vtkPolyData::GetData(inputs[1]);
  vtkImageData* areas = vtkImageData::GetData(inputs[2]);
  vtkImageData* image = vtkImageData::GetData(outputs, 1);
  vtkImageData* display = vtkImageData::GetData(outputs, 2);
  this->Shade(mesh, disc, areas);
  const Cache& cache = this->Kept<Cache>();
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  output->ShallowCopy(mesh);
  output->GetPointData()->AddArray(cache.Weights);
  image->ShallowCopy(cache.Image);
  display->ShallowCopy(cache.Display);
}

void vtkOversketchShadingLevels::Shade(vtkPolyData* mesh, vtkPolyData* disc, vtkImageData* areas)
{
  if (!(this->Feather >= 0.0 && this->Feather <= 1.0))
  {
    throw Error(Failure::BadStroke, "{Feather} is not within 0 and 1; set another.");
  }
  const double feather = this->AsPublished ? 0.0 : this->Feather;
  const bool linear = this->AsPublished || this->Falloff == LINEAR;
  const int count = areasIn(areas);
  vtkPointData* data = mesh->GetPointData();
  const std::vector<MeshKey> placeKeys{ ArraysKey(
                                          { data->GetArray("EditRegion"), data->GetArray("CurveDistance") }),
    MeshKey(disc, { disc->GetPointData()->GetArray("VertexId") }) };
  std::vector<MeshKey> areaKeys = placeKeys;
  areaKeys.push_back(ArraysKey({ count > 0 ? areas->GetPointData()->GetScalars() : nullptr }));
  const double size = this->Resolution, areaSize = count > 0 ? areas->GetDimensions()[0] : 0;
  const StepKey placesKey(placeKeys, { size }), areasKey(areaKeys, { size, areaSize, feather });
  std::vector<double> values{ size, areaSize, feather, static_cast<double>(linear), double(this->Levels) };
  AddText(values, this->Layers);
  const StepKey key(areaKeys, values);
  Cache& cache = this->Kept<Cache>();
  if (cache.Weights && cache.Key == key)
  {
    return;
  }
  cache.Weights = nullptr; // so that nothing stale is left when making fails
  ++this->ShadeCount;
  const Context context = ContextOf(this);
  context.checkpoint(0.0);
  if (!cache.HasPlaces || cache.PlacesKey != placesKey)
  {
    cache.HasPlaces = false;
    ++this->TexelCount;
    cache.Places = placesOf(mesh, disc, this->Resolution, context);
    vtkDataArray* ids = disc->GetPointData()->GetArray("VertexId");
    cache.Vertices.clear();
    for (const int v : cache.Places.vertices)
    {
      cache.Vertices.push_back(static_cast<int>(ids->GetComponent(v, 0)));
    }
    cache.PlacesKey = placesKey;
    cache.HasPlaces = true;
  }
  if (cache.AreasKey != areasKey)
  {
    cache.Areas.clear();
    cache.AreasKey = areasKey;
  }
  const LayerList list = layerList(this->Layers);
  const oversketch::Layers whole(this->Levels, list.handles);
  std::map<int, ShadedArea> own; // by the areas' numbers, of which the last one wins
  for (const AreaLayers& each : list.areas)
  {
    if (each.area < 0 || each.area >= count)
    {
      throw Error(
        Failure::BadStroke, "{Layers} names area %1, but there are %2, numbered from 0.", each.area, count);
    }
    if (cache.Areas.count(each.area) == 0)
    {
      cache.Areas[each.area] = sharesOf(areas, each.area, feather, cache.Places, context);
    }
    own.insert({ each.area,
      { oversketch::Layers(
          each.levels > 0 ? each.levels : this->Levels, each.handles.empty() ? list.handles : each.handles),
        &cache.Areas[each.area] } });
  }
  std::vector<ShadedArea> shaded;
  shaded.reserve(own.size());
  for (const auto& [number, area] : own)
  {
    shaded.push_back(area);
  }
  this->Paint(mesh->GetNumberOfPoints(), whole, shaded);
  cache.Key = key;
}

void vtkOversketchShadingLevels::Paint(vtkIdType points,
  const oversketch::Layers& whole,
  const std::vector<ShadedArea>& areas)
{
  const auto falloff =
    this->AsPublished || this->Falloff == LINEAR ? oversketch::Falloff::Linear : oversketch::Falloff::Smooth;
  const auto weights = NewArray<vtkDoubleArray>("EditWeight", 1, points);
  weights->FillValue(0.0);
  const auto texels =
    NewArray<vtkFloatArray>("Weight", 1, static_cast<vtkIdType>(this->Resolution) * this->Resolution);
  const auto greys = NewArray<vtkUnsignedCharArray>("Grey");
  texels->FillValue(0.0f);
  greys->SetNumberOfValues(texels->GetNumberOfValues());
  greys->FillValue(0);
  Cache& cache = this->Kept<Cache>();
  const Context context = ContextOf(this);
  const Shading shading(whole, areas, falloff);
  const std::vector<double> values = shading.weights(cache.Places, context);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    weights->SetValue(cache.Vertices[i], values[i]);
  }
  shading.paint(cache.Places, texels->GetPointer(0), greys->GetPointer(0), context);
  cache.Image = imageOf(texels, this->Resolution);
  cache.Display = imageOf(greys, this->Resolution);
  cache.Weights = weights;
}

void vtkOversketchShadingLevels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Falloff: " << this->Falloff << "\n";
  os << indent << "Feather: " << this->Feather << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "TexelCount: " << this->TexelCount << "\n";
  os << indent << "ShadeCount: " << this->ShadeCount << "\n";
}
