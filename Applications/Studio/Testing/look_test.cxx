// Lights and the shadow on the ground, on balls.
#include "point_normals.h"
#include "viewport.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <QImage>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

using namespace oversketch_studio;

namespace
{

constexpr int lookSide = 240; // px

vtkSmartPointer<vtkPolyData> lookBall()
{
  return oversketch_files::withPointNormals(oversketch_test::toPolyData(oversketch_test::icosphere(4)));
}

// A ball, white or as it is coloured, in a view of its own.
struct LookAt
{
  explicit LookAt(vtkPolyData* mesh)
  {
    this->view.resize(lookSide, lookSide);
    this->view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->view, 60000));
    this->view.setDark(false);
    this->view.display().setPlain({ 1.0, 1.0, 1.0 });
    this->view.showMesh(mesh, true);
  }
  QImage picture()
  {
    this->view.renderNow();
    return this->view.grabFramebuffer();
  }
  QImage lit(Light light)
  {
    this->view.display().setLight(light);
    return this->picture();
  }
  // From so many degrees above the ground, or below.
  QImage from(double degrees)
  {
    vtkCamera* camera = this->view.renderer()->GetActiveCamera();
    camera->Elevation(degrees);
    camera->OrthogonalizeViewUp();
    this->view.renderer()->ResetCameraClippingRange();
    const QImage made = this->picture();
    camera->Elevation(-degrees);
    camera->OrthogonalizeViewUp();
    return made;
  }
  // Where a place of the world is seen from there.
  QPoint placeFrom(double degrees, const std::array<double, 3>& place)
  {
    vtkCamera* camera = this->view.renderer()->GetActiveCamera();
    camera->Elevation(degrees);
    camera->OrthogonalizeViewUp();
    vtkRenderer* renderer = this->view.renderer();
    renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    const double ratio = this->view.devicePixelRatioF();
    const QPoint found(
      static_cast<int>(at[0] / ratio), this->view.height() - 1 - static_cast<int>(at[1] / ratio));
    camera->Elevation(-degrees);
    camera->OrthogonalizeViewUp();
    return found;
  }

  Viewport view;
};

// Within 50 px of the middle, well inside the ball.
template <typename See>
void overBall(const QImage& picture, const See& see)
{
  for (int y = -50; y <= 50; ++y)
  {
    for (int x = -50; x <= 50; ++x)
    {
      if (x * x + y * y <= 2500)
      {
        see(x, y, picture.pixel(picture.width() / 2 + x, picture.height() / 2 + y));
      }
    }
  }
}

int differingOverBall(const QImage& a, const QImage& b, int by)
{
  int found = 0;
  overBall(a,
    [&](int x, int y, QRgb pixel)
    {
      const QRgb other = b.pixel(b.width() / 2 + x, b.height() / 2 + y);
      found += std::abs(qRed(pixel) - qRed(other)) + std::abs(qGreen(pixel) - qGreen(other)) +
                 std::abs(qBlue(pixel) - qBlue(other)) >
               by;
    });
  return found;
}

// The mean grey of the ball's upper left quarter less that of its lower right one.
double lean(const QImage& picture)
{
  double sum = 0.0;
  int count = 0;
  overBall(picture,
    [&](int x, int y, QRgb pixel)
    {
      sum += x < 0 && y < 0 ? qGray(pixel) : x > 0 && y > 0 ? -qGray(pixel) : 0;
      count += x < 0 && y < 0;
    });
  return sum / count;
}

double shadeAt(const QImage& shaded, const QImage& bare, const QPoint& at)
{
  return double(qGray(shaded.pixel(at))) / qGray(bare.pixel(at));
}

} // namespace

TEST(Look, NoLightIsWhiterThanWhite)
{
  LookAt ball(lookBall());
  for (const Light light : { Light::Three, Light::Head, Light::Matcap })
  {
    SCOPED_TRACE(static_cast<int>(light));
    int all = 0, clipped = 0, darkest = 255, brightest = 0;
    overBall(ball.lit(light),
      [&](int, int, QRgb pixel)
      {
        ++all;
        clipped += (pixel & 0xffffffU) == 0xffffffU;
        darkest = std::min(darkest, qGray(pixel));
        brightest = std::max(brightest, qGray(pixel));
      });
    EXPECT_LT(clipped, all / 100);
    EXPECT_GT(brightest, 200) << "white is not grey";
    EXPECT_GT(brightest, darkest + 40) << "no form is seen";
  }
}

TEST(Look, EachLightComesFromWhereItSays)
{
  LookAt ball(lookBall());
  EXPECT_NEAR(lean(ball.lit(Light::Head)), 0.0, 3.0) << "the same all round";
  EXPECT_GT(lean(ball.lit(Light::Matcap)), 30.0);
  const QImage three = ball.lit(Light::Three), plaster = ball.lit(Light::Matcap);
  EXPECT_GT(differingOverBall(three, plaster, 24), 2000);
  // The upper side of the key light is the picture's, whatever the camera's; so is that of the matcap.
  for (const Light light : { Light::Three, Light::Matcap })
  {
    const QImage upright = ball.lit(light);
    ball.view.renderer()->GetActiveCamera()->Roll(90.0);
    EXPECT_LT(differingOverBall(ball.picture(), upright, 24), 80) << static_cast<int>(light);
    ball.view.renderer()->GetActiveCamera()->Roll(-90.0);
  }
}

TEST(Look, AMatcapDependsOnHowTheSurfaceFacesAlone)
{
  LookAt ball(lookBall());
  const QImage plaster = ball.lit(Light::Matcap);
  // From any side, turned inside out, by flat faces, without lights.
  ball.view.renderer()->GetActiveCamera()->Azimuth(77.0);
  EXPECT_LT(differingOverBall(ball.picture(), plaster, 24), 80);
  ball.view.display().setShading(Shading::Flat, true);
  EXPECT_LT(differingOverBall(ball.picture(), plaster, 60), 80);
  ball.view.display().setShading(Shading::Smooth, true);
  ball.view.renderer()->RemoveAllLights();
  EXPECT_LT(differingOverBall(ball.picture(), plaster, 24), 80);
  const auto inside = lookBall();
  inside->GetPointData()->Initialize();
  for (vtkIdType face = 0; face < inside->GetNumberOfPolys(); ++face)
  {
    inside->GetPolys()->ReverseCellAtId(face);
  }
  LookAt turned(oversketch_files::withPointNormals(inside));
  EXPECT_LT(differingOverBall(turned.lit(Light::Matcap), plaster, 60), 80);
}

TEST(Look, AMatcapLeavesColours)
{
  const auto mesh = lookBall();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple3(220, 20, 20);
  }
  mesh->GetPointData()->SetScalars(colours);
  LookAt ball(mesh);
  int red = 0, all = 0;
  overBall(ball.lit(Light::Matcap),
    [&](int, int, QRgb pixel)
    {
      ++all;
      red += qRed(pixel) > 3 * qGreen(pixel) && qRed(pixel) > 3 * qBlue(pixel);
    });
  EXPECT_EQ(red, all);
}

TEST(Look, AShadowLiesOnTheGroundUnderTheModel)
{
  LookAt ball(lookBall());
  const QImage bare = ball.from(30.0), bareBelow = ball.from(-30.0);
  ball.view.display().setShadow(true);
  const QImage shaded = ball.from(30.0), below = ball.from(-30.0);
  const std::array<double, 3> under{ 0.0, -1.0, 0.8 }, beside{ 1.3, -1.0, 1.3 };
  const QPoint at = ball.placeFrom(30.0, under), off = ball.placeFrom(30.0, beside),
               atBelow = ball.placeFrom(-30.0, under);
  ASSERT_TRUE(bare.rect().contains(at) && bare.rect().contains(off) && bare.rect().contains(atBelow));
  EXPECT_LT(shadeAt(shaded, bare, at), 0.8);
  EXPECT_NEAR(shadeAt(shaded, bare, off), 1.0, 0.02);
  // The model is over its shadow; from below the shadow is faint.
  EXPECT_LT(differingOverBall(shaded, bare, 24), 80);
  EXPECT_GT(shadeAt(below, bareBelow, atBelow), shadeAt(shaded, bare, at) + 0.1);
  EXPECT_LT(shadeAt(below, bareBelow, atBelow), 0.97);
  // A hidden model throws none.
  ball.view.hideParts({ -1 });
  const QImage empty = ball.from(30.0);
  ball.view.display().setShadow(false);
  EXPECT_TRUE(ball.from(30.0) == empty);
}

TEST(Look, AShadowFollowsWhatIsShown)
{
  LookAt ball(lookBall());
  ball.view.display().setShadow(true);
  const QImage shaded = ball.from(30.0);
  const QPoint at = ball.placeFrom(30.0, { 0.0, -1.0, 0.8 });
  const auto away = lookBall();
  for (vtkIdType i = 0; i < away->GetNumberOfPoints(); ++i)
  {
    double place[3];
    away->GetPoint(i, place);
    away->GetPoints()->SetPoint(i, place[0], place[1], place[2] - 40.0);
  }
  away->Modified();
  ball.view.showPreview(away);
  EXPECT_GT(qGray(ball.from(30.0).pixel(at)), qGray(shaded.pixel(at)) + 25);
}

TEST(Look, AShadowFollowsTheUpAxis)
{
  LookAt ball(lookBall());
  ball.view.setUpAxis(2, true);
  const QImage bare = ball.from(30.0);
  ball.view.display().setShadow(true);
  const QImage shaded = ball.from(30.0);
  EXPECT_LT(shadeAt(shaded, bare, ball.placeFrom(30.0, { 0.0, -0.8, -1.0 })), 0.8);
  // Home shows the ball as large as without it.
  vtkCamera* camera = ball.view.renderer()->GetActiveCamera();
  ball.view.fitAll();
  const double with = camera->GetDistance();
  ball.view.display().setShadow(false);
  ball.picture();
  ball.view.fitAll();
  EXPECT_NEAR(camera->GetDistance(), with, 1e-9 * with);
}
