// A session on a mesh that is too large for it.
#include "large_mesh.h"
#include "sessions.h"

using namespace oversketch_session;
using namespace oversketch_test;

TEST(LargeMesh, StepsOnItsProxyMoveIt)
{
  Session session = dogSession();
  const SharedData mesh = session.mesh;
  const vtkIdType most = mesh->GetNumberOfPolys() / 2;
  EXPECT_TRUE(isLarge(mesh, most));
  EXPECT_FALSE(isLarge(mesh));
  EXPECT_TRUE(isMoved(session));
  session.mesh = proxyOf(mesh, {}, most);
  ASSERT_TRUE(session.mesh);
  EXPECT_LT(session.mesh->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  const std::vector<Outcome> outcomes = outcomesOf(session);
  const auto exact = exactOf(mesh, resultOf(session, outcomes));
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->GetPolys(), mesh->GetPolys());
  vtkIdType moved = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const std::array<double, 3> place = {
      exact->GetPoint(i)[0], exact->GetPoint(i)[1], exact->GetPoint(i)[2]
    };
    const double* rest = mesh->GetPoint(i);
    moved += place != std::array<double, 3>{ rest[0], rest[1], rest[2] } ? 1 : 0;
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(moved, mesh->GetNumberOfPoints() / 2);
}

TEST(LargeMesh, NothingComesOfWhatIsCancelledOrMakesTriangles)
{
  const SharedData mesh = dogSession().mesh;
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_EQ(proxyOf(mesh, progress, mesh->GetNumberOfPolys() / 2), nullptr);
  const auto proxy = proxyOf(mesh, {}, mesh->GetNumberOfPolys() / 2);
  EXPECT_EQ(exactOf(mesh, proxy, progress), nullptr);
  EXPECT_THROW(exactOf(mesh, mesh), oversketch::Error); // it has no Origin
  Session session = dogSession();
  session.nodes[1] = changed(session.nodes[1], [](Step& step) { step.system = "Augment"; });
  EXPECT_FALSE(isMoved(session));
  session.nodes[1].on = false;
  EXPECT_TRUE(isMoved(session));
}
