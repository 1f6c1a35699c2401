// The filters of system B one by one, without the system's welding, on every mesh of the shared data, by
// default and as published; then each on half of the mesh that its curves are of: a result that can be used
// or one message. Skipped, saying so, where the folder is absent.
#include "hostile_edit.h"

#include "Harness/saved.h"
#include "Harness/shipped.h"

#include "vtkOversketchCrossSection.h"
#include "vtkOversketchDistanceField.h"
#include "vtkOversketchEnclose.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchHandles.h"
#include "vtkOversketchInsertCurve.h"
#include "vtkOversketchMatrixDeform.h"
#include "vtkOversketchMeanEdge.h"
#include "vtkOversketchNurbsFit.h"
#include "vtkOversketchProfileDeform.h"
#include "vtkOversketchProfilePlanes.h"
#include "vtkOversketchProjectCurve.h"
#include "vtkOversketchResketch.h"
#include "vtkOversketchRetriangulate.h"
#include "vtkOversketchShadingLevels.h"

#include "vtkAlgorithmOutput.h"

#include <utility>

using namespace oversketch_test;

namespace
{

struct HostileEditSteps : HostileMesh
{
};

// The steps as vtkOversketchEdit joins them, on the mesh itself.
struct Steps
{
  vtkNew<vtkOversketchMeanEdge> meanEdge;
  vtkNew<vtkOversketchNurbsFit> referenceFit, boundaryFit;
  vtkNew<vtkOversketchProjectCurve> referenceProject, boundaryProject;
  vtkNew<vtkOversketchInsertCurve> referenceInsert, boundaryInsert;
  vtkNew<vtkOversketchEnclose> enclose;
  vtkNew<vtkOversketchFlatten> flatten;
  vtkNew<vtkOversketchDistanceField> distance;
  vtkNew<vtkOversketchShadingLevels> shading;
  vtkNew<vtkOversketchHandles> handles;
  vtkNew<vtkOversketchMatrixDeform> deform;
  vtkNew<vtkOversketchProfilePlanes> planes;
  vtkNew<vtkOversketchCrossSection> section;
  vtkNew<vtkOversketchResketch> redraw;
  vtkNew<vtkOversketchProfileDeform> bend;
  vtkNew<vtkOversketchRetriangulate> triangles, trianglesOfBend;

  Steps(vtkPolyData* mesh, const LineAndRing& curves, const std::string& operations)
  {
    this->meanEdge->SetInputData(0, mesh);
    this->referenceFit->SetInputData(0, curves.line);
    this->boundaryFit->SetInputData(0, curves.ring);
    this->boundaryFit->ClosedOn();
    this->referenceProject->SetInputConnection(0, this->referenceFit->GetOutputPort());
    this->referenceProject->SetMeshConnection(this->meanEdge->GetOutputPort());
    this->referenceInsert->SetInputConnection(0, this->meanEdge->GetOutputPort());
    this->referenceInsert->SetCurvesConnection(this->referenceProject->GetOutputPort());
    this->boundaryProject->SetInputConnection(0, this->boundaryFit->GetOutputPort());
    this->boundaryProject->SetMeshConnection(this->referenceInsert->GetOutputPort());
    this->boundaryInsert->SetInputConnection(0, this->referenceInsert->GetOutputPort());
    this->boundaryInsert->SetCurvesConnection(this->boundaryProject->GetOutputPort());
    this->boundaryInsert->SetStoredConnection(this->referenceInsert->GetOutputPort(1));
    vtkAlgorithmOutput* boundary = this->boundaryInsert->GetOutputPort(1);
    vtkAlgorithmOutput* reference = this->boundaryInsert->GetOutputPort(2);
    this->enclose->SetInputConnection(0, this->boundaryInsert->GetOutputPort());
    this->enclose->SetReferenceConnection(reference);
    this->enclose->SetBoundaryConnection(boundary);
    this->flatten->SetInputConnection(0, this->enclose->GetOutputPort());
    this->flatten->SetReferenceConnection(reference);
    this->distance->SetInputConnection(0, this->flatten->GetOutputPort());
    this->distance->SetReferenceConnection(reference);
    this->shading->SetInputConnection(0, this->distance->GetOutputPort());
    this->shading->SetDiscConnection(this->flatten->GetOutputPort(1));
    this->handles->SetInputConnection(0, this->distance->GetOutputPort());
    this->handles->SetReferenceConnection(reference);
    this->handles->SetOperations(operations.c_str());
    this->deform->SetInputConnection(0, this->shading->GetOutputPort());
    this->deform->SetHandlesConnection(this->handles->GetOutputPort());
    this->planes->SetInputConnection(0, this->distance->GetOutputPort());
    this->planes->SetReferenceConnection(reference);
    this->section->SetInputConnection(0, this->distance->GetOutputPort());
    this->section->SetBoundaryConnection(boundary);
    this->section->SetPlanesConnection(this->planes->GetOutputPort());
    this->redraw->SetInputConnection(0, this->section->GetOutputPort());
    this->redraw->SetStrokeData(flatCurve({ { 0.1, 0.2 }, { 0.3, 0.5 }, { 0.7, 0.5 }, { 0.9, 0.2 } }));
    this->bend->SetInputConnection(0, this->shading->GetOutputPort());
    this->bend->SetReferenceConnection(reference);
    this->bend->SetProfileConnection(this->section->GetOutputPort());
    this->bend->SetDrawnConnection(this->redraw->GetOutputPort());
    const std::pair<vtkOversketchRetriangulate*, vtkAlgorithmOutput*> cut[] = {
      { this->triangles, this->deform->GetOutputPort() },
      { this->trianglesOfBend, this->bend->GetOutputPort() }
    };
    for (const auto& [step, moved] : cut)
    {
      step->SetInputConnection(0, moved);
      step->SetReferenceConnection(reference);
      step->SetBoundaryConnection(boundary);
      step->SetRestConnection(this->shading->GetOutputPort());
    }
  }

  void asPublished() const
  {
    for (vtkOversketchNurbsFit* fit : { this->referenceFit.Get(), this->boundaryFit.Get() })
    {
      fit->InterpolateOn();
      fit->PeriodicOff();
      fit->CutLoopsOff();
    }
    this->referenceProject->SetSpacing(4.0);
    this->boundaryProject->SetSpacing(4.0);
    for (vtkOversketchInsertCurve* insert : { this->referenceInsert.Get(), this->boundaryInsert.Get() })
    {
      insert->SnapOff();
      insert->BridgeOff();
      insert->CleanOff();
    }
    this->flatten->AsPublishedOn();
    this->distance->AsPublishedOn();
    this->shading->AsPublishedOn();
    this->planes->SetFrame(vtkOversketchProfilePlanes::Fitted);
    this->section->SetEndsToOutermost();
    this->section->SetWalkToCentre();
    this->redraw->SetMiddle(vtkOversketchResketch::Closest);
    this->redraw->RawTangentsOn();
    this->triangles->SetRuleToCurvature();
    this->trianglesOfBend->SetRuleToCurvature();
  }

  // In an order in which each finds what it needs.
  std::vector<std::pair<const char*, vtkPolyDataAlgorithm*>> all() const
  {
    return { { "MeanEdge", this->meanEdge },
      { "ReferenceFit", this->referenceFit },
      { "ReferenceProject", this->referenceProject },
      { "ReferenceInsert", this->referenceInsert },
      { "BoundaryFit", this->boundaryFit },
      { "BoundaryProject", this->boundaryProject },
      { "BoundaryInsert", this->boundaryInsert },
      { "Enclose", this->enclose },
      { "Flatten", this->flatten },
      { "Distance", this->distance },
      { "Shading", this->shading },
      { "Handles", this->handles },
      { "Deform", this->deform },
      { "Triangles", this->triangles },
      { "Planes", this->planes },
      { "Section", this->section },
      { "Redraw", this->redraw },
      { "Bend", this->bend },
      { "Triangles of Bend", this->trianglesOfBend } };
  }
};

// True for a result of finite points, false for one message.
bool usableOrRefused(const char* name, vtkPolyDataAlgorithm* step)
{
  SCOPED_TRACE(name);
  Ear ear(step);
  const std::clock_t start = std::clock();
  step->Update();
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, longestRun);
  const bool refused = step->GetErrorCode() != 0 || !ear.errors.empty();
  if (refused)
  {
    EXPECT_EQ(ear.errors.size(), 1u) << (ear.errors.empty() ? "no message" : ear.errors.back());
    EXPECT_NE(step->GetErrorCode(), codeOf(Failure::Unexpected)) << ear.errors[0];
    std::cout << name << ": " << (ear.errors.empty() ? "" : ear.errors[0]);
  }
  for (int port = 0; port < step->GetNumberOfOutputPorts(); ++port)
  {
    if (auto* output = vtkPolyData::SafeDownCast(step->GetOutputDataObject(port)))
    {
      EXPECT_TRUE(!refused || output->GetNumberOfPoints() == 0);
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        if (!Vector3(output->GetPoint(i)).allFinite())
        {
          ADD_FAILURE() << "point " << i << " of output " << port << " is not finite";
          break;
        }
      }
    }
  }
  return !refused;
}

// The first half of a mesh's triangles, with all points and their arrays.
vtkSmartPointer<vtkPolyData> halfOf(vtkPolyData* mesh)
{
  auto half = vtkSmartPointer<vtkPolyData>::New();
  half->ShallowCopy(mesh);
  half->GetCellData()->Initialize();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys() / 2; ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    triangles->InsertNextCell(ids);
  }
  half->SetPolys(triangles);
  return half;
}

} // namespace

TEST_P(HostileEditSteps, EachAloneIsOfUseOrGivesOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const LineAndRing curves = hostileCurves(mesh, false).front();
  const std::string move = "move 0.5 n " + std::to_string(0.05 * boundingDiagonal(mesh));
  for (const bool published : { false, true })
  {
    SCOPED_TRACE(published ? "as published" : "by default");
    const Steps steps(polyData, curves, move);
    if (published)
    {
      steps.asPublished();
    }
    std::vector<std::pair<const char*, vtkPolyDataAlgorithm*>> ran;
    for (const auto& [name, step] : steps.all())
    {
      if (!usableOrRefused(name, step))
      {
        break; // what is below has no input
      }
      ran.emplace_back(name, step);
    }
    // From the last on, so that what is above still has what it made of the whole.
    std::reverse(ran.begin(), ran.end());
    for (const auto& [name, step] : ran)
    {
      vtkPolyData* input = vtkPolyData::SafeDownCast(step->GetInputDataObject(0, 0));
      if (input && input->GetNumberOfPolys() > 1)
      {
        step->SetInputData(0, halfOf(input));
        usableOrRefused(name, step);
      }
    }
  }
}

// What a step puts out is written, read and handed on: whichever two steps are parted so, the same comes out.
TEST(EditSteps, ThroughAFileBetweenAnyTwoStepsTheBitsAreTheSame)
{
  const auto model = shippedModel("bear");
  const Mesh mesh = MeshOf(model);
  const LineAndRing curves = hostileCurves(mesh, false).front();
  const std::string move =
    "move 0.5 n " + std::to_string(0.05 * boundingDiagonal(mesh)) + "; rotate 0.3 t 20";
  const Steps whole(model, curves, move);
  for (vtkPolyDataAlgorithm* last : { whole.triangles.Get(), whole.trianglesOfBend.Get() })
  {
    last->Update();
    ASSERT_GT(last->GetOutput()->GetNumberOfPoints(), 0);
    ASSERT_GT(vtkOversketchRetriangulate::SafeDownCast(last)->GetOperationCount(), 0);
  }
  for (const auto& [name, step] : Steps(model, curves, move).all())
  {
    SCOPED_TRACE(name);
    // Cold, but that this step's outputs come from files.
    const Steps parted(model, curves, move);
    vtkPolyDataAlgorithm* made = nullptr;
    for (const auto& [other, itself] : parted.all())
    {
      made = std::string(other) == name ? itself : made;
    }
    made->Update();
    std::vector<vtkSmartPointer<vtkPolyData>> files;
    for (int port = 0; port < made->GetNumberOfOutputPorts(); ++port)
    {
      auto* output = vtkPolyData::SafeDownCast(made->GetOutputDataObject(port));
      files.push_back(output ? saved(output) : nullptr);
    }
    int handed = 0;
    for (const auto& [other, consumer] : parted.all())
    {
      for (int port = 0; port < consumer->GetNumberOfInputPorts(); ++port)
      {
        vtkAlgorithmOutput* from =
          consumer->GetNumberOfInputConnections(port) > 0 ? consumer->GetInputConnection(port, 0) : nullptr;
        if (from && from->GetProducer() == made && files[static_cast<std::size_t>(from->GetIndex())])
        {
          consumer->SetInputDataObject(port, files[static_cast<std::size_t>(from->GetIndex())]);
          ++handed;
        }
      }
    }
    EXPECT_TRUE(handed > 0 || made == parted.triangles.Get() || made == parted.trianglesOfBend.Get());
    const std::pair<vtkOversketchRetriangulate*, vtkOversketchRetriangulate*> pairs[] = {
      { parted.triangles, whole.triangles }, { parted.trianglesOfBend, whole.trianglesOfBend }
    };
    for (const auto& [one, other] : pairs)
    {
      one->Update();
      for (int port = 0; port < 3; ++port)
      {
        EXPECT_TRUE(identical(one->GetOutput(port), other->GetOutput(port))) << port;
      }
      EXPECT_EQ(one->GetOutput()->GetPointData()->GetNumberOfArrays(),
        other->GetOutput()->GetPointData()->GetNumberOfArrays());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SharedData, HostileEditSteps, testing::ValuesIn(meshNames()), meshTestName);
