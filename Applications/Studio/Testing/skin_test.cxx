// Textures and colours in the window: shown, kept by a stroke, kept by files.
#include "document.h"
#include "main_window.h"
#include "mesh_file.h"
#include "models.h"
#include "mouse.h"
#include "picture_files.h"
#include "point_normals.h"
#include "texture.h"
#include "viewport.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace oversketch_files;
using namespace oversketch_studio;

namespace
{

using Pixel = std::array<unsigned char, 4>;

// 64 px square, of so many components a pixel.
vtkSmartPointer<vtkImageData> pictureOf(int components, const std::function<Pixel(int x, int y)>& at)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const Pixel pixel = at(x, y);
      std::copy_n(pixel.begin(), components, static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0)));
    }
  }
  return image;
}

std::string pngOf(vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetDataSize()) };
}

// A PNG, red on the left, green on the right.
std::string redAndGreen()
{
  return pngOf(pictureOf(3, [](int x, int) { return x < 32 ? Pixel{ 255, 0, 0 } : Pixel{ 0, 255, 0 }; }));
}

// A blue disc, cut out: nothing is under its rim but black, and its rim is half transparent and black as
// well.
vtkSmartPointer<vtkImageData> cutOut()
{
  return pictureOf(4,
    [](int x, int y)
    {
      const double far = std::hypot(x - 31.5, y - 31.5);
      return far < 20.0   ? Pixel{ 30, 60, 240, 255 }
             : far < 21.5 ? Pixel{ 10, 10, 10, 140 }
                          : Pixel{ 0, 0, 0, 0 };
    });
}

// Rectangles across z, each with corners of its own in the picture, in one mesh.
struct Card
{
  double half, z, picture[4]; // left, right, bottom, top
};
vtkSmartPointer<vtkPolyData> cards(const std::vector<Card>& all)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkFloatArray> places;
  places->SetName("TCoords");
  places->SetNumberOfComponents(2);
  for (const Card& card : all)
  {
    vtkIdType ids[4];
    for (int i = 0; i < 4; ++i)
    {
      const bool right = i == 1 || i == 2, top = i > 1;
      ids[i] = points->InsertNextPoint(right ? card.half : -card.half, top ? card.half : -card.half, card.z);
      places->InsertNextTuple2(card.picture[right ? 1 : 0], card.picture[top ? 3 : 2]);
    }
    faces->InsertNextCell(4, ids);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  mesh->GetPointData()->SetTCoords(places);
  return mesh;
}

// The view alone, on a mesh.
struct Seen
{
  Viewport view;
  std::vector<SharedPicture> held;

  explicit Seen(vtkPolyData* mesh)
    : held(decodedOf(mesh))
  {
    this->view.resize(240, 240);
    this->view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->view, 60000));
    this->view.showMesh(mesh, true);
  }
  QImage picture()
  {
    this->view.renderNow();
    return this->view.grabFramebuffer();
  }
  QColor middle() { return this->picture().pixelColor(120, 120); }
};

vtkSmartPointer<vtkPolyData> dog()
{
  Notes none;
  return readMesh(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", none);
}

struct Count
{
  int red = 0, green = 0, blue = 0;
};

// Pixels of the view in which one colour stands out, and where they are.
Count coloursOf(Viewport* view, const QString& path, std::array<double, 2>& middles)
{
  view->screenshot(path, false);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.toLocal8Bit().constData());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int* size = image->GetDimensions();
  Count count;
  middles = {};
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* p = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      if (p[0] > 2 * p[1] && p[0] > 2 * p[2] && p[0] > 60)
      {
        ++count.red;
        middles[0] += x;
      }
      else if (p[1] > 2 * p[0] && p[1] > 2 * p[2] && p[1] > 60)
      {
        ++count.green;
        middles[1] += x;
      }
      else if (p[2] > 2 * p[0] && p[2] > 2 * p[1] && p[2] > 60)
      {
        ++count.blue;
      }
    }
  }
  middles[0] /= std::max(1, count.red);
  middles[1] /= std::max(1, count.green);
  return count;
}

bool settles(Document* document)
{
  return QTest::qWaitFor([document] { return document->isSettled(); }, 600000);
}

} // namespace

TEST(Skin, APictureIsWornWithoutItsAlpha)
{
  const auto made = opaquePicture(cutOut());
  ASSERT_EQ(made->GetNumberOfScalarComponents(), 3);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const auto* p = static_cast<unsigned char*>(made->GetScalarPointer(x, y, 0));
      const bool isOfTheRim = std::hypot(x - 31.5, y - 31.5) < 30.0;
      ASSERT_TRUE(!isOfTheRim || (p[0] == 30 && p[1] == 60 && p[2] == 240)) << x << ", " << y;
    }
  }
  // Without anything opaque colours stay; a picture without alpha is itself; thin paint is no rim.
  const auto thin = opaquePicture(pictureOf(4,
    [](int x, int) {
      return Pixel{ 9, 8, static_cast<unsigned char>(x), 200 };
    }));
  EXPECT_EQ(static_cast<unsigned char*>(thin->GetScalarPointer(17, 3, 0))[2], 17);
  const auto whole = pictureOf(3, [](int, int) { return Pixel{ 1, 2, 3 }; });
  EXPECT_EQ(opaquePicture(whole), whole);
}

TEST(Skin, NothingIsSeenThroughAModel)
{
  // The disc's card is before one that shows a single blue pixel of it; of colours the first is half as
  // strong.
  const double shrunk = 0.5;
  const auto mesh =
    cards({ { 1.0, 0.0, { 0.0, 0.1, 0.0, 0.1 } }, { 2.0, -1.0, { shrunk, shrunk, shrunk, shrunk } } });
  setTexture(mesh,
    pngOf(pictureOf(4,
      [](int x, int) {
        return x < 16 ? Pixel{ 0, 0, 0, 0 } : x < 24 ? Pixel{ 30, 60, 240, 255 } : Pixel{ 240, 20, 20, 255 };
      })));
  Seen pictured(mesh);
  const QColor seen = pictured.middle();
  EXPECT_GT(seen.blue(), 2 * seen.red()) << seen.name().toStdString() << ": the red card behind is seen";

  const auto plain = cards({ { 1.0, 0.0, {} }, { 2.0, -1.0, {} } });
  plain->GetPointData()->SetTCoords(nullptr);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGBA");
  colours->SetNumberOfComponents(4);
  for (int i = 0; i < 8; ++i)
  {
    i < 4 ? colours->InsertNextTuple4(20, 40, 240, 40) : colours->InsertNextTuple4(240, 20, 20, 255);
  }
  plain->GetPointData()->SetScalars(colours);
  const QColor coloured = Seen(plain).middle();
  EXPECT_GT(coloured.blue(), 2 * coloured.red()) << coloured.name().toStdString();
}

TEST(Skin, APictureThatNobodyHasDecodedComesLater)
{
  const auto mesh = cards({ { 1.0, 0.0, { 0.0, 1.0, 0.0, 1.0 } } });
  const std::string bytes = pngOf(pictureOf(3, [](int, int) { return Pixel{ 20, 40, 200 }; }));
  setTexture(mesh, bytes);
  {
    Seen seen(mesh);
    seen.held.clear();
    seen.view.clearMesh();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !findDecoded(bytes); }, 60000)) << "who keeps it?";
    seen.view.showMesh(mesh, false);
    EXPECT_FALSE(findDecoded(bytes)) << "decoded on the window's thread";
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen.middle().blue() > 2 * seen.middle().red(); }, 60000));
  }
  EXPECT_FALSE(findDecoded(bytes));
}

// White paper: nothing of a ball is overexposed, and its form is seen; a black one's without it.
TEST(Skin, APictureHidesNoForm)
{
  const auto ball = withPointNormals(oversketch_test::toPolyData(oversketch_test::icosphere(4)));
  vtkNew<vtkFloatArray> places;
  places->SetName("TCoords");
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    places->InsertNextTuple2(0.5, 0.5);
  }
  ball->GetPointData()->SetTCoords(places);
  const auto greysOf = [](const QImage& picture)
  {
    std::vector<int> greys;
    for (int y = 60; y < 180; ++y)
    {
      for (int x = 60; x < 180; ++x)
      {
        greys.push_back(qGray(picture.pixel(x, y)));
      }
    }
    std::sort(greys.begin(), greys.end());
    return greys;
  };
  const auto dressed = [&](unsigned char grey)
  {
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(ball);
    setTexture(mesh, pngOf(pictureOf(3, [grey](int, int) { return Pixel{ grey, grey, grey }; })));
    return vtkSmartPointer<vtkPolyData>(mesh);
  };
  Seen white(dressed(255));
  const std::vector<int> onWhite = greysOf(white.picture());
  EXPECT_LT(onWhite[onWhite.size() * 98 / 100], 255) << "a fiftieth of it or more is overexposed";
  EXPECT_GT(onWhite[onWhite.size() / 2], 190) << "darker than the picture";
  EXPECT_LT(onWhite[onWhite.size() / 20] + 40, onWhite.back()) << "no form is seen";
  Seen black(dressed(0));
  const std::vector<int> onBlack = greysOf(black.picture());
  EXPECT_LT(onBlack[onBlack.size() / 2], 40);
  black.view.display().setShading(Shading::Smooth, false);
  const std::vector<int> bare = greysOf(black.picture());
  EXPECT_GT(bare[bare.size() / 2], 110);
  black.view.display().setShading(Shading::Matcap, true);
  const std::vector<int> clay = greysOf(black.picture());
  EXPECT_GT(clay[clay.size() / 2], 80);
}

TEST(Skin, ATextureIsShownAndSurvivesAStrokeAndFiles)
{
  const QTemporaryDir folder;
  const std::string picture = redAndGreen();
  const vtkSmartPointer<vtkPolyData> mesh = dog();
  double box[6];
  mesh->GetBounds(box);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    coordinates->InsertNextTuple2((p[0] - box[0]) / (box[1] - box[0]), (p[1] - box[2]) / (box[3] - box[2]));
  }
  mesh->GetPointData()->SetTCoords(coordinates);
  setTexture(mesh, picture);
  Notes notes;
  const QString first = folder.filePath("first.glb"), second = folder.filePath("second.glb");
  writeMesh(mesh, first.toStdString(), notes);

  MainWindow window;
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 60000));
  auto* view = window.findChild<Viewport*>();
  auto* document = window.findChild<Document*>();
  std::array<double, 2> middles{};
  window.openShippedModel();
  ASSERT_TRUE(settles(document));
  const Count plain = coloursOf(view, folder.filePath("plain.png"), middles);
  EXPECT_EQ(plain.red + plain.green + plain.blue, 0);

  ASSERT_TRUE(window.open(first));
  ASSERT_TRUE(settles(document));
  const Count opened = coloursOf(view, folder.filePath("opened.png"), middles);
  EXPECT_GT(opened.red, 10000);
  EXPECT_GT(opened.green, 10000);
  EXPECT_LT(middles[0] + 100.0, middles[1]) << "red is on the left";
  // A key shows the form alone, and the picture again.
  QApplication::setActiveWindow(&window);
  QTest::keyClick(view, Qt::Key_F);
  const Count bare = coloursOf(view, folder.filePath("bare.png"), middles);
  EXPECT_EQ(bare.red + bare.green, 0);
  QTest::keyClick(view, Qt::Key_F);

  const int width = view->width(), y = view->height() / 3;
  QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, { width / 4, y });
  for (int x = width / 4; x < 3 * width / 4; x += 12)
  {
    moveMouse(view, { x, y });
    QApplication::processEvents();
  }
  QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, { 3 * width / 4, y });
  ASSERT_TRUE(settles(document));
  ASSERT_EQ(document->session().nodes.size(), 1u);
  ASSERT_EQ(document->result().nodes[0].failure, "");
  const Count drawn = coloursOf(view, folder.filePath("drawn.png"), middles);
  EXPECT_GT(drawn.red, 10000);
  EXPECT_GT(drawn.green, 10000);

  notes.clear();
  writeMesh(document->shownMesh(), second.toStdString(), notes);
  for (const std::string& note : notes)
  {
    EXPECT_EQ(note.find("does not keep"), std::string::npos) << note;
  }
  notes.clear();
  const vtkSmartPointer<vtkPolyData> saved = readMesh(second.toStdString(), notes);
  EXPECT_EQ(textureOf(saved), picture);
  EXPECT_EQ(saved->GetNumberOfPoints(), document->result().mesh->GetNumberOfPoints());
  EXPECT_TRUE(notes.empty());

  // A session keeps it, too; a plain mesh afterwards wears none.
  const QString session = folder.filePath("dog.oversketch");
  document->save(session);
  window.openShippedModel();
  ASSERT_TRUE(settles(document));
  EXPECT_EQ(coloursOf(view, folder.filePath("plain.png"), middles).red, 0);
  ASSERT_TRUE(window.open(session));
  ASSERT_TRUE(settles(document));
  EXPECT_EQ(textureOf(document->result().mesh), picture);
  EXPECT_GT(coloursOf(view, folder.filePath("again.png"), middles).red, 10000);
  document->discardAutosave();
}

TEST(Skin, ColoursOfPointsAreShown)
{
  const QTemporaryDir folder;
  const vtkSmartPointer<vtkPolyData> mesh = dog();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple3(20, 20, 250);
  }
  mesh->GetPointData()->SetScalars(colours);
  const QString path = folder.filePath("blue.ply");
  Notes notes;
  writeMesh(mesh, path.toStdString(), notes);
  MainWindow window;
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 60000));
  auto* document = window.findChild<Document*>();
  ASSERT_TRUE(window.open(path));
  ASSERT_TRUE(settles(document));
  std::array<double, 2> middles{};
  EXPECT_GT(coloursOf(window.findChild<Viewport*>(), folder.filePath("blue.png"), middles).blue, 30000);
  document->discardAutosave();
}
