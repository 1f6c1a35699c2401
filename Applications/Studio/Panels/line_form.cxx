#include "line_form.h"

#include "drawing_lines.h"

#include "vtkPolyData.h"

#include <QtGlobal>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr const char* rowName = "Line"; // nobody reads it

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
  Parameter height = choiceOf(heightArray,
    QT_TRANSLATE_NOOP("Systems", "Height"),
    QT_TRANSLATE_NOOP("Systems", "factor of the drawing's heights, for what the line bounds"),
    {});
  height.least = 0.05; // 0 says none
  height.most = 5.0;
  height.initial = 1.0;
  SystemRow row;
  row.name = rowName;
  row.parameters = {
    choiceOf(depthArray,
      QT_TRANSLATE_NOOP("Systems", "Depth"),
      QT_TRANSLATE_NOOP("Systems",
        "what the line bounds is a body of its own in front of the lines above it, behind them or both, or "
        "it is of their body, in the plane"),
      { { "", QT_TRANSLATE_NOOP("Systems", "in the plane") },
        { "", QT_TRANSLATE_NOOP("Systems", "in front") },
        { "", QT_TRANSLATE_NOOP("Systems", "behind") },
        { "", QT_TRANSLATE_NOOP("Systems", "both sides") } }),
    height,
    choiceOf(sectionArray,
      QT_TRANSLATE_NOOP("Systems", "Cross-section"),
      QT_TRANSLATE_NOOP("Systems", "cross-section of what the line bounds"),
      { { "", QT_TRANSLATE_NOOP("Systems", "as the drawing") },
        { "", QT_TRANSLATE_NOOP("Systems", "circle") },
        { "", QT_TRANSLATE_NOOP("Systems", "linear") },
        { "", QT_TRANSLATE_NOOP("Systems", "step") } })
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
  step.values = { { depthArray, depthOf(line) },
    { heightArray, height > 0.0 ? height : 1.0 },
    { sectionArray, crossSectionOf(line) } };
  return step;
}

vtkSmartPointer<vtkPolyData> withLineValues(vtkPolyData* line, const Values& values)
{
  const double height = std::get<double>(values.at(heightArray));
  return withDepth(line,
    std::get<int>(values.at(depthArray)),
    height == 1.0 ? 0.0 : height,
    std::get<int>(values.at(sectionArray)));
}

} // namespace oversketch_studio
