// Neighbouring fingers: a line between two of them may be meant for either, and reaches into the palm; keys
// choose.
#include "scene.h"

#include "Harness/data.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"

#include <QListWidget>

#include <array>
#include <iostream>
#include <map>
#include <numeric>

#include <set>
#include <string>
#include <vector>

using namespace oversketch_studio;

namespace
{

using Place = std::array<double, 3>;

struct Hands : Scene
{
  std::vector<std::vector<Place>> fingers; // from left to right; the thumb is no neighbour and left out
  std::vector<Place> palm;

  Place place(vtkPolyData* mesh, vtkIdType id)
  {
    Place at;
    mesh->GetPoint(id, at.data());
    return at;
  }
  // The fingers are what hangs together above a height.
  Hands(const std::string& path, double cut)
  {
    EXPECT_TRUE(this->window.open(QString::fromStdString(path)));
    this->wait();
    QApplication::setActiveWindow(&this->window);
    this->view->setFocus();
    QTest::keyClick(this->view, Qt::Key_W); // hides the hint
    this->settle();
    vtkPolyData* mesh = this->document->result().mesh;
    std::vector<vtkIdType> root(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    std::iota(root.begin(), root.end(), 0);
    const auto rootOf = [&](vtkIdType id)
    {
      while (root[static_cast<std::size_t>(id)] != id)
      {
        id = root[static_cast<std::size_t>(id)];
      }
      return id;
    };
    const auto isHigh = [&](vtkIdType id) { return mesh->GetPoint(id)[1] > cut; };
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
    {
      mesh->GetPolys()->GetCellAtId(cell, ids);
      for (vtkIdType k = 1; k < ids->GetNumberOfIds(); ++k)
      {
        if (isHigh(ids->GetId(0)) && isHigh(ids->GetId(k)))
        {
          root[static_cast<std::size_t>(rootOf(ids->GetId(k)))] = rootOf(ids->GetId(0));
        }
      }
    }
    std::map<vtkIdType, std::vector<Place>> parts;
    for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
    {
      isHigh(id) ? parts[rootOf(id)].push_back(this->place(mesh, id))
                 : this->palm.push_back(this->place(mesh, id));
    }
    for (const auto& [id, part] : parts)
    {
      this->fingers.push_back(part);
    }
    std::sort(this->fingers.begin(),
      this->fingers.end(),
      [](const auto& a, const auto& b) { return a.front()[0] < b.front()[0]; });
    this->fingers.erase(this->fingers.begin(), this->fingers.end() - 4);
  }
  // The first or the last pixel of a finger in a row of the view.
  int side(const std::vector<Place>& finger, int row, bool right)
  {
    int found = right ? 0 : this->view->width();
    for (const Place& at : finger)
    {
      const QPoint seen = this->seen(at.data());
      if (std::abs(seen.y() - row) <= 3)
      {
        found = right ? std::max(found, seen.x()) : std::min(found, seen.x());
      }
    }
    return found;
  }
  // A line up the gap between index and middle finger, a little nearer to the latter, that begins so deep in
  // it.
  void drawInTheGap(double depth)
  {
    int tip = 0, web = 0;
    for (const int i : { 0, 1 })
    {
      int top = this->view->height();
      for (const Place& at : this->fingers[static_cast<std::size_t>(i)])
      {
        const int row = this->seen(at.data()).y();
        top = std::min(top, row);
        web = std::max(web, row);
      }
      tip = std::max(tip, top);
    }
    tip += 12;
    std::vector<QPoint> line;
    for (int row = tip + static_cast<int>(depth * (web - 8 - tip)); row >= tip; row -= 2)
    {
      const int from = this->side(this->fingers[0], row, true), to = this->side(this->fingers[1], row, false);
      line.emplace_back(from + static_cast<int>(0.55 * (to - from)), row);
    }
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, line.front());
    sweepMouse(this->view, line);
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, line.back());
    this->wait();
    ASSERT_EQ(this->document->session().nodes.size(), 1u);
    this->window.findChild<QListWidget*>("history")->setCurrentRow(-1); // the last stroke is meant
    this->view->setFocus();
  }
  // How many points of each finger, and of the palm as the last, are no longer where they were.
  std::vector<int> moved()
  {
    vtkPolyData* mesh = this->document->result().mesh;
    std::set<Place> now;
    for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
    {
      now.insert(this->place(mesh, id));
    }
    const auto gone = [&](const std::vector<Place>& part)
    {
      return static_cast<int>(
        std::count_if(part.begin(), part.end(), [&](const Place& at) { return now.count(at) == 0; }));
    };
    std::vector<int> all;
    for (const auto& finger : this->fingers)
    {
      all.push_back(gone(finger));
    }
    all.push_back(gone(this->palm));
    return all;
  }
  void press(Qt::Key key)
  {
    QTest::keyClick(&this->window, key);
    this->wait();
  }
};

void chooseAmongNeighbours(const std::string& path, double cut)
{
  Hands scene(path, cut);
  ASSERT_EQ(scene.fingers.size(), 4u);
  const std::vector<int> none(5, 0);
  ASSERT_EQ(scene.moved(), none);
  // The nearer one, then the other, and not a point besides.
  scene.drawInTheGap(0.5);
  const std::vector<int> nearer = scene.moved();
  EXPECT_GT(nearer[1], 100);
  EXPECT_EQ(nearer, (std::vector<int>{ 0, nearer[1], 0, 0, 0 }));
  scene.press(Qt::Key_F3);
  const std::vector<int> other = scene.moved();
  EXPECT_GT(other[0], 100);
  EXPECT_EQ(other, (std::vector<int>{ other[0], 0, 0, 0, 0 }));
  scene.press(Qt::Key_F3); // beyond the last
  EXPECT_EQ(scene.moved(), none);
  scene.press(Qt::Key_F3);
  EXPECT_EQ(scene.moved(), nearer);
  while (!scene.document->session().nodes.empty())
  {
    scene.document->undo();
    scene.wait();
  }
  // A deeper one takes some of the palm along, until it reaches less.
  scene.drawInTheGap(0.8);
  const std::vector<int> deep = scene.moved();
  EXPECT_GT(deep[1], 100);
  EXPECT_GT(deep[4], 0);
  int pressed = 0;
  for (; scene.moved()[4] > 0 && pressed < 10; ++pressed)
  {
    scene.press(Qt::Key_BracketLeft);
  }
  const std::vector<int> less = scene.moved();
  EXPECT_GT(less[1], 100);
  EXPECT_EQ(less, (std::vector<int>{ 0, less[1], 0, 0, 0 }));
  std::cout << "moved: the nearer finger " << nearer[1] << " of " << scene.fingers[1].size()
            << ", by F3 the other " << other[0] << " of " << scene.fingers[0].size() << "; deeper " << deep[1]
            << " and " << deep[4] << " of the palm, after " << pressed << " brackets " << less[1]
            << " and none\n";
}

} // namespace

TEST(Fingers, TheOneThatIsMeantIsAKeyAway)
{
  chooseAmongNeighbours(OVERSKETCH_DATA_FOLDER "/Models/hand.ply", 0.5);
}

TEST(Fingers, OfASharedHandTheOneThatIsMeantIsAKeyAway)
{
  const std::string path = oversketch_test::sharedData("meshes/hand_closed.obj");
  if (path.empty())
  {
    GTEST_SKIP() << "there is no meshes/hand_closed.obj; set OVERSKETCH_DATA";
  }
  chooseAmongNeighbours(path, 0.6);
}
