#include "vtkOversketchCrossSection.h"

#include "Section/profile.h"
#include "Section/walk.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <numeric>

using namespace oversketch;

struct vtkOversketchCrossSection::Cache
{
  std::shared_ptr<const MeshData> Data; // keeps the shared mesh alive between runs
  KeptValue<Sectioner> Cutter;          // of it and the boundary, which stay as the plane slides
  ProfileFit Fit;
  KeptOutput Kept;

  const Sectioner& CutterOf(vtkPolyData* mesh, vtkPolyData* boundary)
  {
    const StepKey key({ MeshKey(mesh, { mesh->GetPointData()->GetNormals() }), WholeKey(boundary) }, {});
    return this->Cutter.Provide(key,
      [&]
      {
        this->Data = SharedMesh(mesh); // which the cutter points into
        const Mesh& surface = this->Data->Surface();
        return Sectioner(surface,
          this->Data->Neighbours(),
          VerticesOnce(ReadChain(boundary, surface.vertexCount(), "boundary curve")));
      });
  }
};

vtkStandardNewMacro(vtkOversketchCrossSection);

namespace
{

const char* const planesRemedy = "make it with vtkOversketchProfilePlanes";

// Where the planes' place hangs on the mesh.
Binding PlaceOf(vtkPolyData* planes, int vertexCount)
{
  vtkDataArray* vertices = planes->GetFieldData()->GetArray("MeshVertices");
  vtkDataArray* weights = planes->GetFieldData()->GetArray("MeshWeights");
  for (vtkDataArray* array : { vertices, weights })
  {
    if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != 1)
    {
      throw Error(Failure::MissingArray,
        "The planes have no field arrays MeshVertices and MeshWeights: %1.",
        planesRemedy);
    }
  }
  Binding place;
  for (int k = 0; k < 3; ++k)
  {
    const double v = vertices->GetComponent(0, k);
    if (!(v >= 0.0 && v < vertexCount))
    {
      throw Error(Failure::BadStroke,
        "The planes' place hangs on a vertex that the mesh does not have: %1 of this mesh.",
        planesRemedy);
    }
    place.vertices[k] = static_cast<int>(v);
    place.weights[k] = weights->GetComponent(0, k);
  }
  return place;
}

// CurveSide times CurveDistance at each place.
std::vector<double> SidesOf(vtkPolyData* mesh, const std::vector<Binding>& places)
{
  const auto counts = [](const Binding& place, int k) { return k == 0 || place.weights[k] != 0.0; };
  std::vector<int> vertices; // but those of weight 0, which repeat the first
  vertices.reserve(2 * places.size());
  for (const Binding& place : places)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (counts(place, k))
      {
        vertices.push_back(place.vertices[k]);
      }
    }
  }
  const std::vector<double> distances = ReadValues(mesh, "CurveDistance", vertices),
                            sides = ReadValues(mesh, "CurveSide", vertices, -1.0);
  std::vector<double> beside;
  beside.reserve(places.size());
  std::size_t i = 0;
  for (const Binding& place : places)
  {
    double value = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      if (counts(place, k))
      {
        value += place.weights[k] * distances[i] * sides[i];
        ++i;
      }
    }
    beside.push_back(value);
  }
  return beside;
}

void WriteLine(const std::vector<Vector3>& line,
  const std::vector<double>& t,
  const std::vector<double>& beside,
  vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(line.size());
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  double* place = places->GetPointer(0);
  for (const Vector3& point : line)
  {
    place = std::copy_n(point.data(), 3, place);
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  vtkNew<vtkIdTypeArray> ends, ids;
  ends->SetNumberOfValues(2);
  ends->SetValue(0, 0);
  ends->SetValue(1, count);
  ids->SetNumberOfValues(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, 0);
  vtkNew<vtkCellArray> lines;
  lines->SetData(ends, ids);
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("CurveT", t));
  output->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("SideDistance", beside));
}

void WriteSection(const Section& section, const std::vector<double>& beside, vtkPolyData* output)
{
  std::vector<double> t{ 0.0 };
  t.reserve(section.points.size());
  for (std::size_t i = 1; i < section.points.size(); ++i)
  {
    t.push_back(t.back() + (section.points[i] - section.points[i - 1]).norm());
  }
  for (double& share : t)
  {
    share /= t.back() > 0.0 ? t.back() : 1.0;
  }
  WriteLine(section.points, t, beside, output);
  WriteBindings(section.places, output);
}

void WriteProfile(const FlatProfile& profile, vtkPolyData* planes, vtkPolyData* output)
{
  std::vector<Vector3> line;
  line.reserve(profile.points.size());
  for (const Vector2& point : profile.points)
  {
    line.emplace_back(point[0], point[1], 0.0);
  }
  WriteLine(line, profile.t, profile.beside, output);
  WriteMatrix(output->GetFieldData(), "ProfileMatrix", profile.toWorld);
  for (const char* name : { "Frame", "PlaneT" })
  {
    output->GetFieldData()->AddArray(planes->GetFieldData()->GetArray(name));
  }
}

} // namespace

vtkOversketchCrossSection::vtkOversketchCrossSection()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

void vtkOversketchCrossSection::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* boundary = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* planes = vtkPolyData::GetData(inputs[2]);
  for (const double component : this->Right)
  {
    RequireFinite(component, "Right");
  }
  Cache& cache = this->Kept<Cache>();
  vtkPointData* data = mesh->GetPointData();
  const StepKey key(
    { MeshKey(mesh, { data->GetNormals(), data->GetArray("CurveDistance"), data->GetArray("CurveSide") }),
      WholeKey(boundary),
      WholeKey(planes) },
    { static_cast<double>(this->Ends),
      static_cast<double>(this->Walk),
      this->Right[0],
      this->Right[1],
      this->Right[2] });
  cache.Kept.Provide(key,
    { vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1) },
    [&](const KeptOutput::Outputs& results)
    {
      ++this->SectionCount;
      const Sectioner& cutter = cache.CutterOf(mesh, boundary);
      const Matrix4 frame = ReadMatrix(planes->GetFieldData(), "Frame", "planes input", planesRemedy);
      if (!planes->GetFieldData()->GetArray("PlaneT"))
      {
        throw Error(Failure::MissingArray, "The planes input has no field array PlaneT: %1.", planesRemedy);
      }
      SectionRules rules;
      rules.ends = this->Ends == Outermost ? SectionRules::Ends::Outermost : SectionRules::Ends::Nearest;
      rules.plane = this->Walk == Centre ? SectionRules::Plane::Centre : SectionRules::Plane::Across;
      rules.right = Vector3(this->Right);
      rules.halfSize = mesh->GetLength();
      mesh->GetCenter(rules.centre.data());
      const Section section =
        cutter.at(FrameOf(frame), PlaceOf(planes, cache.Data->Surface().vertexCount()), rules);
      if (section.points.empty())
      {
        if (this->Ends == Nearest)
        {
          Warn(this,
            "From {the reference curve} the plane goes round the model or a limb and back without "
            "meeting "
            "{the boundary curve}: there is no profile; slide it along {the reference curve}, or draw "
            "the "
            "boundary so that the limb's tip is not inside.");
        }
        else
        {
          Warn(this,
            "The plane meets {the boundary curve} fewer than twice: there is no profile; slide it "
            "along {the reference curve}.");
        }
        return;
      }
      const std::vector<double> beside = SidesOf(mesh, section.places);
      const FlatProfile profile =
        cache.Fit.flat(section.points, beside, section.normal, FrameOf(frame).outward);
      WriteProfile(profile, planes, results[0]);
      WriteSection(section, beside, results[1]);
    });
}

void vtkOversketchCrossSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Ends: " << this->Ends << '\n';
  os << indent << "Walk: " << this->Walk << '\n';
  os << indent << "Right: " << this->Right[0] << ' ' << this->Right[1] << ' ' << this->Right[2] << '\n';
  os << indent << "SectionCount: " << this->SectionCount << '\n';
}
