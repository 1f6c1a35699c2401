#include "vtkOversketchArrange.h"

#include "Planar/arrange.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchArrange);

namespace
{

// Curves with the nodes on them; StrokeId is the cell of the input.
void writeArranged(const std::vector<ArrangedCurve>& arranged, const Canvas& canvas, vtkPolyData* output)
{
  std::vector<CanvasStroke> curves;
  const auto nodes = NewArray<vtkUnsignedCharArray>("Node");
  for (const ArrangedCurve& one : arranged)
  {
    curves.push_back({ one.curve.points, one.curve.closed });
    for (std::size_t k = 0; k < one.curve.points.size(); ++k)
    {
      nodes->InsertNextValue(one.curve.isNode(static_cast<int>(k)) ? 1 : 0);
    }
  }
  WriteCurves(curves, canvas, output);
  output->GetPointData()->AddArray(nodes);
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("StrokeId", arranged, &ArrangedCurve::stroke));
}

// The cell arrays of the strokes that curves are parts of; `strokes`: their cells.
void passStrokeArrays(vtkPolyData* input, vtkDataArray* strokes, vtkPolyData* output)
{
  vtkNew<vtkCellData> carried;
  carried->CopyFieldOff("Closed");
  carried->CopyAllocate(input->GetCellData(), strokes->GetNumberOfTuples());
  for (vtkIdType i = 0; i < strokes->GetNumberOfTuples(); ++i)
  {
    carried->CopyData(input->GetCellData(), static_cast<vtkIdType>(strokes->GetComponent(i, 0)), i);
  }
  for (int i = 0; i < carried->GetNumberOfArrays(); ++i)
  {
    output->GetCellData()->AddArray(carried->GetAbstractArray(i));
  }
  output->GetFieldData()->PassData(input->GetFieldData());
}

} // namespace

void vtkOversketchArrange::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const MeshKey read(curves,
    { curves->GetFieldData()->GetArray("Canvas"),
      curves->GetFieldData()->GetArray("Resolution"),
      curves->GetCellData()->GetArray("StrokeId") });
  this->Kept<KeptOutput>().Provide(StepKey({ read }, { this->JoinDistance }),
    output,
    [&](vtkPolyData* result)
    {
      ++this->ArrangementCount;
      const Canvas canvas = CanvasOf(curves);
      const Frame frame = RasterOf(curves);
      const double reach = this->JoinDistance * canvas.longest() / frame.spacing;
      writeArranged(arrange(frame, StrokesOf(curves), reach, ContextOf(this)), canvas, result);
    });
  passStrokeArrays(curves, output->GetCellData()->GetArray("StrokeId"), output);
}

void vtkOversketchArrange::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "JoinDistance: " << this->JoinDistance << "\n";
  os << indent << "ArrangementCount: " << this->ArrangementCount << "\n";
}
