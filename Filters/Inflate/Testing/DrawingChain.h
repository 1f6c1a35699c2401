// Concentric circles from curves to the surface, for the tests of this module.
#ifndef oversketch_filters_inflate_testing_drawing_chain_h
#define oversketch_filters_inflate_testing_drawing_chain_h

#include "../../Planar/Testing/CurveShapes.h"
#include "Harness/drawn_meshes.h"
#include "Harness/solid_shape.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchExtrude.h"
#include "vtkOversketchInflate.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchTreatment.h"
#include "vtkOversketchTunnel.h"

#include "vtkIdList.h"

namespace oversketch_test
{

const Vector2 canvasCentre(512.0, 512.0);

inline vtkSmartPointer<vtkPolyData> toPlanar(const PlanarMesh& mesh)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  WritePlanarMesh(mesh, result);
  WriteCanvas({ Vector2::Zero(), Vector2(1024.0, 1024.0) }, result);
  return result;
}

inline Shape shapeOf(vtkPolyData* surface)
{
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points.emplace_back(surface->GetPoint(i));
  }
  std::vector<Corners> faces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < surface->GetNumberOfPolys(); ++f)
  {
    surface->GetPolys()->GetCellAtId(f, ids);
    Corners corners{ -1, -1, -1, -1 };
    for (int k = 0; k < static_cast<int>(ids->GetNumberOfIds()); ++k)
    {
      corners[k] = static_cast<int>(ids->GetId(k));
    }
    faces.push_back(corners);
  }
  return shapeOf(points, faces);
}

inline void expectClosed(vtkPolyData* surface, int chi)
{
  const Shape shape = shapeOf(surface);
  EXPECT_EQ(shape.loops + shape.odd + shape.pinched, 0);
  EXPECT_EQ(shape.chi, chi);
  EXPECT_GT(shape.volume, 0.0);
  EXPECT_EQ(shape.points, surface->GetNumberOfPoints());
}

// Circles of 200 and 100 units about the canvas's middle; what the inner one is, is said by the treatment
// filter. The drawing's mesh is made here.
struct DrawingChain
{
  explicit DrawingChain(Treatment inner = Treatment::Fill, int levels = 3)
  {
    const BoundaryKind kinds[] = { BoundaryKind::Feature, BoundaryKind::Hole, BoundaryKind::TunnelRim };
    std::vector<Circle> circles{ { 200.0, BoundaryKind::Object },
      { 150.0, BoundaryKind::Interior },
      { 100.0, kinds[static_cast<int>(inner)] } };
    if (inner != Treatment::Hole)
    {
      circles.push_back({ 50.0, BoundaryKind::Interior });
    }
    this->Mesh = toPlanar(disc(canvasCentre, circles, 12, levels));
    this->Classify->SetInputData(toCurves({ closedStroke(ringAt(canvasCentre[0], canvasCentre[1], 200.0)),
      closedStroke(ringAt(canvasCentre[0], canvasCentre[1], 100.0)) }));
    this->Treat->SetInputConnection(this->Classify->GetOutputPort());
    this->Treat->SetHoles(inner == Treatment::Hole ? "1" : "");
    this->Treat->SetTunnels(inner == Treatment::Tunnel ? "1" : "");
    this->Measure->SetInputConnection(this->Treat->GetOutputPort());
    this->Inflate->SetInputData(this->Mesh);
    this->Inflate->SetDistanceConnection(this->Measure->GetOutputPort(1));
    this->Extrude->SetInputData(this->Mesh);
    this->Cut->SetInputConnection(this->Inflate->GetOutputPort());
    this->Cut->SetCurvesConnection(this->Measure->GetOutputPort());
  }

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkOversketchClassify> Classify;
  vtkNew<vtkOversketchTreatment> Treat;
  vtkNew<vtkOversketchDistance> Measure;
  vtkNew<vtkOversketchInflate> Inflate;
  vtkNew<vtkOversketchExtrude> Extrude;
  vtkNew<vtkOversketchTunnel> Cut;
};

inline std::vector<double> valuesOf(vtkDataSetAttributes* of, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = of->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

// Points, faces and all arrays.
inline bool sameBits(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* x, vtkDataArray* y)
  {
    if (!x || !y || x->GetNumberOfValues() != y->GetNumberOfValues())
    {
      return false;
    }
    for (vtkIdType i = 0; i < x->GetNumberOfValues(); ++i)
    {
      const int n = x->GetNumberOfComponents();
      if (x->GetComponent(i / n, static_cast<int>(i % n)) != y->GetComponent(i / n, static_cast<int>(i % n)))
      {
        return false;
      }
    }
    return true;
  };
  bool result = same(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
                same(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray());
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    result = result && same(a->GetPointData()->GetArray(i), b->GetPointData()->GetArray(i));
  }
  for (int i = 0; i < a->GetCellData()->GetNumberOfArrays(); ++i)
  {
    result = result && same(a->GetCellData()->GetArray(i), b->GetCellData()->GetArray(i));
  }
  return result;
}

} // namespace oversketch_test
#endif
