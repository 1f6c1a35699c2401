// Textures and colours in the window: shown, kept by a stroke, kept by files.
#include "document.h"
#include "main_window.h"
#include "mesh_file.h"
#include "mouse.h"
#include "texture.h"
#include "viewport.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <array>
#include <string>

using namespace oversketch_files;
using namespace oversketch_studio;

namespace
{

// A PNG, red on the left, green on the right.
std::string redAndGreen()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = x < 32 ? 255 : 0;
      pixel[1] = x < 32 ? 0 : 255;
      pixel[2] = 0;
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetDataSize()) };
}

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
