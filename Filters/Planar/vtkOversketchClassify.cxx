#include "vtkOversketchClassify.h"

#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

struct vtkOversketchClassify::Cache
{
  KeptOutput Kept;
  vtkNew<vtkImageData> Labels;
  std::vector<Message> Warnings;
};

vtkStandardNewMacro(vtkOversketchClassify);

namespace
{

// A drawing with strokes that meet is none; what is merely too small or astray can be left out.
bool spoilsTheDrawing(Rejection why)
{
  return why == Rejection::Crosses || why == Rejection::CrossesItself || why == Rejection::Areas;
}

// Words on the strokes that can be left out. Throws what is to be said of the others.
std::vector<Message> judged(const Classification& classification, const std::vector<DrawnStroke>& strokes)
{
  std::vector<Message> warnings, errors;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const Rejection why = classification.strokes[i].rejection;
    if (why != Rejection::None)
    {
      (spoilsTheDrawing(why) ? errors : warnings)
        .push_back(rejectionText(classification, static_cast<int>(i), strokes));
    }
  }
  if (!errors.empty())
  {
    throw Error(Failure::BadStroke, Message::joined(errors));
  }
  return warnings;
}

void writeLabels(const Classification& classification, const Frame& frame, vtkImageData* image)
{
  image->Initialize();
  WriteFrame(frame, image);
  image->GetPointData()->SetScalars(ArrayOf<vtkIntArray>("Labels", classification.labels));
}

} // namespace

vtkOversketchClassify::vtkOversketchClassify()
{
  this->SetNumberOfOutputPorts(2);
  DeclareOutput(this, 1, { Port::Image });
}

vtkImageData* vtkOversketchClassify::GetLabelsOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkOversketchClassify::RequestInformation(vtkInformation*,
  vtkInformationVector**,
  vtkInformationVector* outputs)
{
  return DescribeImage(this,
    outputs->GetInformationObject(1),
    VTK_INT,
    [this](vtkPolyData* curves) { return frameOf(CanvasOf(curves), this->Resolution); });
}

int vtkOversketchClassify::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      this->CrossingCount = 0;
      if (curves->GetNumberOfPoints() == 0)
      {
        vtkImageData::GetData(outputs, 1)->Initialize();
        return;
      }
      Cache& cache = this->Kept<Cache>();
      const double share = this->AsPublished ? 0.0 : this->ContactShare;
      cache.Kept.Provide(StepKey({ MeshKey(curves,
                                   { curves->GetFieldData()->GetArray("Canvas"),
                                     curves->GetCellData()->GetArray("StrokeId"),
                                     curves->GetPointData()->GetArray("Node") }) },
                           { share, static_cast<double>(this->Resolution) }),
        output,
        [&](vtkPolyData* result)
        {
          ++this->ClassificationCount;
          const Frame frame = frameOf(CanvasOf(curves), this->Resolution);
          const std::vector<DrawnStroke> strokes = StrokesOf(curves);
          const Classification classification = classify(frame, strokes, share, ContextOf(this));
          this->CrossingCount = static_cast<int>(std::count_if(classification.strokes.begin(),
            classification.strokes.end(),
            [](const StrokeClass& one)
            { return one.rejection == Rejection::Crosses || one.rejection == Rejection::CrossesItself; }));
          cache.Warnings = judged(classification, strokes);
          writeLabels(classification, frame, cache.Labels);
          result->SetPoints(curves->GetPoints());
          result->SetLines(curves->GetLines());
          WriteClassification(classification, result);
          result->GetFieldData()->AddArray(OneValue<vtkIntArray>("Resolution", this->Resolution));
        });
      for (const Message& warning : cache.Warnings)
      {
        Warn(this, warning);
      }
      output->GetPointData()->PassData(curves->GetPointData());
      PassDrawingArrays(curves, output);
      vtkImageData::GetData(outputs, 1)->ShallowCopy(cache.Labels);
    });
}

void vtkOversketchClassify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContactShare: " << this->ContactShare << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "ClassificationCount: " << this->ClassificationCount << "\n";
  os << indent << "CrossingCount: " << this->CrossingCount << "\n";
}
