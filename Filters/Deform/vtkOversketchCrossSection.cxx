#include "vtkOversketchCrossSection.h"

#include "Section/profile.h"
#include "Section/walk.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchChains.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

struct vtkOversketchCrossSection::Cache
{
  std::shared_ptr<const MeshData> Data; // keeps the shared mesh alive between runs
  KeptOutput Profile;
  vtkNew<vtkPolyData> Section;
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
        std::string("The planes have no field arrays MeshVertices and MeshWeights: ") + planesRemedy + ".");
    }
  }
  Binding place;
  for (int k = 0; k < 3; ++k)
  {
    const double v = vertices->GetComponent(0, k);
    if (!(v >= 0.0 && v < vertexCount))
    {
      throw Error(Failure::BadStroke,
        std::string("The planes' place hangs on a vertex that the mesh does not have: ") + planesRemedy +
          " of this mesh.");
    }
    place.vertices[k] = static_cast<int>(v);
    place.weights[k] = weights->GetComponent(0, k);
  }
  return place;
}

// CurveSide times CurveDistance at each place.
std::vector<double> SidesOf(vtkPolyData* mesh, const std::vector<Binding>& places)
{
  std::vector<int> vertices;
  for (const Binding& place : places)
  {
    vertices.insert(vertices.end(), place.vertices.begin(), place.vertices.end());
  }
  const std::vector<double> distances = ReadValues(mesh, "CurveDistance", vertices, 0.0, 1.0),
                            sides = ReadValues(mesh, "CurveSide", vertices, -1.0, 1.0);
  std::vector<double> beside;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      value += places[i].weights[k] * distances[3 * i + k] * sides[3 * i + k];
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
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> shares, sides;
  shares->SetName("CurveT");
  sides->SetName("SideDistance");
  lines->InsertNextCell(static_cast<int>(line.size()));
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    lines->InsertCellPoint(points->InsertNextPoint(line[i].data()));
    shares->InsertNextValue(t[i]);
    sides->InsertNextValue(beside[i]);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(shares);
  output->GetPointData()->AddArray(sides);
}

void WriteSection(const Section& section, const std::vector<double>& beside, vtkPolyData* output)
{
  std::vector<double> t{ 0.0 };
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
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkOversketchCrossSection::~vtkOversketchCrossSection() = default;

void vtkOversketchCrossSection::SetBoundaryData(vtkPolyData* curve)
{
  this->SetInputData(1, curve);
}

void vtkOversketchCrossSection::SetPlanesData(vtkPolyData* planes)
{
  this->SetInputData(2, planes);
}

vtkPolyData* vtkOversketchCrossSection::GetSectionOutput()
{
  return this->GetOutput(1);
}

int vtkOversketchCrossSection::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return port < 3;
}

int vtkOversketchCrossSection::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* boundary = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* planes = vtkPolyData::GetData(inputs[2]);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      for (const double component : this->Right)
      {
        RequireFinite(component, "Right");
      }
      Cache& cache = *this->Internals;
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
      cache.Profile.Provide(key,
        vtkPolyData::GetData(outputs, 0),
        [&](vtkPolyData* result)
        {
          ++this->SectionCount;
          cache.Section->Initialize();
          cache.Data = SharedMesh(mesh);
          const Mesh& surface = cache.Data->Surface();
          const std::vector<int> chain =
            VerticesOnce(ReadChain(boundary, surface.vertexCount(), "boundary curve"));
          const Matrix4 frame = ReadMatrix(planes->GetFieldData(), "Frame", "planes input", planesRemedy);
          if (!planes->GetFieldData()->GetArray("PlaneT"))
          {
            throw Error(Failure::MissingArray,
              std::string("The planes input has no field array PlaneT: ") + planesRemedy + ".");
          }
          SectionRules rules;
          rules.ends = this->Ends == Outermost ? SectionRules::Ends::Outermost : SectionRules::Ends::Nearest;
          rules.plane = this->Walk == Centre ? SectionRules::Plane::Centre : SectionRules::Plane::Across;
          rules.right = Vector3(this->Right);
          rules.halfSize = mesh->GetLength();
          mesh->GetCenter(rules.centre.data());
          const Section section = crossSection(surface,
            cache.Data->Neighbours(),
            chain,
            FrameOf(frame),
            PlaceOf(planes, surface.vertexCount()),
            rules);
          if (section.points.empty())
          {
            vtkWarningMacro(
              "The plane meets the boundary curve fewer than twice: there is no profile; slide it "
              "along the reference curve.");
            return;
          }
          const std::vector<double> beside = SidesOf(mesh, section.places);
          const FlatProfile profile =
            flatProfile(section.points, beside, section.normal, FrameOf(frame).outward);
          WriteProfile(profile, planes, result);
          WriteSection(section, beside, cache.Section);
        });
      vtkPolyData::GetData(outputs, 1)->ShallowCopy(cache.Section);
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
