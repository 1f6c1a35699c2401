#include "vtkOversketchPlanarRefine.h"

#include "Planar/refine.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchPlanarRefine::Cache
{
  KeptOutput Kept;
  int Inverted = 0, LevelsMade = 0;
};

vtkStandardNewMacro(vtkOversketchPlanarRefine);

vtkOversketchPlanarRefine::vtkOversketchPlanarRefine()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

int vtkOversketchPlanarRefine::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* faces = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* edges = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* curves = vtkPolyData::GetData(inputs[2]);
      this->Inverted = this->LevelsMade = 0;
      if (faces->GetNumberOfPoints() == 0)
      {
        return;
      }
      PlanarRefineOptions options;
      const bool fromSketch = this->LevelsFromSketch && !this->AsPublished;
      options.levels = fromSketch ? 0 : this->Levels;
      const bool onceMore = this->LargeFacesOnceMore && !this->AsPublished && !fromSketch && this->Levels > 0;
      options.snapShare = this->SnapShare;
      options.guard = !this->AsPublished;
      options.quads = this->Quads;
      Cache& cache = this->Kept<Cache>();
      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      cache.Kept.Provide(StepKey({ PlanarKey(faces), PlanarKey(edges), CurvesKey(curves) },
                           { static_cast<double>(options.levels),
                             options.snapShare,
                             static_cast<double>(options.guard),
                             static_cast<double>(options.quads),
                             static_cast<double>(fromSketch),
                             static_cast<double>(onceMore) }),
        { output, this->GetEdgesOutput(), this->GetSplitsOutput() },
        [&](const KeptOutput::Outputs& results)
        {
          ++this->RefineCount;
          const Drawing drawing = DrawingOf(curves);
          options.canvasSide = drawing.Rectangle.longest();
          const PlanarMesh coarse = PlanarMeshOf(faces, edges);
          options.levels = fromSketch ? levelsOfSketch(coarse, options.canvasSide) : options.levels;
          options.levels += onceMore && hasLargeFaces(coarse, options.canvasSide);
          const PlanarRefineResult made = refinePlanar(coarse, drawing.Strokes, options, ContextOf(this));
          WritePlanarMesh(made.mesh, results[0]);
          WriteStrokeEdges(made.mesh, results[0], results[1]);
          WriteSplits(made.splits, drawing.Strokes, results[2]);
          cache.Inverted = made.inverted;
          cache.LevelsMade = options.levels;
        });
      for (vtkPolyData* data : { output, this->GetEdgesOutput(), this->GetSplitsOutput() })
      {
        data->GetFieldData()->PassData(faces->GetFieldData());
      }
      this->Inverted = cache.Inverted;
      this->LevelsMade = cache.LevelsMade;
      const vtkIdType parts = this->GetSplitsOutput()->GetNumberOfCells();
      if (parts > 0 && !this->SplitsAreTaken)
      {
        Warn(this,
          { "Strokes leave triangles no room, or triangles leave strokes, %1 parts of them: approximate "
            "these "
            "closer, with vtkOversketchPolyline and the splits on output 2.",
            parts });
      }
    });
}

void vtkOversketchPlanarRefine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "LevelsFromSketch: " << this->LevelsFromSketch << "\n";
  os << indent << "LargeFacesOnceMore: " << this->LargeFacesOnceMore << "\n";
  os << indent << "SnapShare: " << this->SnapShare << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "Quads: " << this->Quads << "\n";
  os << indent << "SplitsAreTaken: " << this->SplitsAreTaken << "\n";
  os << indent << "LevelsMade: " << this->LevelsMade << "\n";
  os << indent << "Inverted: " << this->Inverted << "\n";
  os << indent << "RefineCount: " << this->RefineCount << "\n";
}
