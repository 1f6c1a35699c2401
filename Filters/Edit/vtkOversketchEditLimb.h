// Parts of a ring on a mesh that are on the limb that the line lies on. Not installed.
#ifndef vtkOversketchEditLimb_h
#define vtkOversketchEditLimb_h

#include <utility>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// Where runs of a closed curve begin and end, by CurveT.
using RunSpans = std::vector<std::pair<double, double>>;

// The runs of a ring on a mesh that are on the limb that a line on it lies on, see
// Kernels/Remesh/limb_runs.h; none where all are. spline: the ring in the picture.
RunSpans SpansOnLimb(vtkPolyData* ring, vtkPolyData* spline, vtkPolyData* mesh, vtkPolyData* line);

// The runs of a ring whose middle is within one of the spans.
void KeepSpans(vtkPolyData* ring, const RunSpans& spans, vtkPolyData* kept);

// The share of the area of a mesh's EditRegion that lies outside a ring in the picture. ring: the strokes on
// the mesh, for their view; spline: the ring in the picture.
double ShareOutside(vtkPolyData* mesh, vtkPolyData* ring, vtkPolyData* spline);

// Share of a ring's length that lies within `reach` of runs that were seen.
double ShareSeen(vtkPolyData* ring, vtkPolyData* seen, double reach);

} // namespace oversketch
#endif
