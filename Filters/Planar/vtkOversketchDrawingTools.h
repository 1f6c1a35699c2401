/**
 * A drawing, what its strokes are, and its distance maps, from curves and images and back. Free functions,
 * for use in the .cxx of filters; not wrapped. README.md of this folder lists the arrays.
 */
#ifndef vtkOversketchDrawingTools_h
#define vtkOversketchDrawingTools_h

#include "OversketchFiltersPlanarModule.h" // For export macro

#include "Raster/classify.h"
#include "Raster/distance_maps.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchKept.h"

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkImageData;
class vtkInformation;
class vtkPolyData;

namespace oversketch
{

/**
 * The strokes of a drawing on their canvas; stroke i is cell i of the curves.
 */
struct Drawing
{
  Canvas Rectangle;
  Frame Raster; // by field array Resolution, 1024 px without it
  std::vector<DrawnStroke> Strokes;
  std::vector<Treatment> Treatments; // Fill where there is no array Treatment

  /**
   * The distance of samples that the paper calls h [world].
   */
  double Spacing() const { return SampleSpacing(this->Rectangle); }
};

/**
 * The strokes alone: their samples, which of these are nodes (point array Node, none without it), and what
 * messages call them (cell array StrokeId). Throws what ReadStrokes does.
 */
OVERSKETCHFILTERSPLANAR_EXPORT std::vector<DrawnStroke> StrokesOf(vtkPolyData* curves);

/**
 * Throws what ReadStrokes and CanvasOf do, Error(BadStroke) for a Treatment that is none or a Resolution that
 * frameOf refuses.
 */
OVERSKETCHFILTERSPLANAR_EXPORT Drawing DrawingOf(vtkPolyData* curves);

/**
 * The raster of a drawing, see there; the same errors.
 */
OVERSKETCHFILTERSPLANAR_EXPORT Frame RasterOf(vtkPolyData* curves);

/**
 * Fate of the inside of each stroke, see there.
 */
OVERSKETCHFILTERSPLANAR_EXPORT std::vector<Treatment> TreatmentsOf(vtkPolyData* curves);

/**
 * The numbers of a list of strokes, apart by spaces or commas, of so many. Throws Error(BadStroke) naming the
 * parameter for a text that is no such list, and for a number that no stroke has.
 */
OVERSKETCHFILTERSPLANAR_EXPORT std::vector<int> StrokeNumbers(std::string list,
  const char* parameter,
  int strokes);

/**
 * The layer that each stroke of a drawing is of, by the number of the closed one that bounds it; -1: the rest
 * of the plane. `curves`: of vtkOversketchCanvas, with the strokes' cell arrays Depth, Height and
 * CrossSection, absent ones 0. One with a Depth bounds a layer, and so does one in the plane, in no other
 * layer, with a Height or a CrossSection. Another is of the last layer before it that it lies wholly inside
 * of.
 */
OVERSKETCHFILTERSPLANAR_EXPORT std::vector<int> LayersOfStrokes(vtkPolyData* curves);

/**
 * Reads what the strokes are from the cell arrays that vtkOversketchClassify writes: roles, regions, objects.
 * Why a stroke was rejected, contacts, areas and their labels are not in them. Throws Error(MissingArray) for
 * an absent array, Error(BadStroke) naming the stroke where they contradict each other.
 */
OVERSKETCHFILTERSPLANAR_EXPORT Classification ClassificationOf(vtkPolyData* curves);

/**
 * Writes the cell arrays Role, RegionId, ChildRegionId and ObjectId.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WriteClassification(const Classification& classification,
  vtkPolyData* curves);

/**
 * All that a drawing and its classification are made of: for keys of what was made of them.
 */
OVERSKETCHFILTERSPLANAR_EXPORT MeshKey DrawingKey(vtkPolyData* curves);

/**
 * The maps that vtkOversketchDistance wrote, without `uphill`, which is not written. Throws
 * Error(MissingArray) for an absent array, Error(BadStroke) for an image that is no raster of square pixels
 * in the plane.
 */
OVERSKETCHFILTERSPLANAR_EXPORT DistanceMaps DistanceMapsOf(vtkImageData* image);

/**
 * The same, kept as long as the image stays as it is: for a step that is made again for each rebuild.
 */
class OVERSKETCHFILTERSPLANAR_EXPORT KeptMaps
{
public:
  const DistanceMaps& Of(vtkImageData* image);

private:
  KeptValue<DistanceMaps> Maps;
};

/**
 * Distance maps with `uphill`, found again.
 */
OVERSKETCHFILTERSPLANAR_EXPORT DistanceMaps UphillMapsOf(vtkImageData* image, const Context& context);

/**
 * Writes the image with its arrays T, LocalMax, Skeleton and Object.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WriteDistanceMaps(const DistanceMaps& maps, vtkImageData* image);

/**
 * Key that tells distance images apart.
 */
OVERSKETCHFILTERSPLANAR_EXPORT MeshKey ImageKey(vtkImageData* image);

/**
 * Gives an image the samples of a raster, without arrays; and the raster of an image.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WriteFrame(const Frame& frame, vtkImageData* image);
OVERSKETCHFILTERSPLANAR_EXPORT Frame FrameOf(vtkImageData* image);

/**
 * For the RequestInformation of such a filter: extent, spacing and origin of the image on port 1, and its
 * scalars' type (VTK_INT, ...). The raster depends on the data on port 0, which are therefore updated now;
 * where they are none that a raster can be made for, the extent is empty and RequestData says why. Returns 0
 * when that update failed.
 */
OVERSKETCHFILTERSPLANAR_EXPORT int DescribeImage(vtkAlgorithm* self,
  vtkInformation* output,
  int scalarType,
  const std::function<Frame(vtkPolyData* curves)>& frame);

} // namespace oversketch
#endif
