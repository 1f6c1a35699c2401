// Bodies in front of each other and behind, through the whole of system C.
#include "DrawingRuns.h"

#include "Harness/bits.h"
#include "vtkOversketchArrays.h"
#include "vtkOversketchInflate.h"
#include "vtkOversketchPlanarRefine.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"

#include <map>
#include <tuple>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Strokes with what they say of their bodies, where they say anything.
vtkSmartPointer<vtkPolyData> layered(const std::vector<Line>& lines,
  const std::vector<int>& depths,
  const std::vector<double>& heights = {},
  const std::vector<int>& sections = {})
{
  const auto strokes = drawn(lines);
  strokes->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Depth", depths));
  if (!heights.empty())
  {
    strokes->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("Height", heights));
  }
  if (!sections.empty())
  {
    strokes->GetCellData()->AddArray(ArrayOf<vtkIntArray>("CrossSection", sections));
  }
  return strokes;
}

// The faces of a layer, as they are in the mesh; of two copies the front one, 0, or the back one, 1.
vtkSmartPointer<vtkPolyData> bodyOf(vtkPolyData* mesh, int layer, int copy = -1)
{
  vtkDataArray* ids = mesh->GetCellData()->GetArray("LayerId");
  std::vector<vtkIdType> faces;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    if (ids->GetComponent(f, 0) == layer)
    {
      faces.push_back(f);
    }
  }
  const Corners corners = cornersOf(mesh);
  const std::size_t from = copy == 1 ? faces.size() / 2 : 0;
  const std::size_t to = copy == 0 ? faces.size() / 2 : faces.size();
  std::map<vtkIdType, vtkIdType> numbers;
  for (std::size_t i = from; i < to; ++i)
  {
    for (const vtkIdType id : corners[static_cast<std::size_t>(faces[i])])
    {
      numbers[id] = 0;
    }
  }
  auto body = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (auto& [id, number] : numbers)
  {
    number = points->InsertNextPoint(mesh->GetPoint(id));
  }
  vtkNew<vtkCellArray> polys;
  for (std::size_t i = from; i < to; ++i)
  {
    const std::vector<vtkIdType>& face = corners[static_cast<std::size_t>(faces[i])];
    polys->InsertNextCell(static_cast<int>(face.size()));
    for (const vtkIdType id : face)
    {
      polys->InsertCellPoint(numbers[id]);
    }
  }
  body->SetPoints(points);
  body->SetPolys(polys);
  return body;
}

double middleOf(vtkPolyData* body)
{
  const auto box = boxOf(body);
  return 0.5 * (box[4] + box[5]);
}

// The mean over a disc of the height of a sphere about its middle.
double meanHeight(double sphere, double disc)
{
  const double cap = std::pow(sphere * sphere - disc * disc, 1.5);
  return 2.0 / 3.0 * (std::pow(sphere, 3) - cap) / (disc * disc);
}

vtkIdType inflations(vtkOversketchInflateDrawing* system)
{
  return vtkOversketchInflate::SafeDownCast(system->GetStep("Inflate"))->GetInflateCount() +
         vtkOversketchPlanarRefine::SafeDownCast(system->GetStep("Refine"))->GetRefineCount();
}

const Line body = circle(400, 300, 200), limb = circle(430, 320, 60);

} // namespace

TEST(LayeredDrawing, ALayerLiesOnWhatIsSeenUnderIt)
{
  System plain(drawn({ body })), alone(drawn({ circle(400, 300, 60) })), other(drawn({ limb }));
  System both(layered({ body, circle(400, 300, 60) }, { 0, 1 }));
  vtkPolyData* mesh = both.mesh();
  EXPECT_TRUE(identical(bodyOf(mesh, 0), plain.mesh())) << "what lies in the plane is as it is alone";
  const auto front = bodyOf(mesh, 1);
  const double z = middleOf(front), height = meanHeight(boxOf(plain.mesh())[5], 60.0);
  EXPECT_NEAR(z, height, 0.01 * height) << "the mean height of a ball under a disc";
  // Moved along z and nothing else.
  vtkPolyData* single = alone.mesh();
  ASSERT_EQ(cornersOf(front), cornersOf(single));
  for (vtkIdType i = 0; i < front->GetNumberOfPoints(); ++i)
  {
    const Vector3 a(front->GetPoint(i)), b(single->GetPoint(i));
    EXPECT_EQ(a.head<2>(), b.head<2>());
    EXPECT_EQ(a[2], b[2] + z);
  }
  EXPECT_NEAR(volumeOf(mesh), volumeOf(plain.mesh()) + volumeOf(single), 1e-9 * volumeOf(mesh));
  EXPECT_EQ(mesh->GetCellData()->GetArray("PartId"), nullptr);
  EXPECT_NE(mesh->GetPointData()->GetTCoords(), nullptr);
  EXPECT_NE(mesh->GetFieldData()->GetArray("Canvas"), nullptr);
  EXPECT_EQ(mesh->GetFieldData()->GetArray("Placement"), nullptr);
  // Parameters say the same as the array, and go before it.
  for (const int depth : { 0, 2 })
  {
    System named(layered({ body, circle(400, 300, 60) }, { 0, depth }));
    named.filter->SetInFront("1");
    expectSameBits(named.mesh(), mesh);
  }
}

TEST(LayeredDrawing, ALimbAndItsTwinAreMirrorImages)
{
  System system(layered({ body, limb }, { 0, 3 })), behind(layered({ body, limb }, { 0, 2 }));
  vtkPolyData* mesh = system.mesh();
  const auto front = bodyOf(mesh, 1, 0), back = bodyOf(mesh, 1, 1);
  ASSERT_EQ(front->GetNumberOfPoints(), back->GetNumberOfPoints());
  EXPECT_GT(middleOf(front), 100.0);
  using Faces = std::vector<std::vector<std::tuple<double, double, double>>>;
  const auto facesOf = [](vtkPolyData* of, double sign)
  {
    Faces faces;
    for (std::vector<vtkIdType> face : cornersOf(of))
    {
      std::vector<std::tuple<double, double, double>> places;
      for (const vtkIdType id : face)
      {
        const Vector3 p(of->GetPoint(id));
        places.emplace_back(p[0], p[1], sign * p[2]);
      }
      if (sign < 0.0)
      {
        std::reverse(places.begin(), places.end());
      }
      std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
      faces.push_back(places);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  };
  EXPECT_TRUE(facesOf(front, 1.0) == facesOf(back, -1.0)) << "to the bit";
  EXPECT_TRUE(facesOf(bodyOf(behind.mesh(), 1), 1.0) == facesOf(back, 1.0)) << "one behind is the twin alone";
}

TEST(LayeredDrawing, OrderIsThatOfStrokes)
{
  // Beside the middle of a limb lies another: later ones lie further out.
  const Line spot = circle(430, 320, 20);
  System system(layered({ body, limb, spot }, { 0, 1, 1 })),
    turned(layered({ body, spot, limb }, { 0, 1, 1 }));
  const double onLimb = middleOf(bodyOf(system.mesh(), 2)), onBody = middleOf(bodyOf(turned.mesh(), 1));
  const auto top = bodyOf(system.mesh(), 1);
  EXPECT_NEAR(onLimb, middleOf(top) + meanHeight(boxOf(top)[5] - middleOf(top), 20.0), 0.01 * onLimb);
  EXPECT_LT(onBody, middleOf(top) + 5.0);
  // Where nothing lies in the plane the first one does; a number of the layer is that of its stroke's order.
  System none(layered({ limb, spot }, { 3, 2 }));
  vtkPolyData* mesh = none.mesh();
  EXPECT_EQ(topologyOf(mesh).pieces, 2);
  EXPECT_EQ(middleOf(bodyOf(mesh, 1)), 0.0);
  EXPECT_LT(middleOf(bodyOf(mesh, 2)), -50.0);
}

TEST(LayeredDrawing, StrokesFollowTheLayerThatTheyLieIn)
{
  const Line line{ { { 400, 320 }, { 430, 325 }, { 460, 320 } }, false };
  const Line hole = circle(430, 350, 12);
  // Drawn before the limb the line is the body's, after it the limb's.
  System before(layered({ body, line, limb, hole }, { 0, 0, 1, 0 })),
    after(layered({ body, limb, line, hole }, { 0, 1, 0, 0 }));
  before.filter->SetHoles("3");
  after.filter->SetTunnels("3");
  EXPECT_EQ(topologyOf(bodyOf(before.mesh(), 1)).chi, 0) << "its hole goes through the limb alone";
  EXPECT_EQ(topologyOf(bodyOf(after.mesh(), 1)).chi, 0);
  EXPECT_EQ(topologyOf(bodyOf(after.mesh(), 0)).chi, 2);
  const auto strokesIn = [](vtkPolyData* mesh, int layer)
  {
    std::set<int> strokes;
    vtkDataArray *layers = mesh->GetCellData()->GetArray("LayerId"),
                 *ids = mesh->GetPointData()->GetArray("StrokeId");
    const Corners corners = cornersOf(mesh);
    for (std::size_t f = 0; f < corners.size(); ++f)
    {
      for (const vtkIdType id : corners[f])
      {
        if (layers->GetComponent(static_cast<vtkIdType>(f), 0) == layer)
        {
          strokes.insert(static_cast<int>(ids->GetComponent(id, 0)));
        }
      }
    }
    strokes.erase(-1);
    return strokes;
  };
  EXPECT_EQ(strokesIn(before.mesh(), 0), (std::set<int>{ 0, 1 }));
  EXPECT_EQ(strokesIn(before.mesh(), 1), (std::set<int>{ 2, 3 }));
  EXPECT_EQ(strokesIn(after.mesh(), 0), (std::set<int>{ 0 }));
  EXPECT_EQ(strokesIn(after.mesh(), 1), (std::set<int>{ 1, 2, 3 }));
  EXPECT_EQ(std::get<std::vector<std::string>>(after.filter->Figures()[0].second).size(), 4u);
}

TEST(LayeredDrawing, HeightAndCrossSectionAreALines)
{
  const auto lines = std::vector<Line>{ body, limb, circle(100, 100, 60) };
  System plain(layered(lines, { 0, 1, 0 })), own(layered(lines, { 0, 1, 0 }, { 0.0, 2.0, 0.5 }, { 0, 0, 2 }));
  const auto tall = boxOf(bodyOf(own.mesh(), 1)), was = boxOf(bodyOf(plain.mesh(), 1));
  EXPECT_NEAR(tall[5] - tall[4], 2.0 * (was[5] - was[4]), 1e-9);
  EXPECT_EQ(topologyOf(bodyOf(plain.mesh(), 0)).pieces, 2) << "in the plane, made with the rest of it";
  System cone(drawn({ lines[2] }));
  cone.filter->SetProfile("linear");
  cone.filter->SetHeight(0.5);
  EXPECT_TRUE(identical(bodyOf(own.mesh(), 2), cone.mesh())) << "not moved";
  own.filter->SetHeight(3.0);
  const auto taller = boxOf(bodyOf(own.mesh(), 1));
  EXPECT_NEAR(taller[5] - taller[4], 3.0 * (tall[5] - tall[4]), 1e-9) << "the drawing's factor, too";
  own.filter->SetExtrudeDepth(10.0);
  const auto slab = boxOf(bodyOf(own.mesh(), 1));
  EXPECT_NEAR(slab[5] - slab[4], 40.0, 1e-9);
}

TEST(LayeredDrawing, EveryValueActsOnLayers)
{
  System system(layered({ body, limb }, { 0, 1 }));
  const auto facesOf = [&](int layer) { return bodyOf(system.mesh(), layer)->GetNumberOfPolys(); };
  const vtkIdType faces = facesOf(1);
  system.filter->SetLevels(2);
  EXPECT_EQ(4 * facesOf(1), faces);
  system.filter->SetLevels(0);
  const vtkIdType coarse = facesOf(1);
  system.step<vtkOversketchPlanarRefine>("Refine")->SetLevelsFromSketch(true);
  EXPECT_GE(facesOf(1), 4 * coarse);
  system.step<vtkOversketchPlanarRefine>("Refine")->SetLevelsFromSketch(false);
  system.filter->SetLevels(1);
  system.filter->SetQuads(true);
  for (const std::vector<vtkIdType>& face : cornersOf(system.mesh()))
  {
    ASSERT_EQ(face.size(), 4u);
  }
  EXPECT_TRUE(topologyOf(system.filter->GetOutput()).closed);
  // A picture of the back is worn by the backs of all, as parts 0 and 1.
  const auto image = picture(800, 600, 1, [](int, int, int) { return 99; });
  system.filter->SetInputData(1, image);
  system.filter->SetInputData(2, image);
  vtkPolyData* mesh = system.mesh();
  vtkDataArray *parts = mesh->GetCellData()->GetArray("PartId"),
               *sides = mesh->GetCellData()->GetArray("Side");
  ASSERT_NE(parts, nullptr);
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    ASSERT_EQ(parts->GetComponent(f, 0), sides->GetComponent(f, 0) < 0.0 ? 1.0 : 0.0);
  }
}

TEST(LayeredDrawing, WhatLiesOverNothingStaysAndIsSaid)
{
  for (const int depth : { 1, 2, 3 })
  {
    System system(layered({ body, circle(90, 90, 50) }, { 0, depth }));
    Ear ear(system.filter);
    system.filter->Update();
    ASSERT_EQ(ear.warnings.size(), 1u);
    EXPECT_NE(ear.warnings[0].find("Stroke 1 lies over nothing"), std::string::npos) << ear.warnings[0];
    EXPECT_EQ(topologyOf(system.filter->GetOutput()).pieces, 2);
    EXPECT_EQ(middleOf(bodyOf(system.filter->GetOutput(), 1)), 0.0);
  }
}

TEST(LayeredDrawing, MessagesNameStrokesByTheirNumbersInTheDrawing)
{
  const Line stray{ { { 20, 20 }, { 60, 30 } }, false }, loose{ { { 700, 20 }, { 760, 40 } }, false };
  const Line dot = circle(430, 320, 1);
  System system(layered({ body, limb, stray, loose, dot }, { 0, 1, 0, 0, 1 }));
  Ear ear(system.filter);
  EXPECT_EQ(topologyOf(system.mesh()).pieces, 2) << "a body that is too small is left out";
  ASSERT_EQ(ear.warnings.size(), 3u);
  for (const char* words :
    { "Stroke 2 is open", "Stroke 3 is open", "Stroke 4 is closed round less than 9 px" })
  {
    EXPECT_TRUE(std::any_of(ear.warnings.begin(),
      ear.warnings.end(),
      [&](const std::string& text) { return text.find(words) != std::string::npos; }))
      << words;
  }
  const std::vector<Line> lines{ body, stray, limb, circle(420, 320, 30), circle(440, 320, 30) };
  System crossing(layered(lines, { 0, 0, 1, 0, 0 }));
  expectRefusal(crossing.filter, Failure::BadStroke, "Stroke 3 crosses stroke 4 near");
  System refused(layered({ body, limb, stray }, { 0, 1, 0 }));
  refused.filter->SetHoles("1");
  expectRefusal(refused.filter, Failure::BadStroke, "Holes names stroke 1, which is no closed stroke inside");
  refused.filter->SetHoles("3");
  expectRefusal(refused.filter, Failure::BadStroke, "Holes names stroke 3, but there are 3, numbered from 0");
  refused.filter->SetHoles("");
  refused.filter->SetBehind("7");
  expectRefusal(refused.filter, Failure::BadStroke, "Behind names stroke 7, but there are 3");
  refused.filter->SetBehind("2");
  expectRefusal(refused.filter, Failure::BadStroke, "Behind names stroke 2, which is open");
  refused.filter->SetBehind("x");
  expectRefusal(refused.filter, Failure::BadStroke, "Behind is \"x\"");
  for (const auto& bad : { layered({ body }, { 4 }),
         layered({ body }, { 0 }, { -1.0 }),
         layered({ body }, { 0 }, { std::nan("") }),
         layered({ body }, { 0 }, {}, { 9 }) })
  {
    refused.filter->SetBehind("");
    refused.filter->SetInputData(0, bad);
    expectRefusal(refused.filter, Failure::BadStroke, "of stroke 0 is none");
  }
}

TEST(LayeredDrawing, ADrawingInThePlaneIsAsItWas)
{
  System plain(drawn({ body, limb })), said(layered({ body, limb }, { 0, 0 }, { 0.0, 0.0 }, { 0, 0 }));
  expectSameBits(said.mesh(), plain.mesh());
  EXPECT_EQ(said.mesh()->GetCellData()->GetArray("LayerId"), nullptr);
  EXPECT_EQ(said.filter->GetLayer(1), nullptr);
  EXPECT_EQ(said.filter->GetStageTime("Layers"), 0.0);
  EXPECT_EQ(inflations(said.filter), inflations(plain.filter));
  // It becomes layers and a plain drawing again.
  said.filter->SetInFront("1");
  EXPECT_EQ(topologyOf(said.mesh()).pieces, 2);
  said.filter->SetInFront("");
  expectSameBits(said.mesh(), plain.mesh());
}

TEST(LayeredDrawing, OnlyTheLayerThatChangesRuns)
{
  const Line spot = circle(340, 240, 40);
  System system(layered({ body, limb, spot }, { 0, 1, 2 }));
  const auto counts = [&]
  {
    return std::array<vtkIdType, 3>{ inflations(system.filter),
      inflations(system.filter->GetLayer(1)),
      inflations(system.filter->GetLayer(2)) };
  };
  system.mesh();
  const auto first = counts();
  system.filter->SetInputData(0, layered({ body, limb, circle(340, 240, 42) }, { 0, 1, 2 }));
  system.mesh();
  const auto second = counts();
  EXPECT_EQ(second[0], first[0]);
  EXPECT_EQ(second[1], first[1]);
  EXPECT_GT(second[2], first[2]);
  // Another order, another side: nothing is made anew.
  system.filter->SetInputData(0, layered({ body, circle(340, 240, 42), limb }, { 0, 3, 1 }));
  vtkNew<vtkPolyData> warm;
  warm->DeepCopy(system.mesh());
  auto third = counts();
  std::swap(third[1], third[2]);
  EXPECT_EQ(third, second);
  System cold(layered({ body, circle(340, 240, 42), limb }, { 0, 3, 1 }));
  for (const int layer : { 0, 1, 2 })
  {
    EXPECT_TRUE(identical(bodyOf(cold.mesh(), layer), bodyOf(warm, layer))) << layer;
  }
  expectSameBits(cold.mesh(), warm);
  const vtkMTimeType time = system.filter->GetOutput()->GetMTime();
  system.filter->Update();
  EXPECT_EQ(system.filter->GetOutput()->GetMTime(), time) << "nothing has changed";
}

TEST(LayeredDrawing, SameBitsForAnyThreads)
{
  const auto strokes = layered({ body, limb, circle(340, 240, 42) }, { 0, 3, 2 }, { 0.0, 1.5, 0.0 });
  vtkNew<vtkPolyData> alone;
  vtkSMPTools::Initialize(1);
  alone->DeepCopy(System(strokes).mesh());
  vtkSMPTools::Initialize(2);
  System system(strokes);
  expectSameBits(system.mesh(), alone);
  vtkSMPTools::Initialize();
}
