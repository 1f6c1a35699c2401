// Steps in words: a step of a JSON object of values and of inputs by their names, and the list of systems.
#ifndef oversketch_applications_session_module_step_values_h
#define oversketch_applications_session_module_step_values_h

#include "session.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtk_jsoncpp.h"

#include <map>
#include <string>
#include <variant>

namespace oversketch_session
{

// Lines, null to take an input away; the path of a file; an output of a step.
using GivenInput = std::variant<vtkSmartPointer<vtkPolyData>, std::string, StepOutput>;

// The step with other values, a JSON object by property names, and other inputs, both of which replace those
// of the same name. Throws oversketch_files::Failed where no system of the list could run it, or an input
// that it needs is absent.
Step withGiven(Step step,
  const std::string& values,
  const std::map<std::string, GivenInput>& inputs,
  const Model& model);

// Lines as a session's file will give them back. Throws Failed where they are no polylines, or not sound.
vtkSmartPointer<vtkPolyData> soundLines(const std::string& name, vtkPolyData* lines);

// Text of a JSON list of the systems; of a value.
std::string systemsAsJson();
std::string textOf(const Json::Value& value);

} // namespace oversketch_session
#endif
