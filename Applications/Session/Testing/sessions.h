// Sessions of a shipped model, for the tests.
#ifndef oversketch_test_sessions_h
#define oversketch_test_sessions_h

#include "evaluator.h"

#include "vtkOversketchOneStroke.h"

#include "Harness/shipped.h"

namespace oversketch_test
{

inline oversketch_session::Node nodeOf(vtkPolyData* stroke, const std::string& name)
{
  auto action = std::make_shared<oversketch_session::Action>();
  action->stroke = vtkSmartPointer<vtkPolyData>(stroke);
  action->parameters.remesh = vtkOversketchOneStroke::RemeshOff;
  oversketch_session::Node node;
  node.action = action;
  node.name = name;
  return node;
}

// The dog, its leg drawn longer and its tail curled.
inline oversketch_session::Session dogSession()
{
  oversketch_session::Session session;
  session.meshName = "dog.ply";
  session.mesh = shippedModel("dog");
  session.backend = vtkOversketchOneStroke::Host;
  session.nodes = { nodeOf(shippedStroke("dog_longer_leg"), "leg"),
    nodeOf(shippedStroke("dog_curled_tail"), "tail") };
  return session;
}

} // namespace oversketch_test
#endif
