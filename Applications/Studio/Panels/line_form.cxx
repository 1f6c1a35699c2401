#include "line_form.h"

#include "drawing_lines.h"

#include "vtkPolyData.h"

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

Parameter choiceOf(const char* property, const char* title, const char* help, std::vector<Choice> choices)
{
  Parameter parameter;
  parameter.property = property;
  parameter.title = title;
  parameter.help = help;
  parameter.choices = std::move(choices);
  parameter.initial = 0;
  return parameter;
}

SystemRow madeLineRow()
{
  Parameter height =
    choiceOf("Height", "Height", "factor of the drawing's heights, for what the line bounds", {});
  height.least = 0.05; // 0 says none
  height.most = 5.0;
  height.initial = 1.0;
  SystemRow row;
  row.name = "Line";
  row.parameters = {
    choiceOf("Depth",
      "Depth",
      "what the line bounds is a body of its own in front of the lines above it, behind them "
      "or both, or it is of their body, in the plane",
      { { "", "in the plane" }, { "", "in front" }, { "", "behind" }, { "", "both sides" } }),
    height,
    choiceOf("CrossSection",
      "Cross-section",
      "cross-section of what the line bounds",
      { { "", "as the drawing" }, { "", "circle" }, { "", "linear" }, { "", "step" } })
  };
  return row;
}

} // namespace

const SystemRow& lineRow()
{
  static const SystemRow row = madeLineRow();
  return row;
}

Step lineStep(vtkPolyData* line)
{
  Step step;
  step.system = lineRow().name;
  const double height = heightOf(line);
  step.values = { { "Depth", depthOf(line) },
    { "Height", height > 0.0 ? height : 1.0 },
    { "CrossSection", crossSectionOf(line) } };
  return step;
}

vtkSmartPointer<vtkPolyData> withLineValues(vtkPolyData* line, const Values& values)
{
  const double height = std::get<double>(values.at("Height"));
  return withDepth(line,
    std::get<int>(values.at("Depth")),
    height == 1.0 ? 0.0 : height,
    std::get<int>(values.at("CrossSection")));
}

} // namespace oversketch_studio
