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
#include "vtkSmartPointer.h"

#include <array>

using namespace oversketch;

// The last result and all that it was made of.
struct vtkOversketchPlanarRefine::Cache
{
  StepKey Key;
  bool Made = false;
  int Inverted = 0;
  vtkSmartPointer<vtkPolyData> Mesh, Edges, Splits;

  void Renew()
  {
    for (vtkSmartPointer<vtkPolyData>* data : { &this->Mesh, &this->Edges, &this->Splits })
    {
      *data = vtkSmartPointer<vtkPolyData>::New();
    }
  }
};

vtkStandardNewMacro(vtkOversketchPlanarRefine);

vtkOversketchPlanarRefine::vtkOversketchPlanarRefine()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

vtkOversketchPlanarRefine::~vtkOversketchPlanarRefine() = default;

void vtkOversketchPlanarRefine::SetEdgesData(vtkPolyData* edges)
{
  this->SetInputData(1, edges);
}

void vtkOversketchPlanarRefine::SetCurvesData(vtkPolyData* curves)
{
  this->SetInputData(2, curves);
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
      this->Inverted = 0;
      if (faces->GetNumberOfPoints() == 0)
      {
        return;
      }
      PlanarRefineOptions options;
      options.levels = this->Levels;
      options.snapShare = this->SnapShare;
      options.guard = this->Guard && !this->AsPublished;
      options.quads = this->Quads;
      Cache& cache = *this->Internals;
      const StepKey key({ PlanarKey(faces), PlanarKey(edges), CurvesKey(curves) },
        { static_cast<double>(options.levels),
          options.snapShare,
          static_cast<double>(options.guard),
          static_cast<double>(options.quads) });
      if (!cache.Made || cache.Key != key)
      {
        cache.Made = false; // so that nothing stale is left when making fails
        ++this->RefineCount;
        const Drawing drawing = DrawingOf(curves);
        options.canvasSide = drawing.Rectangle.longest();
        const PlanarRefineResult result =
          refinePlanar(PlanarMeshOf(faces, edges), drawing.Strokes, options, ContextOf(this));
        cache.Renew();
        if (result.splits.empty())
        {
          WritePlanarMesh(result.mesh, cache.Mesh);
          WriteStrokeEdges(result.mesh, cache.Mesh, cache.Edges);
        }
        else
        {
          WriteSplits(result.splits, drawing.Strokes, cache.Splits);
        }
        cache.Inverted = result.inverted;
        cache.Key = key;
        cache.Made = true;
      }
      this->Inverted = cache.Inverted;
      if (cache.Splits->GetNumberOfCells() > 0)
      {
        vtkWarningMacro("In " << cache.Splits->GetNumberOfCells()
                              << " places strokes leave triangles no room: approximate them closer there, "
                                 "with vtkOversketchPolyline and the splits on output 2.");
      }
      const std::array<vtkPolyData*, 3> made{ cache.Mesh, cache.Edges, cache.Splits };
      for (int port = 0; port < 3; ++port)
      {
        vtkPolyData* output = vtkPolyData::GetData(outputs, port);
        output->ShallowCopy(made[port]);
        output->GetFieldData()->PassData(faces->GetFieldData());
      }
    });
}

void vtkOversketchPlanarRefine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "SnapShare: " << this->SnapShare << "\n";
  os << indent << "Guard: " << this->Guard << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "Quads: " << this->Quads << "\n";
  os << indent << "Inverted: " << this->Inverted << "\n";
  os << indent << "RefineCount: " << this->RefineCount << "\n";
}
