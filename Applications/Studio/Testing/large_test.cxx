// A model of more triangles than the hand can wait for: drawn on by a proxy, exported whole.
#include "large_models.h"
#include "mesh_file.h"
#include "models.h"
#include "scene.h"
#include "session_file.h"
#include "systems.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QTemporaryDir>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

// A surface of four times as many triangles, the same shape.
vtkSmartPointer<vtkPolyData> quartered(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->DeepCopy(mesh->GetPoints());
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
  const auto middle = [&](vtkIdType a, vtkIdType b)
  {
    const auto [at, isNew] = middles.emplace(std::minmax(a, b), points->GetNumberOfPoints());
    if (isNew)
    {
      double p[3], q[3];
      points->GetPoint(a, p);
      points->GetPoint(b, q);
      points->InsertNextPoint(0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]));
    }
    return at->second;
  };
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    const vtkIdType a = ids->GetId(0), b = ids->GetId(1), c = ids->GetId(2);
    const vtkIdType ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& [p, q, r] :
      { std::tuple(a, ab, ca), std::tuple(b, bc, ab), std::tuple(c, ca, bc), std::tuple(ab, bc, ca) })
    {
      triangles->InsertNextCell({ p, q, r });
    }
  }
  auto fine = vtkSmartPointer<vtkPolyData>::New();
  fine->SetPoints(points);
  fine->SetPolys(triangles);
  return fine;
}

// The window on a dog of some 106,000 triangles, which are too many.
struct LargeDog : Scene
{
  LargeDog()
    : Scene(wholeWindow)
    , large(this->window.findChild<LargeModels*>())
    , advice(this->window.findChild<QLabel*>("advice"))
    , file(this->folder.filePath("large.vtp"))
  {
    oversketch_files::Notes notes;
    oversketch_files::writeMesh(quartered(this->document->result().mesh), this->file.toStdString(), notes);
    this->large->setMost(100'000);
    EXPECT_TRUE(this->window.open(this->file));
    this->wait();
    QApplication::setActiveWindow(&this->window);
  }

  const Session& session() const { return this->document->session(); }
  void stroke()
  {
    this->draw();
    this->release();
    QApplication::processEvents();
    this->wait();
  }
  bool isMadeAtLast()
  {
    return QTest::qWaitFor([this] { return this->large->resultAt(0)->isMade(); }, 600000);
  }
  // Chooses the menu's entry, and reads what it wrote.
  vtkSmartPointer<vtkPolyData> exported(const QString& name)
  {
    const QString path = this->folder.filePath(name);
    QTimer timer;
    QObject::connect(&timer,
      &QTimer::timeout,
      [path]
      {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget()))
        {
          dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
          static_cast<QDialog*>(dialog)->accept();
        }
      });
    timer.start(20);
    this->action("&Export mesh…")->trigger();
    oversketch_files::Notes notes;
    return oversketch_files::readMesh(path.toStdString(), notes);
  }

  QTemporaryDir folder;
  LargeModels* large;
  QLabel* advice;
  QString file;
};

bool staysAt(vtkPolyData* a, vtkPolyData* b, vtkIdType point)
{
  double p[3], q[3];
  a->GetPoint(point, p);
  b->GetPoint(point, q);
  return std::memcmp(p, q, sizeof p) == 0;
}

} // namespace

TEST(Large, IsDrawnOnByAProxyAndExportedWhole)
{
  LargeDog dog;
  const SharedData whole = dog.session().whole;
  ASSERT_TRUE(whole);
  const vtkIdType all = whole->GetNumberOfPolys(), shown = dog.session().mesh->GetNumberOfPolys();
  EXPECT_GT(shown, 4000);
  EXPECT_LT(shown, 9000);
  EXPECT_EQ(dog.view->mesh()->GetNumberOfPolys(), shown);
  const auto words = [](vtkIdType count) { return QLocale().toString(static_cast<qlonglong>(count)); };
  EXPECT_EQ(dog.window.findChild<QLabel*>("triangles")->toolTip(),
    "shown by " + words(shown) + " of " + words(all) + " triangles");
  EXPECT_TRUE(dog.large->resultAt(0)->isMade()) << "no step has moved it";

  dog.stroke();
  ASSERT_EQ(dog.document->result().nodes.size(), 1u);
  ASSERT_EQ(dog.document->result().nodes[0].failure, "");
  bool isTold = false;
  QObject::connect(dog.large,
    &LargeModels::progressed,
    dog.large,
    [&] { isTold = isTold || dog.window.findChild<QProgressBar*>()->isVisible(); });
  ASSERT_TRUE(dog.isMadeAtLast());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !dog.large->isMaking(); }, 60000));
  EXPECT_TRUE(isTold);
  EXPECT_FALSE(dog.window.findChild<QProgressBar*>()->isVisible());

  // Where the proxy has not moved every bit stays.
  vtkPolyData* proxy = dog.document->result().mesh;
  vtkDataArray* origin = proxy->GetPointData()->GetArray("Origin");
  ASSERT_TRUE(origin);
  vtkBoundingBox moved;
  for (vtkIdType i = 0; i < proxy->GetNumberOfPoints(); ++i)
  {
    const double* from = origin->GetTuple3(i);
    const double* to = proxy->GetPoint(i);
    if (!std::equal(from, from + 3, to))
    {
      moved.AddPoint(origin->GetTuple3(i));
    }
  }
  ASSERT_TRUE(moved.IsValid());
  moved.Inflate(0.08 * whole->GetLength()); // more than an edge of the proxy
  const auto first = dog.exported("first.vtp");
  ASSERT_EQ(first->GetNumberOfPolys(), all);
  ASSERT_EQ(first->GetNumberOfPoints(), whole->GetNumberOfPoints());
  int followed = 0, beyond = 0;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    const bool isSame = staysAt(first, whole, i);
    followed += !isSame;
    beyond += !isSame && !moved.ContainsPoint(whole->GetPoint(i));
  }
  EXPECT_GT(followed, 100);
  EXPECT_EQ(beyond, 0);

  // A saved session holds the whole model, and opens as it was; an export then waits for what is not there.
  // No mesh lies beside it by its name, which the dialog would choose.
  const QString saved = dog.folder.filePath("kept.oversketch");
  const std::string before = digestOf(dog.session().mesh), after = dog.document->digest();
  dog.document->save(saved);
  const SessionFile kept = readSession(saved.toStdString());
  EXPECT_EQ(kept.session.mesh->GetNumberOfPolys(), all);
  EXPECT_EQ(kept.digest, "") << "that of a proxy";
  ASSERT_TRUE(dog.window.open(saved));
  dog.wait();
  EXPECT_EQ(digestOf(dog.session().mesh), before);
  EXPECT_EQ(dog.document->digest(), after);
  EXPECT_FALSE(dog.large->resultAt(0)->isMade());
  EXPECT_EQ(digestOf(dog.exported("again.vtp")), digestOf(first));
}

TEST(Large, ANewerStepGivesUpWhatIsMade)
{
  LargeDog dog;
  ASSERT_TRUE(dog.session().whole);
  std::shared_ptr<ExactResult> older;
  std::vector<double> told;
  QObject::connect(dog.large,
    &LargeModels::progressed,
    dog.large,
    [&](double share)
    {
      if (older)
      {
        told.push_back(share);
      }
      else if (dog.large->isMaking())
      {
        older = dog.large->resultAt(0);
        dog.document->add(*dog.session().nodes[0].step);
        EXPECT_FALSE(dog.large->isMaking());
      }
    });
  dog.stroke();
  ASSERT_TRUE(QTest::qWaitFor([&] { return older != nullptr; }, 600000));
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told[0], 1.0) << "it went on";
  dog.wait();
  ASSERT_EQ(dog.document->result().nodes.size(), 2u);
  EXPECT_TRUE(dog.isMadeAtLast());
}

TEST(Large, ToolsThatAddTrianglesAreRefused)
{
  if (!findSystem("Augment"))
  {
    return;
  }
  LargeDog dog;
  ASSERT_TRUE(dog.session().whole);
  QTest::keyClick(dog.view, Qt::Key_B);
  dog.settle();
  EXPECT_TRUE(dog.advice->text().contains("coarser copy")) << qPrintable(dog.advice->text());
  const QPoint middle = dog.seen(dog.document->result().mesh->GetCenter());
  const auto at = [&](int i) { return middle + QPoint(4 * i, 0); };
  QTest::mousePress(dog.view, Qt::LeftButton, Qt::NoModifier, at(-10));
  sweepMouse(dog.view, -9, 10, at);
  QTest::mouseRelease(dog.view, Qt::LeftButton, Qt::NoModifier, at(10));
  dog.wait();
  EXPECT_TRUE(dog.session().nodes.empty());
  EXPECT_TRUE(dog.advice->text().contains("coarser copy")) << qPrintable(dog.advice->text());
}
