#include "vtkOversketchTreatment.h"

#include "vtkOversketchDrawingTools.h"

#include "vtkCellData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTreatment);

void vtkOversketchTreatment::SetHoles(const char* text)
{
  SetText(this, this->Holes, text);
}

void vtkOversketchTreatment::SetTunnels(const char* text)
{
  SetText(this, this->Tunnels, text);
}

void vtkOversketchTreatment::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  const Classification classification = ClassificationOf(curves);
  const std::vector<Treatment> given = TreatmentsOf(curves);
  const int count = static_cast<int>(given.size());
  std::vector<Treatment> treatments = given;
  std::vector<char> named(given.size(), 0);
  const std::vector<DrawnStroke> strokes = StrokesOf(curves);
  int names = 0; // strokes are numbered below it
  for (int i = 0; i < count; ++i)
  {
    names = std::max(names, nameOf(strokes, i) + 1);
  }
  // Finds, of several curves of one stroke, the one that it may be.
  const auto curveOf = [&](int name)
  {
    int found = -1;
    for (int i = 0; i < count; ++i)
    {
      const bool bounds = classification.strokes[i].role == Role::ClosedFeature;
      found = nameOf(strokes, i) == name && (found < 0 || bounds) ? i : found;
    }
    return found;
  };
  const auto treat = [&](const std::string& list, const char* parameter, Treatment treatment)
  {
    for (const int name : StrokeNumbers(list, parameter, names))
    {
      const Message who("{%1} names {stroke %2}", parameter, name);
      const int stroke = curveOf(name);
      if (stroke < 0 || classification.strokes[stroke].role != Role::ClosedFeature)
      {
        throw Error(Failure::BadStroke,
          "%1, which is no closed stroke inside another; close it, or name one that is.",
          who);
      }
      if (named[stroke] && treatments[stroke] != treatment)
      {
        throw Error(Failure::BadStroke, "%1, which {Holes} names too; name it once.", who);
      }
      treatments[stroke] = treatment;
      named[stroke] = 1;
    }
  };
  treat(this->Holes, "Holes", Treatment::Hole);
  treat(this->Tunnels, "Tunnels", Treatment::Tunnel);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(curves);
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Treatment", treatments));
}

void vtkOversketchTreatment::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Holes: " << this->Holes << "\n";
  os << indent << "Tunnels: " << this->Tunnels << "\n";
}
