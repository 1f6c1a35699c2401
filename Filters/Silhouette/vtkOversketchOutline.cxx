#include "vtkOversketchOutline.h"

#include "Silhouette/attach.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <optional>

using namespace oversketch;

// The loops of the last mesh, view and window.
constexpr double attachDistance = 3.0; // px

struct vtkOversketchOutline::Cache
{
  std::shared_ptr<const MeshData> Data;
  std::optional<View> Seen;
  PixelWindow Window;
  std::vector<OutlineLoop> Loops;
  vtkIdType TraceCount = 0;
};

namespace
{

bool SameView(const View& a, const View& b)
{
  return a.viewTransform() == b.viewTransform() && a.projectionTransform() == b.projectionTransform() &&
         a.width() == b.width() && a.height() == b.height();
}

// A depth for loops that no silhouette point is attached to.
double SomeDepth(const Mesh& mesh, const View& view)
{
  for (const Triangle& t : mesh.triangles)
  {
    if (view.inFront(mesh.points[t[0]]))
    {
      return view.depth(mesh.points[t[0]]);
    }
  }
  return -1.0;
}

// Mean length in the picture [px], were they parallel to it, of the mesh edges round a silhouette point.
double EdgeLength(const CurvePoint& p, const MeshData& mesh, const View& view)
{
  double sum = 0.0;
  int edges = 0;
  for (const int v : p.binding.vertices)
  {
    for (const int* n = mesh.Neighbours().vertexVertices.begin(v);
         n != mesh.Neighbours().vertexVertices.end(v);
         ++n)
    {
      sum += (mesh.Surface().points[*n] - mesh.Surface().points[v]).norm();
      ++edges;
    }
  }
  const Vector3 place = view.toDisplay(p.position);
  const double pixel = (view.toWorld(place.head<2>() + Vector2(1.0, 0.0), place[2]) - p.position).norm();
  return edges > 0 ? sum / edges / pixel : 0.0;
}

// World positions for the loop: bound points have theirs, the others get a depth between their neighbours'.
Curve PlaceLoop(const std::vector<OutlineStation>& stations,
  bool closed,
  const std::vector<Curve>& visible,
  const MeshData& mesh,
  const View& view,
  double defaultDepth)
{
  const int count = static_cast<int>(stations.size());
  Curve curve;
  curve.closed = closed;
  curve.points.resize(stations.size());
  Polyline display;
  std::vector<int> attached;
  for (int i = 0; i < count; ++i)
  {
    const OutlineStation& station = stations[i];
    display.push_back(station.display);
    if (station.curve >= 0)
    {
      curve.points[i] = visible[station.curve].points[station.point];
    }
    else if (station.bound())
    {
      curve.points[i].binding = station.edge;
      curve.points[i].position = station.edge.of(mesh.Surface().points);
      curve.points[i].normal = station.edge.of(mesh.Normals()).normalized();
    }
    if (station.bound())
    {
      attached.push_back(i);
    }
  }
  const std::vector<double> along = arcLengths(display, closed);
  std::size_t next = 0; // into attached: the first one after the point
  for (int i = 0; i < count; ++i)
  {
    if (stations[i].bound())
    {
      ++next;
      continue;
    }
    double depth = defaultDepth;
    if (!attached.empty())
    {
      const bool wraps = next == 0 || next == attached.size();
      const int a = wraps ? attached.back() : attached[next - 1],
                b = wraps ? attached.front() : attached[next];
      const double depthA = view.depth(curve.points[a].position),
                   depthB = view.depth(curve.points[b].position);
      double gap = along[b] - along[a], step = along[i] - along[a];
      gap += wraps ? along.back() : 0.0;
      step += step < 0.0 ? along.back() : 0.0;
      depth = gap > 0.0 ? depthA + step / gap * (depthB - depthA) : depthA;
      if (wraps && !closed)
      {
        depth = next == 0 ? depthB : depthA;
      }
    }
    curve.points[i].position = view.toWorld(stations[i].display + stations[i].offset, depth);
  }
  return curve;
}

} // namespace

vtkStandardNewMacro(vtkOversketchOutline);

vtkOversketchOutline::vtkOversketchOutline()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
}

vtkOversketchOutline::~vtkOversketchOutline() = default;

vtkIdType vtkOversketchOutline::GetTraceCount()
{
  return this->Internals->TraceCount;
}

void vtkOversketchOutline::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
  const View view = ViewOf(stroke);
  const std::shared_ptr<const MeshData> data = SharedMesh(input);
  const Mesh& mesh = data->Surface();
  CurveSet set = ReadCurves(vtkPolyData::GetData(inputs[2]), mesh.vertexCount(), "silhouette curves");

  // A picture of ordinary size has a window of its own, so that a new stroke in the same view finds its
  // loops.
  const PixelWindow window = outlineWindow(mesh, view, StrokeOf(stroke), ContextOf(this, 0.0, 0.0));
  Cache& cache = *this->Internals;
  if (cache.Data != data || !cache.Seen || !SameView(*cache.Seen, view) || !(cache.Window == window))
  {
    cache.Seen.reset();
    cache.Loops = traceOutline(mesh, view, window, ContextOf(this, 0.0, 0.9));
    cache.Data = data;
    cache.Window = window;
    cache.Seen = view;
    ++cache.TraceCount;
  }

  std::vector<VisibleCurve> visible;
  for (std::size_t i = 0; i < set.Curves.size(); ++i)
  {
    visible.push_back({ {}, {}, set.Curves[i].closed });
    for (const CurvePoint& p : set.Curves[i].points)
    {
      // Numbered as in the set, also where nothing of the curve is seen.
      if (set.Visible[i] && view.inFront(p.position))
      {
        visible.back().display.push_back(view.toDisplay(p.position).head<2>());
        // Farther than the facets explain lies an inner feature, a crease between toes: its points would
        // pull against the outline's own.
        visible.back().reach.push_back(0.5 * EdgeLength(p, *data, view));
      }
    }
    if (visible.back().display.size() != set.Curves[i].points.size())
    {
      visible.back().display.clear();
    }
  }
  const auto outlines = attachSilhouette(cache.Loops, visible, attachDistance, true);

  const double defaultDepth = SomeDepth(mesh, view);
  std::vector<Curve> curves;
  const auto displays = NewArray<vtkDoubleArray>("Display", 2);
  const auto offsets = NewArray<vtkDoubleArray>("Offset", 2);
  const auto ids = NewArray<vtkIntArray>("CurveId");
  const auto flags = NewArray<vtkUnsignedCharArray>("Visible");
  const auto holes = NewArray<vtkUnsignedCharArray>("Hole");
  for (std::size_t l = 0; l < outlines.size(); ++l)
  {
    curves.push_back(PlaceLoop(outlines[l], cache.Loops[l].closed, set.Curves, *data, view, defaultDepth));
    for (const OutlineStation& station : outlines[l])
    {
      displays->InsertNextTuple(station.display.data());
      offsets->InsertNextTuple(station.offset.data());
    }
    ids->InsertNextValue(static_cast<int>(l));
    flags->InsertNextValue(1);
    holes->InsertNextValue(cache.Loops[l].hole);
  }
  WriteCurves(curves, view, output);
  output->GetPointData()->AddArray(displays);
  output->GetPointData()->AddArray(offsets);
  output->GetCellData()->AddArray(ids);
  output->GetCellData()->AddArray(flags);
  output->GetCellData()->AddArray(holes);
}
