#include "vtkOversketchMask.h"

#include "Ray/seen.h"
#include "Stroke/enclosed.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchWeldedInput.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace oversketch;

struct vtkOversketchMask::Inner
{
  WeldedInput Input;
  vtkNew<vtkPolyData> Made; // the last output, a shallow copy; empty after a run that failed

  // 1 for each vertex that one of the lassos encloses.
  std::vector<char> Enclosed(vtkPolyData* strokes, bool through, vtkAlgorithm* self)
  {
    constexpr int least = 3; // samples that enclose something
    const std::vector<Vector3>& points = this->Input.Data().Surface().points;
    std::vector<char> enclosed(points.size(), 0);
    const std::vector<DrawnLine> lassos = ReadStrokes(strokes, least);
    for (std::size_t i = 0; i < lassos.size(); ++i)
    {
      const double each = 0.9 / static_cast<double>(lassos.size()), from = static_cast<double>(i) * each;
      const View view = ViewOfStroke(strokes, static_cast<vtkIdType>(i));
      const Context context = ContextOf(self, from, from + 0.5 * each);
      std::vector<Vector2> places(points.size());
      context.each(static_cast<int>(points.size()),
        [&](int v)
        {
          // Of what is behind the eye no place is in the picture.
          places[v] = view.inFront(points[v]) ? Vector2(view.toDisplay(points[v]).head<2>())
                                              : Vector2::Constant(std::numeric_limits<double>::quiet_NaN());
        });
      std::vector<int> inside = marked(enclosedBy(lassos[i].Samples, places, context));
      const std::vector<char> seen =
        through ? std::vector<char>(inside.size(), 1)
                : seenVertices(
                    this->Input.Rays(context), view, inside, ContextOf(self, from + 0.5 * each, from + each));
      for (std::size_t k = 0; k < inside.size(); ++k)
      {
        enclosed[inside[k]] = enclosed[inside[k]] || seen[k];
      }
    }
    if (std::find(enclosed.begin(), enclosed.end(), 1) == enclosed.end())
    {
      throw Error(Failure::BadStroke,
        "The lasso encloses no point of the mesh that is seen; draw it round a part of the model, larger "
        "where "
        "the mesh is coarse, or {Through on}.");
    }
    return enclosed;
  }

  // Masks what is so near to the mask, or frees what is so near to what is not masked.
  void Grow(double length, std::vector<double>& mask) const
  {
    std::vector<int> sources;
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      if ((mask[v] >= 1.0) == (length > 0.0))
      {
        sources.push_back(static_cast<int>(v));
      }
    }
    const std::vector<double> ways =
      edgeDistances(this->Input.Data().Surface(), this->Input.Data().Neighbours(), sources, std::abs(length));
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      if (ways[v] <= std::abs(length))
      {
        mask[v] = length > 0.0 ? 1.0 : 0.0;
      }
    }
  }
};

vtkStandardNewMacro(vtkOversketchMask);

vtkOversketchMask::vtkOversketchMask()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

int vtkOversketchMask::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Inner& inner = this->Kept<Inner>();
  inner.Made->Initialize();
  return this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      vtkPolyData* strokes = vtkPolyData::GetData(inputs[1]);
      RequireFinite(this->Grow, "Grow");
      const bool isDrawn = strokes && strokes->GetNumberOfPoints() > 0;
      if (!isDrawn && this->Mode != Replace && this->Grow == 0.0 && !this->Invert)
      {
        throw Error(Failure::BadStroke,
          "There is no lasso; draw one round a part of the model, or let the mask {Grow}, {Invert on}, or "
          "clear it by {Mode Replace}.");
      }
      inner.Input.Feed(mesh);
      std::vector<double> mask = inner.Input.MaskOfVertices(mesh);
      mask.resize(inner.Input.Data().Surface().points.size(), 0.0);
      if (this->Mode == Replace)
      {
        std::fill(mask.begin(), mask.end(), 0.0);
      }
      if (isDrawn)
      {
        for (const int v : marked(inner.Enclosed(strokes, this->Through, this)))
        {
          mask[v] = this->Mode == Subtract ? 0.0 : 1.0;
        }
      }
      if (this->Grow != 0.0)
      {
        inner.Grow(this->Grow, mask);
      }
      if (this->Invert)
      {
        std::transform(mask.begin(), mask.end(), mask.begin(), [](double m) { return 1.0 - m; });
      }
      ContextOf(this).checkpoint(1.0);
      const auto made =
        NewArray<vtkFloatArray>(maskName, 1, static_cast<std::size_t>(mesh->GetNumberOfPoints()));
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        made->SetValue(i, static_cast<float>(mask[static_cast<std::size_t>(inner.Input.VertexOf(i))]));
      }
      output->ShallowCopy(mesh);
      output->GetPointData()->AddArray(made);
      inner.Made->ShallowCopy(output);
    });
}

bool vtkOversketchMask::Prepare()
{
  return this->TryPrepare(
    [this](vtkPolyData* mesh)
    {
      WeldedInput& input = this->Kept<Inner>().Input;
      input.Feed(mesh);
      input.Rays(ContextOf(this));
    });
}

vtkOversketchSystem::FigureList vtkOversketchMask::Figures()
{
  vtkPolyData* made = this->Kept<Inner>().Made;
  if (made->GetNumberOfPoints() == 0)
  {
    return {};
  }
  const std::vector<char> masked = MaskedPointsOf(made);
  return { { "masked", static_cast<vtkIdType>(std::count(masked.begin(), masked.end(), 1)) },
    { "of_points", made->GetNumberOfPoints() } };
}

void vtkOversketchMask::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Through: " << this->Through << "\n";
  os << indent << "Grow: " << this->Grow << "\n";
  os << indent << "Invert: " << this->Invert << "\n";
}
