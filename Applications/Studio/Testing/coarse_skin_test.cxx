// The drawing of a large model while the hand moves, by a clock that the test turns: a coarser skin where
// the last frame of the whole one was late, and else the whole one.
#include "coarse_skin.h"
#include "display.h"
#include "mouse.h"
#include "point_normals.h"
#include "turning_normals.h"
#include "viewport.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch_studio;

namespace
{

constexpr vtkIdType most = 40000;          // triangles of what stands in
constexpr double soon = 10.0, late = 60.0; // ms of a frame

vtkSmartPointer<vtkPolyData> ring(int around)
{
  return oversketch_files::withPointNormals(
    oversketch_test::toPolyData(oversketch_test::torus(1.0, 0.4, around, 150)));
}

struct Turned
{
  Viewport view;
  double time = 0.0, frame = soon;
  vtkSmartPointer<vtkPolyData> drawn; // in the last frame
  const QPoint middle{ 120, 120 };
  int moves = 0;

  explicit Turned(vtkPolyData* mesh)
  {
    this->view.setClock([this] { return this->time += this->frame; });
    this->view.resize(240, 240);
    this->view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->view, 60000));
    this->view.renderer()->AddObserver(vtkCommand::EndEvent, this, &Turned::frameEnds);
    this->view.showMesh(mesh, true);
    this->rest();
  }
  ~Turned() { this->view.renderer()->RemoveObservers(vtkCommand::EndEvent); }

  // The largest mesh in it.
  void frameEnds()
  {
    this->drawn = nullptr;
    vtkActorCollection* actors = this->view.renderer()->GetActors();
    vtkCollectionSimpleIterator at;
    actors->InitTraversal(at);
    while (vtkActor* actor = actors->GetNextActor(at))
    {
      auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
      vtkPolyData* mesh = mapper && actor->GetVisibility() ? mapper->GetInput() : nullptr;
      if (mesh && (!this->drawn || mesh->GetNumberOfPolys() > this->drawn->GetNumberOfPolys()))
      {
        this->drawn = mesh;
      }
    }
  }
  vtkIdType triangles() const { return this->drawn ? this->drawn->GetNumberOfPolys() : -1; }
  bool isWhole() const { return this->triangles() == this->view.mesh()->GetNumberOfPolys(); }
  bool isCoarse() const { return this->triangles() <= most && this->triangles() > most / 4; }
  bool comesWhole()
  {
    return QTest::qWaitFor([this] { return this->isWhole(); }, 60000);
  }
  void rest()
  {
    const auto rests = [this]
    {
      const auto timers = this->view.findChildren<QTimer*>();
      return std::none_of(timers.begin(), timers.end(), [](QTimer* timer) { return timer->isActive(); });
    };
    QApplication::processEvents();
    EXPECT_TRUE(QTest::qWaitFor(rests, 60000));
  }
  void press() { QTest::mousePress(&this->view, Qt::MiddleButton, Qt::NoModifier, this->middle); }
  void release()
  {
    QTest::mouseRelease(
      &this->view, Qt::MiddleButton, Qt::NoModifier, this->middle + QPoint(3 * this->moves, 0));
  }
  void move()
  {
    moveMouse(&this->view, this->middle + QPoint(3 * ++this->moves, 0), Qt::MiddleButton);
    this->view.renderNow();
  }
  void turnWheel()
  {
    QWheelEvent notch(this->middle,
      this->view.mapToGlobal(this->middle),
      QPoint(),
      QPoint(0, 120),
      Qt::NoButton,
      Qt::NoModifier,
      Qt::NoScrollPhase,
      false);
    QApplication::sendEvent(&this->view, &notch);
    this->view.renderNow();
  }
  // A frame is late, and the view rests: what stands in is made.
  void beLate()
  {
    this->frame = late;
    this->view.renderNow();
    this->rest();
  }
};

} // namespace

TEST(CoarseSkin, StandsInWhereTheLastFrameWasLate)
{
  Turned turned(ring(400));
  turned.press();
  turned.move();
  EXPECT_TRUE(turned.isWhole()) << "no frame was late";
  turned.release();
  turned.beLate();
  EXPECT_TRUE(turned.isWhole());
  turned.press();
  turned.move();
  EXPECT_TRUE(turned.isCoarse()) << turned.triangles();
  turned.frame = soon;
  turned.move();
  EXPECT_TRUE(turned.isCoarse()) << "a coarse frame tells nothing of a whole one";
  EXPECT_TRUE(turned.comesWhole()) << "the hand rests, and holds it";
  turned.move();
  EXPECT_TRUE(turned.isCoarse()) << turned.triangles();
  turned.release();
  EXPECT_TRUE(turned.comesWhole());
  turned.view.renderNow(); // in time
  turned.press();
  turned.move();
  EXPECT_TRUE(turned.isWhole());
  turned.release();
}

TEST(CoarseSkin, AWheelHasItUntilItRestsOrTheHandDraws)
{
  Turned turned(ring(400));
  turned.beLate();
  turned.turnWheel();
  EXPECT_TRUE(turned.isCoarse()) << turned.triangles();
  EXPECT_TRUE(turned.comesWhole());
  turned.turnWheel();
  EXPECT_TRUE(turned.isCoarse()) << turned.triangles();
  QTest::mousePress(&turned.view, Qt::LeftButton, Qt::NoModifier, turned.middle);
  EXPECT_TRUE(turned.isWhole()) << "a pen would draw over it";
  QTest::mouseRelease(&turned.view, Qt::LeftButton, Qt::NoModifier, turned.middle);
}

TEST(CoarseSkin, AnotherMeshIsWhole)
{
  Turned turned(ring(400));
  turned.beLate();
  turned.press();
  turned.move();
  ASSERT_TRUE(turned.isCoarse()) << turned.triangles();
  turned.view.showMesh(ring(401), false);
  turned.move();
  EXPECT_TRUE(turned.isWhole()) << turned.triangles();
  turned.move();
  EXPECT_TRUE(turned.isCoarse()) << turned.triangles();
  turned.release();
  // A small one is whole however late it is.
  turned.view.showMesh(ring(300), false);
  turned.beLate();
  turned.press();
  turned.move();
  EXPECT_TRUE(turned.isWhole());
  turned.release();
}

TEST(CoarseSkin, APreviewIsFollowed)
{
  const auto mesh = ring(400);
  Turned turned(mesh);
  turned.beLate();
  turned.press();
  vtkNew<vtkPolyData> moved;
  copyToMove(mesh, moved);
  turned.view.showPreview(moved);
  for (const double by : { 0.1, 0.2 })
  {
    moved->GetPoints()->SetPoint(0, 0.0, 0.0, by);
    moved->GetPoints()->Modified();
    moved->Modified();
    turned.move();
    EXPECT_TRUE(turned.isCoarse()) << turned.triangles();
    EXPECT_EQ(turned.drawn->GetPoints(), moved->GetPoints());
    EXPECT_EQ(turned.drawn->GetPointData()->GetNormals(), moved->GetPointData()->GetNormals());
  }
  turned.view.showPreview(ring(401));
  turned.move();
  EXPECT_TRUE(turned.isWhole()) << "it has other triangles";
  turned.view.showPreview(mesh);
  turned.view.display().setShading(Shading::Wire, true);
  turned.move();
  EXPECT_TRUE(turned.isWhole()) << "its edges are seen";
  turned.release();
}

TEST(CoarseSkin, HasSoManyTrianglesOrIsNot)
{
  CoarseSkin skin;
  const auto mesh = ring(400);
  EXPECT_FALSE(skin.of(mesh));
  for (const vtkIdType bound : { 1000, 10000, 40000 })
  {
    skin.clear();
    skin.make(mesh, bound);
    ASSERT_TRUE(skin.of(mesh)) << bound;
    EXPECT_LE(skin.of(mesh)->GetNumberOfPolys(), bound);
    EXPECT_GT(4 * skin.of(mesh)->GetNumberOfPolys(), bound);
    EXPECT_EQ(skin.of(mesh)->GetPoints(), mesh->GetPoints());
  }
  // Squares in a plane; its points are not the ring's.
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(400, 300);
  plane->Update();
  vtkPolyData* squares = plane->GetOutput();
  EXPECT_FALSE(skin.of(squares));
  skin.make(squares, most);
  ASSERT_TRUE(skin.of(squares));
  EXPECT_LE(skin.of(squares)->GetNumberOfPolys(), most);
  EXPECT_FALSE(skin.of(mesh));
  // One point so far off that all others fall together.
  vtkNew<vtkPolyData> far;
  copyToMove(mesh, far);
  far->GetPoints()->SetPoint(0, 1e4, 0.0, 0.0);
  far->GetPoints()->Modified();
  skin.clear();
  skin.make(far, most);
  EXPECT_FALSE(skin.of(far));
  // Beside faces it has a line.
  vtkNew<vtkPolyData> lined;
  lined->ShallowCopy(mesh);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lined->SetLines(lines);
  skin.clear();
  skin.make(lined, most);
  EXPECT_FALSE(skin.of(lined));
}
