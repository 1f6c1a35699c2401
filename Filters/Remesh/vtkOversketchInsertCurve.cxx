#include "vtkOversketchInsertCurve.h"

#include "Remesh/insert_curves.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <list>
#include <memory>

using namespace oversketch;

// The last result.
namespace
{

const char* const curveRemedy = "take the curves from vtkOversketchProjectCurve";
const char* const chainRemedy = "take them from vtkOversketchInsertCurve";

// The curves of the input as the kernel takes them, and the cell that stands for each.
struct ReadCurves
{
  std::list<View> Views; // that the curves point to
  std::vector<NewCurve> Curves;
  std::vector<vtkIdType> Cells;
};

class CurveReader
{
public:
  CurveReader(vtkPolyData* curves, const Mesh& mesh)
    : Input(curves)
    , Surface(mesh)
  {
    const vtkIdType points = curves->GetNumberOfPoints(), cells = curves->GetNumberOfCells();
    if (curves->GetNumberOfLines() == 0 || curves->GetNumberOfLines() != cells)
    {
      throw Error(Failure::BadStroke, "The curves must be polylines and no other cells: %1.", curveRemedy);
    }
    this->Parameters = RequireArray(curves->GetPointData(), "CurveT", 1, points, "curves", curveRemedy);
    this->Triangles = RequireArray(curves->GetPointData(), "MeshCell", 1, points, "curves", curveRemedy);
    this->Strokes = RequireArray(curves->GetCellData(), "StrokeId", 1, cells, "curves", curveRemedy);
    this->Closed = RequireArray(curves->GetCellData(), "Closed", 1, cells, "curves", curveRemedy);
    this->Bindings = ReadBindings(curves, mesh.vertexCount(), "curves", curveRemedy);
  }

  ReadCurves Read()
  {
    ReadCurves result;
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      if (cell == 0 || this->Strokes->GetComponent(cell, 0) != this->Strokes->GetComponent(cell - 1, 0))
      {
        result.Views.push_back(ViewOfStroke(this->Input, cell));
        NewCurve curve;
        curve.closed = this->Closed->GetComponent(cell, 0) != 0.0;
        curve.number = static_cast<int>(result.Curves.size());
        curve.view = &result.Views.back();
        result.Curves.push_back(curve);
        result.Cells.push_back(cell);
      }
      NewCurve& curve = result.Curves.back();
      curve.runs.push_back(this->Run(cell));
      if (!curve.closed && curve.runs.size() > 1)
      {
        throw Error(Failure::BadStroke,
          Message::unusable("Curve", curve.number, "it is open, and in several runs. Give one of them."));
      }
    }
    return result;
  }

private:
  CurveRun Run(vtkIdType cell) const
  {
    vtkNew<vtkIdList> ids;
    this->Input->GetLines()->GetCellAtId(cell, ids);
    vtkIdType count = ids->GetNumberOfIds();
    CurveRun run;
    run.closed = count > 3 && ids->GetId(0) == ids->GetId(count - 1);
    count -= run.closed;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType id = ids->GetId(i);
      const double parameter = this->Parameters->GetComponent(id, 0);
      if (!std::isfinite(parameter) || (i > 0 && !(parameter > run.parameters.back())))
      {
        throw Error(Failure::BadStroke,
          "Array CurveT of the curves does not rise along polyline %1: %2.",
          cell,
          curveRemedy);
      }
      run.parameters.push_back(parameter);
      run.places.push_back(this->Place(id));
    }
    if (count < 2)
    {
      throw Error(
        Failure::BadStroke, "Polyline %1 of the curves has fewer than two points: %2.", cell, curveRemedy);
    }
    return run;
  }

  // The triangle that a point names must be the one that it hangs on.
  SurfacePoint Place(vtkIdType id) const
  {
    const double triangle = this->Triangles->GetComponent(id, 0);
    const Binding& binding = this->Bindings[static_cast<std::size_t>(id)];
    if (!(triangle >= 0.0 && triangle < this->Surface.triangleCount()) ||
        this->Surface.triangles[static_cast<std::size_t>(triangle)] != binding.vertices)
    {
      throw Error(Failure::BadMesh,
        "Point %1 of the curves lies in triangle %2, which the mesh does not have like that: project the "
        "curves on this mesh.",
        id,
        static_cast<long long>(triangle));
    }
    return { static_cast<int>(triangle), binding.weights };
  }

  vtkPolyData* Input;
  const Mesh& Surface;
  vtkDataArray *Parameters, *Triangles, *Strokes, *Closed;
  std::vector<Binding> Bindings;
};

std::vector<MeshCurve> readStored(vtkPolyData* stored, int vertexCount)
{
  std::vector<MeshCurve> curves;
  if (!stored || stored->GetNumberOfPoints() == 0)
  {
    return curves;
  }
  vtkDataArray* parameters = RequireArray(
    stored->GetPointData(), "CurveT", 1, stored->GetNumberOfPoints(), "stored curves", chainRemedy);
  for (const Chain& chain : ReadChains(stored, vertexCount, "stored curves"))
  {
    MeshCurve curve;
    curve.closed = chain.Vertices.size() > 3 && chain.Vertices.front() == chain.Vertices.back();
    const std::size_t count = chain.Vertices.size() - curve.closed;
    curve.vertices.assign(
      chain.Vertices.begin(), chain.Vertices.begin() + static_cast<std::ptrdiff_t>(count));
    bool rises = count > 1;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double t = parameters->GetComponent(chain.Ids[i], 0);
      rises = rises && std::isfinite(t) && (i == 0 || t > curve.parameters.back());
      curve.parameters.push_back(t);
    }
    if (!rises)
    {
      throw Error(Failure::BadStroke,
        "Stored curve %1 cannot be used: array CurveT does not rise along it: %2.",
        curves.size(),
        chainRemedy);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

void writeMesh(vtkPolyData* input, const InsertedCurves& result, vtkPolyData* output)
{
  const auto mixed = [&](vtkIdType point) -> const Mix&
  { return result.origins[static_cast<std::size_t>(point)]; };
  WriteCarried(result.mesh, { result.pointSources, mixed, "Region" }, result.triangleSources, input, output);
}

// cells: the input's cell that each curve takes its arrays from.
void writeCurves(const std::vector<MeshCurve>& curves,
  const Mesh& mesh,
  vtkPolyData* input,
  const std::vector<vtkIdType>& cells,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const auto vertices = NewArray<vtkIdTypeArray>("VertexId");
  const auto parameters = NewArray<vtkDoubleArray>("CurveT");
  vtkCellData* from = input->GetCellData();
  vtkCellData* to = output->GetCellData();
  to->CopyAllocate(from);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const MeshCurve& curve = curves[i];
    const vtkIdType cell = lines->InsertNextCell(curve.count() + curve.closed);
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < curve.count(); ++k)
    {
      lines->InsertCellPoint(points->InsertNextPoint(mesh.points[curve.vertices[k]].data()));
      vertices->InsertNextValue(curve.vertices[k]);
      parameters->InsertNextValue(curve.parameters[k]);
    }
    if (curve.closed)
    {
      lines->InsertCellPoint(first);
    }
    to->CopyData(from, cells[i], cell);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(vertices);
  output->GetPointData()->AddArray(parameters);
  output->GetFieldData()->PassData(input->GetFieldData());
}

} // namespace

vtkStandardNewMacro(vtkOversketchInsertCurve);

vtkOversketchInsertCurve::vtkOversketchInsertCurve()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchInsertCurve::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* curves = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* stored = vtkPolyData::GetData(inputs[2]);
  if (curves->GetNumberOfPoints() == 0)
  {
    vtkPolyData::GetData(outputs, 0)->ShallowCopy(input);
    if (stored)
    {
      vtkPolyData::GetData(outputs, 2)->ShallowCopy(stored);
    }
    return;
  }
  RequirePolygonsOnly(input); // the key does not see other cells
  const StepKey key({ WholeKey(input), WholeKey(curves), stored ? WholeKey(stored) : MeshKey() },
    { this->Snap ? 1.0 : 0.0,
      this->EmbedSegments ? 1.0 : 0.0,
      this->Bridge ? 1.0 : 0.0,
      static_cast<double>(this->Gap),
      this->JoinRuns ? 1.0 : 0.0,
      this->Clean ? 1.0 : 0.0 });
  this->Kept<KeptOutput>().Provide(key,
    { vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1), vtkPolyData::GetData(outputs, 2) },
    [&](const KeptOutput::Outputs& made)
    {
      ++this->InsertionCount;
      const std::shared_ptr<const MeshData> shared =
        SharedMesh(input); // whose mesh goes with the last who holds it
      const Mesh& mesh = shared->Surface();
      const ReadCurves read = CurveReader(curves, mesh).Read();
      const std::vector<MeshCurve> kept = readStored(stored, mesh.vertexCount());
      InsertRules rules;
      rules.snap = this->Snap;
      rules.embed = this->EmbedSegments;
      rules.bridge = this->Bridge;
      rules.gap = static_cast<InsertRules::Gap>(this->Gap);
      rules.join = this->JoinRuns;
      rules.clean = this->Clean;
      rules.left = MaskedPointsOf(input);
      const InsertedCurves result = insertCurves(mesh, read.Curves, kept, rules, ContextOf(this));
      writeMesh(input, result, made[0]);
      writeCurves(result.curves, result.mesh, curves, read.Cells, made[1]);
      made[1]->GetCellData()->RemoveArray("CurveId");
      if (!kept.empty())
      {
        std::vector<vtkIdType> cells;
        for (std::size_t i = 0; i < kept.size(); ++i)
        {
          cells.push_back(static_cast<vtkIdType>(i));
        }
        writeCurves(result.stored, result.mesh, stored, cells, made[2]);
      }
      this->BridgeCount = result.bridges;
    });
}

void vtkOversketchInsertCurve::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Snap: " << (this->Snap ? "On" : "Off") << "\n";
  os << indent << "EmbedSegments: " << (this->EmbedSegments ? "On" : "Off") << "\n";
  os << indent << "Bridge: " << (this->Bridge ? "On" : "Off") << "\n";
  os << indent << "Gap: " << this->Gap << "\n";
  os << indent << "Clean: " << (this->Clean ? "On" : "Off") << "\n";
  os << indent << "JoinRuns: " << (this->JoinRuns ? "On" : "Off") << "\n";
  os << indent << "BridgeCount: " << this->BridgeCount << "\n";
  os << indent << "InsertionCount: " << this->InsertionCount << "\n";
}
