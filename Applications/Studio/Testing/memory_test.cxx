// What the window holds of a large model at rest: the meshes of its steps, and not what these worked with.
#include "scene.h"

#include "Harness/sequences.h"

#include <ctime>
#include <iostream>

using namespace oversketch_studio;

namespace
{

// Bytes that the program holds now.
double held()
{
  return 1048576.0 * oversketch_test::memoryInUse();
}

// Once all that follows on a model is made, what the first stroke needs as well: no thread computes any more.
double heldAtRest(Scene& scene)
{
  scene.wait();
  scene.pictureAtRest();
  const auto rests = []
  {
    const std::clock_t before = std::clock(); // all threads' work
    QTest::qWait(500);
    return std::clock() - before < CLOCKS_PER_SEC / 20;
  };
  EXPECT_TRUE(QTest::qWaitFor(rests, 600000));
  return held();
}

} // namespace

TEST(Memory, AStepsWorkIsGivenBackOverTheBound)
{
  Scene scene;
  const auto triangles = static_cast<double>(scene.document->result().mesh->GetNumberOfPolys());
  const double opened = heldAtRest(scene);
  const auto step = [&]
  {
    scene.draw();
    scene.release();
    QApplication::processEvents();
    return heldAtRest(scene);
  };
  step();
  const double kept = step();
  scene.document->undo();
  heldAtRest(scene);
  scene.document->keepWorkUpTo(10000);
  scene.document->redo(); // to the same meshes
  const double given = heldAtRest(scene);
  ASSERT_EQ(scene.document->result().nodes.size(), 2u);
  std::cout << "bytes a triangle beside the opened model after two strokes: " << (kept - opened) / triangles
            << ", of which are left at rest " << (given - opened) / triangles << '\n';
  EXPECT_GT(kept - given, 1500.0 * triangles) << "the work is not given back";
  EXPECT_LT(given - opened, 900.0 * triangles) << "more is held than the meshes of two steps";
}
