// From curves to the textured surface by filters alone.
#include "DrawingChain.h"
#include "vtkOversketchCoarseMesh.h"
#include "vtkOversketchDarts.h"
#include "vtkOversketchPlanarRefine.h"
#include "vtkOversketchPolyline.h"
#include "vtkOversketchProjectTexture.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

TEST(WholeChain, ABodyWithAHoleAndATunnel)
{
  vtkNew<vtkOversketchClassify> classify;
  classify->SetInputData(toCurves({ closedStroke(ringAt(512, 512, 400)),
    closedStroke(ringAt(350, 512, 100)),
    closedStroke(ringAt(700, 512, 110)) }));
  vtkNew<vtkOversketchTreatment> treatment;
  treatment->SetInputConnection(classify->GetOutputPort());
  vtkNew<vtkOversketchDistance> distance;
  distance->SetInputConnection(treatment->GetOutputPort());
  vtkNew<vtkOversketchPolyline> polyline;
  polyline->SetInputConnection(treatment->GetOutputPort());
  polyline->SetDistanceConnection(distance->GetOutputPort(1));
  polyline->SetTolerance(0.005); // close enough to need no splits: nothing hands them back here
  vtkNew<vtkOversketchDarts> darts;
  darts->SetInputConnection(polyline->GetOutputPort());
  darts->SetDistanceConnection(distance->GetOutputPort(1));
  vtkNew<vtkOversketchCoarseMesh> coarse;
  coarse->SetInputConnection(polyline->GetOutputPort());
  coarse->SetDartsConnection(darts->GetOutputPort());
  vtkNew<vtkOversketchPlanarRefine> refine;
  refine->SetInputConnection(coarse->GetOutputPort());
  refine->SetEdgesConnection(coarse->GetOutputPort(1));
  refine->SetCurvesConnection(treatment->GetOutputPort());
  vtkNew<vtkOversketchInflate> inflate;
  inflate->SetInputConnection(refine->GetOutputPort());
  inflate->SetDistanceConnection(distance->GetOutputPort(1));
  vtkNew<vtkOversketchExtrude> extrude;
  extrude->SetInputConnection(refine->GetOutputPort());
  vtkNew<vtkOversketchTunnel> tunnel;
  tunnel->SetCurvesConnection(treatment->GetOutputPort());
  vtkNew<vtkOversketchProjectTexture> texture;
  texture->SetInputConnection(tunnel->GetOutputPort());
  const struct
  {
    const char *holes, *tunnels;
    int chi;
  } cases[] = { { "", "", 2 }, { "1", "", 0 }, { "", "1 2", -2 }, { "1", "2", -2 } };
  for (const auto& each : cases)
  {
    treatment->SetHoles(each.holes);
    treatment->SetTunnels(each.tunnels);
    for (vtkAlgorithm* maker : { static_cast<vtkAlgorithm*>(inflate), static_cast<vtkAlgorithm*>(extrude) })
    {
      tunnel->SetInputConnection(maker->GetOutputPort());
      texture->Update();
      ASSERT_EQ(texture->GetErrorCode(), 0u);
      vtkPolyData* surface = texture->GetOutput();
      ASSERT_GT(surface->GetNumberOfPoints(), 1000);
      expectClosed(surface, each.chi);
      EXPECT_NE(surface->GetPointData()->GetTCoords(), nullptr);
      // Every rim lies on its stroke.
      const std::vector<double> kinds = valuesOf(surface->GetPointData(), "BoundaryKind"),
                                strokes = valuesOf(surface->GetPointData(), "StrokeId");
      const Vector2 centres[] = { { 512, 512 }, { 350, 512 }, { 700, 512 } };
      const double radii[] = { 400.0, 100.0, 110.0 };
      for (std::size_t i = 0; i < kinds.size(); ++i)
      {
        if (kinds[i] != 0.0)
        {
          const int stroke = static_cast<int>(strokes[i]);
          const Vector3 p(surface->GetPoint(static_cast<vtkIdType>(i)));
          EXPECT_NEAR((p.head<2>() - centres[stroke]).norm(), radii[stroke], 0.05);
        }
      }
    }
  }
  // Each case has other holes than the one before.
  EXPECT_EQ(inflate->GetRatioCount(), 4);
  EXPECT_EQ(inflate->GetThicknessCount(), 0);
}
