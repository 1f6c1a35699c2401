#include "system_targets.h"

#include "requirements.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"
#include "Mesh/context.h"
#include "Mesh/view.h"

#include "vtkOversketchAugment.h"
#include "vtkOversketchInflateDrawing.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchStellarRefine.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <utility>

using namespace oversketch;
using oversketch_test::Ear;

namespace oversketch_fuzz
{

namespace
{

// Numbers from bytes; zeros behind their end.
class Source
{
public:
  explicit Source(const std::string& bytes)
    : Bytes(bytes)
  {
  }
  template <typename T>
  T take()
  {
    T value = 0;
    const std::size_t size = std::min(sizeof value, this->Bytes.size() - this->At);
    std::memcpy(&value, this->Bytes.data() + this->At, size);
    this->At += size;
    return value;
  }
  bool ended() const { return this->At == this->Bytes.size(); }

private:
  const std::string& Bytes;
  std::size_t At = 0;
};

// Tiny meshes of every kind; the first has a limb.
vtkSmartPointer<vtkPolyData> tinyMesh(int which)
{
  Mesh mesh = which == 1   ? oversketch_test::torus(1.0, 0.4, 10, 6)
              : which == 2 ? oversketch_test::cylinder(0.5, 2.0, 8, 6)
                           : oversketch_test::icosphere(which == 0   ? 2
                                                        : which == 3 ? 0
                                                                     : 1);
  for (Vector3& p : mesh.points)
  {
    if (which == 0 && p.x() > 0.6)
    {
      p.x() += 3.0 * (p.x() - 0.6);
    }
    if (which == 4)
    {
      p.z() = 0.0; // two sheets in one plane
    }
  }
  if (which == 5)
  {
    mesh.triangles.push_back(mesh.triangles[0]);
    mesh.triangles.push_back({ mesh.triangles[1][0], mesh.triangles[1][0], mesh.triangles[2][0] });
    mesh.points[0] = mesh.points[1];
  }
  return oversketch_test::toPolyData(mesh);
}

View viewFrom(Source& source, int flags)
{
  const auto coordinate = [&source] { return source.take<std::int8_t>() / 32.0; };
  const Vector3 eye(coordinate(), coordinate(), coordinate() + 4.0);
  const int width = 1 + source.take<std::uint16_t>() % 1000, height = 1 + source.take<std::uint16_t>() % 1000;
  return flags & 1 ? oversketch_test::perspectiveView(
                       eye, Vector3::UnitY(), 1.0 + source.take<std::uint8_t>() / 2.0, width, height)
                   : oversketch_test::orthographicView(
                       eye, Vector3::UnitY(), 1.0 + source.take<std::uint8_t>(), width, height);
}

// The same, where the bytes make a view at all: none where the eye is what it looks at.
std::optional<View> anyViewFrom(Source& source, int flags)
{
  try
  {
    return viewFrom(source, flags);
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
}

} // namespace

// The whole of system A: mesh, options, view and samples from bytes.
void takeOneStroke(const std::string& bytes)
{
  Source source(bytes);
  const auto mesh = tinyMesh(source.take<std::uint8_t>() % 6);
  const int flags = source.take<std::uint8_t>();
  const std::optional<View> view = anyViewFrom(source, flags);
  std::vector<Vector2> samples;
  while (view && !source.ended() && samples.size() < 64)
  {
    samples.emplace_back(source.take<std::int16_t>() / 16.0, source.take<std::int16_t>() / 16.0);
  }
  if (samples.empty())
  {
    return;
  }
  const auto stroke = oversketch_test::toStroke(samples, *view);
  if (flags & 2) // any numbers where the view should be
  {
    vtkDataArray* array =
      stroke->GetCellData()->GetArray(flags & 4 ? "ViewTransform" : "ProjectionTransform");
    double number = 0.0;
    std::memcpy(&number,
      bytes.data() + bytes.size() - std::min<std::size_t>(8, bytes.size()),
      std::min<std::size_t>(8, bytes.size()));
    array->SetComponent(0, flags >> 4, number);
  }
  vtkNew<vtkOversketchOneStroke> system;
  const Ear ear(system);
  system->SetBackendToHost();
  system->SetRemesh(flags & 8 ? vtkOversketchOneStroke::RemeshOff : vtkOversketchOneStroke::RemeshAuto);
  system->SetAsPublished(flags & 128 ? 1 : 0);
  system->SetInputData(0, mesh);
  system->SetStrokeData(stroke);
  system->Update();
  requireMeshOrMessage(system.Get(), ear);
}

namespace
{

// What the bytes say of a length: about the model's size, or any number.
double lengthFrom(Source& source, bool any)
{
  const auto number = source.take<std::int16_t>() / 4096.0;
  return any ? source.take<double>() : number;
}

// Some of a 4-8 mesh's arrays are written over where the bytes say so.
void damage(vtkPolyData* mesh, Source& source, int times)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkFieldData* of : { static_cast<vtkFieldData*>(mesh->GetPointData()),
         static_cast<vtkFieldData*>(mesh->GetCellData()),
         mesh->GetFieldData() })
  {
    for (int i = 0; i < of->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(of->GetArray(i));
    }
  }
  for (; times > 0; --times)
  {
    vtkDataArray* array = arrays[source.take<std::uint8_t>() % arrays.size()];
    const vtkIdType count = array->GetNumberOfTuples();
    if (count > 0)
    {
      array->SetComponent(source.take<std::uint16_t>() % count, 0, source.take<std::int16_t>());
      array->Modified();
    }
  }
}

} // namespace

// The whole of system D: mesh, options, view and strokes from bytes; and once more on a 4-8 mesh that may be
// damaged.
void takeAugment(const std::string& bytes)
{
  Source source(bytes);
  const auto mesh = tinyMesh(source.take<std::uint8_t>() % 6);
  const int flags = source.take<std::uint8_t>(), more = source.take<std::uint8_t>();
  vtkNew<vtkOversketchAugment> system;
  Ear ear(system);
  system->SetBackendToHost();
  system->SetRadius(lengthFrom(source, more & 1));
  system->SetHeight(lengthFrom(source, more & 2));
  system->SetSharpness(lengthFrom(source, more & 4));
  system->SetTargetEdgeLength(lengthFrom(source, more & 8));
  system->SetSketchMode(flags & 2 ? 1 : 0);
  system->SetDistance(flags & 4 ? 1 : 0);
  system->SetOneByOne((flags & 8) != 0);
  system->SetBase(flags & 16 ? 1 : 0);
  system->SetAsPublished((flags & 32) != 0);
  system->SetSimplify((flags & 64) == 0);
  vtkOversketchStellarRefine::SafeDownCast(system->GetStep("Refine"))->SetMaximumFaces(20000);
  const std::optional<View> view = anyViewFrom(source, flags);
  const int faults = more & 128 ? more >> 4 & 7 : 0;
  const std::string faultBytes = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 64));
  vtkNew<vtkAppendPolyData> strokes;
  bool any = false;
  while (view && !source.ended() && strokes->GetNumberOfInputConnections(0) < 4)
  {
    std::vector<Vector2> samples;
    for (int count = source.take<std::uint8_t>() % 32; count > 0 && !source.ended(); --count)
    {
      samples.emplace_back(source.take<std::int16_t>() / 16.0, source.take<std::int16_t>() / 16.0);
    }
    if (!samples.empty())
    {
      strokes->AddInputData(oversketch_test::toStroke(samples, *view));
      any = true;
    }
  }
  if (!any)
  {
    return;
  }
  strokes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  strokes->Update();
  system->SetInputData(0, mesh);
  system->SetInputData(1, strokes->GetOutput());
  for (int round = 0; round < 2; ++round)
  {
    ear.errors.clear();
    system->Modified();
    system->Update();
    if (!requireMeshOrMessage(system.Get(), ear))
    {
      return;
    }
    vtkNew<vtkPolyData> again;
    again->DeepCopy(system->GetOutput());
    Source of(faultBytes);
    damage(again, of, faults);
    system->SetInputData(0, again);
  }
}

namespace
{

// A closed surface, but for tunnels without walls: every edge of two faces, wound against each other.
void requireClosed(vtkPolyData* surface)
{
  std::set<std::pair<vtkIdType, vtkIdType>> ways;
  vtkNew<vtkIdList> face;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, face);
    const vtkIdType count = face->GetNumberOfIds();
    for (vtkIdType k = 0; k < count; ++k)
    {
      require(
        ways.emplace(face->GetId(k), face->GetId((k + 1) % count)).second, "an edge twice the same way");
    }
  }
  for (const auto& [from, to] : ways)
  {
    require(ways.count({ to, from }) == 1, "an open edge");
  }
}

} // namespace

// The whole of system C: options and strokes from bytes, over a canvas of 256 px.
void takeDrawing(const std::string& bytes)
{
  Source source(bytes);
  const int flags = source.take<std::uint8_t>(), more = source.take<std::uint8_t>();
  static const View view =
    oversketch_test::orthographicView(Vector3::UnitZ(), Vector3::UnitY(), 128.0, 256, 256);
  vtkNew<vtkOversketchInflateDrawing> system;
  const Ear ear(system);
  system->SetExtrudeDepth(flags & 1 ? lengthFrom(source, more & 1) : 0.0);
  system->SetHeight(flags & 2 ? lengthFrom(source, more & 2) : 1.0);
  static const char* const profiles[] = { "", "linear", "step", "0 0, 0.3 0.8, 1 1" };
  system->SetProfile(profiles[more >> 2 & 3]);
  system->SetPoisson((flags & 4) != 0);
  system->SetQuads((flags & 8) != 0);
  system->SetLevels(more >> 4 & 3);
  system->SetArrange((more & 64) != 0);
  system->SetAsPublished((flags & 16) != 0);
  vtkNew<vtkAppendPolyData> strokes;
  bool any = false;
  while (!source.ended() && strokes->GetNumberOfInputConnections(0) < 8)
  {
    const int kind = source.take<std::uint8_t>();
    const bool closed = (kind & 1) != 0;
    std::vector<Vector2> samples;
    for (int count = kind >> 3; count > 0 && !source.ended(); --count)
    {
      samples.emplace_back(source.take<std::uint16_t>() / 256.0, source.take<std::uint16_t>() / 256.0);
    }
    if (samples.empty())
    {
      continue;
    }
    if (closed)
    {
      samples.push_back(samples.front());
    }
    const auto stroke = oversketch_test::toStroke(samples, view);
    vtkNew<vtkIntArray> treatment;
    treatment->SetName("Treatment");
    treatment->InsertNextValue(kind >> 1 & 3);
    stroke->GetCellData()->AddArray(treatment);
    strokes->AddInputData(stroke);
    any = true;
  }
  if (!any)
  {
    return;
  }
  strokes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  strokes->Update();
  system->SetInputData(0, strokes->GetOutput());
  system->Update();
  const bool isMesh = requireMeshOrMessage(system.Get(), ear);
  if (isMesh && !system->GetAsPublished()) // which cuts tunnels without walls, and leaves what turned over
  {
    requireClosed(system->GetOutput());
  }
}

} // namespace oversketch_fuzz
