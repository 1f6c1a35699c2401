// Sessions of a shipped model, for the tests.
#ifndef oversketch_applications_session_testing_sessions_h
#define oversketch_applications_session_testing_sessions_h

#include "evaluator.h"

#include "vtkOversketchOneStroke.h"

#include "Harness/shipped.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace oversketch_test
{

inline oversketch_session::Node nodeOf(vtkPolyData* stroke, const std::string& name, int id = 1)
{
  auto step = std::make_shared<oversketch_session::Step>();
  step->system = "OneStroke";
  step->inputs["Stroke"] = oversketch_session::Lines(stroke);
  step->values["Remesh"] = int(vtkOversketchOneStroke::RemeshOff);
  oversketch_session::Node node;
  node.id = id;
  node.step = step;
  node.name = name;
  return node;
}

// The same step with something else about it.
template <typename Change>
oversketch_session::Node changed(oversketch_session::Node node, const Change& change)
{
  auto step = std::make_shared<oversketch_session::Step>(*node.step);
  change(*step);
  node.step = step;
  return node;
}

inline vtkSmartPointer<vtkPolyData> strokeOf(const oversketch_session::Node& node)
{
  return oversketch_session::linesOf(*node.step, "Stroke");
}

// The dog, its leg drawn longer and its tail curled.
inline oversketch_session::Session dogSession()
{
  oversketch_session::Session session;
  session.meshName = "dog.ply";
  session.mesh = shippedModel("dog");
  session.backend = vtkOversketchOneStroke::Host;
  session.nodes = { nodeOf(shippedStroke("dog_longer_leg"), "leg", 1),
    nodeOf(shippedStroke("dog_curled_tail"), "tail", 2) };
  return session;
}

inline std::vector<oversketch_session::Outcome> outcomesOf(oversketch_session::Evaluator& evaluator,
  const oversketch_session::Session& session,
  bool details = false)
{
  std::vector<oversketch_session::Outcome> outcomes;
  oversketch_session::Evaluator::Watch watch;
  watch.details = details;
  EXPECT_TRUE(evaluator.run(session, watch, outcomes));
  EXPECT_EQ(outcomes.size(), session.nodes.size());
  return outcomes;
}

inline std::vector<oversketch_session::Outcome> outcomesOf(const oversketch_session::Session& session)
{
  oversketch_session::Evaluator evaluator;
  return outcomesOf(evaluator, session);
}

} // namespace oversketch_test
#endif
