// Which way up models are, and a camera that goes by it.
#include "main_window.h"
#include "mesh_file.h"
#include "up_axis.h"
#include "viewport.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace oversketch_studio;

namespace
{

vtkSmartPointer<vtkPolyData> model(const std::string& name)
{
  oversketch_files::Notes none;
  return oversketch_files::readMesh(OVERSKETCH_DATA_FOLDER "/Models/" + name + ".ply", none);
}

// As a program writes it in which z is up: its front is that of -y.
vtkSmartPointer<vtkPolyData> onItsBack(vtkPolyData* mesh)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->DeepCopy(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double at[3];
    mesh->GetPoint(i, at);
    made->GetPoints()->SetPoint(i, at[0], -at[2], at[1]);
  }
  made->GetPoints()->Modified();
  return made;
}

} // namespace

TEST(UpAxis, IsToldByWhatAModelStandsOn)
{
  for (const char* name : { "bear", "dinosaur", "dog", "octopus", "person" })
  {
    const auto mesh = model(name);
    EXPECT_EQ(upAxisOf(mesh), 1) << name;
    EXPECT_EQ(upAxisOf(onItsBack(mesh)), 2) << name;
  }
  EXPECT_EQ(upAxisOf(model("hand")), 1) << "it stands on nothing else";
  vtkNew<vtkPolyData> none;
  EXPECT_EQ(upAxisOf(none), 1);
}

TEST(UpAxis, IsTheCameras)
{
  Viewport view;
  view.resize(200, 200);
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view, 60000));
  view.setUpAxis(2, false);
  view.showMesh(onItsBack(model("dog")), true);
  vtkCamera* camera = view.renderer()->GetActiveCamera();
  const auto direction = [&](int axis) { return camera->GetDirectionOfProjection()[axis]; };
  EXPECT_NEAR(direction(1), 1.0, 1e-9) << "from the front";
  EXPECT_NEAR(camera->GetViewUp()[2], 1.0, 1e-9);
  // A drag to the side turns about z, and tilts nothing.
  view.camera()->SetOrbitToTurntable();
  view.camera()->TurnBy(37.0, 0.0);
  EXPECT_NEAR(direction(2), 0.0, 1e-9);
  EXPECT_NEAR(camera->GetViewUp()[2], 1.0, 1e-9);
  EXPECT_GT(std::abs(direction(0)), 0.1);
  view.camera()->LookFromSide(2, false);
  EXPECT_NEAR(direction(2), -1.0, 1e-9);
  EXPECT_NEAR(camera->GetViewUp()[1], 1.0, 1e-9) << "the front is at the bottom";
}

// Also one that was last on a larger screen.
TEST(UpAxis, AWindowIsWholeOnTheScreen)
{
  QSettings settings;
  const QVariant before = settings.value("geometry");
  QMainWindow large;
  large.setGeometry(300, 200, 5000, 4000);
  settings.setValue("geometry", large.saveGeometry());
  const MainWindow window;
  settings.setValue("geometry", before);
  EXPECT_TRUE(window.screen()->availableGeometry().contains(window.geometry()))
    << window.geometry().width() << " x " << window.geometry().height();
}
