// Steps of system B: what they are given, compared.
#ifndef oversketch_applications_studio_tools_edit_step_h
#define oversketch_applications_studio_tools_edit_step_h

#include "session.h"
#include "systems.h"

#include "Mesh/message.h"

#include <QString>

#include <string>

namespace oversketch_studio
{

constexpr const char* editSystem = "Edit";
constexpr const char* lineInput = "Reference";
constexpr const char* ringInput = "Boundary";
constexpr const char* profileInput = "Profile";
constexpr const char* areasInput = "Areas";
constexpr const char* weightsInput = "Weights";
constexpr const char* handlesInput = "Handles";
constexpr const char* operationsValue = "Operations";
constexpr const char* layersValue = "Layers";
constexpr const char* levelsValue = "Levels";
constexpr const char* placeValue = "ProfileAt";
constexpr const char* ruleValue = "Rule";

// A message of the system with the line and the ring as the hand calls them. isRing says which of both a
// stroke is where the message does not.
QString wordsOfEdit(const oversketch::Message& message, bool isRing);

const oversketch_session::SystemRow& editRow();

// Whether an input is of the same lines, picture or step.
bool isSameInput(const oversketch_session::Step& a,
  const oversketch_session::Step& b,
  const std::string& name);
// By what is in them.
bool isSameData(vtkPolyData* a, vtkPolyData* b);
// The value of a parameter that is a text.
std::string editText(const oversketch_session::Step& step, const char* property);
// How long the first stroke of some is [px of its view]; of none, and of a curve of an earlier edit,
// infinite.
double pixelsOf(vtkPolyData* strokes);
// The picture that a step's weights are painted in; null where it has none.
const oversketch_session::Image* weightsOf(const oversketch_session::Step& step);
// The last step of a session that has the line and the ring of another; 0 where there is none.
int idOf(const oversketch_session::Session& session, const oversketch_session::Step& step);

} // namespace oversketch_studio
#endif
