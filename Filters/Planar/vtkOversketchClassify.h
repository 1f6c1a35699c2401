/**
 * @class vtkOversketchClassify
 * @brief classes of a drawing's strokes: an object's boundary, a closed or an open feature
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.2.1, Fig. 6: strokes are drawn into a raster, its
 * areas tell boundaries, closed and open features apart. Departures: roles and regions follow from the closed
 * curves themselves (even-odd), since both sides of a thin limb merge in the raster; areas that a stroke
 * hardly touches are ignored (ContactShare); strokes that cross are found by an exact test of their segments.
 * The paper's resolution is open.
 *
 * Input 0 (Curves): curves of vtkOversketchCanvas, magnetic or not, usually resampled; a closed one repeats
 * its first point id at the end. Stroke i is cell i, called by its StrokeId in messages where it has one.
 * Field array Canvas. Curves of vtkOversketchArrange may meet in its nodes.
 *
 * Output 0 (Curves): the same, points and all arrays passed, and
 * - cell array Role, int: -1 rejected, 1 boundary of an object, 2 closed feature, 3 open feature,
 * - cell array RegionId, int: the region that the stroke lies in, of a boundary the one it bounds; -1 of a
 *   rejected one. Regions are what closed strokes bound, numbered in the strokes' order,
 * - cell array ChildRegionId, int: the region that a closed feature bounds, else -1,
 * - cell array ObjectId, int: the object, numbered in the order of boundaries; -1 of a rejected one,
 * - field array Resolution, int.
 * Output 1 (Labels, vtkImageData): the raster, Resolution px along the canvas's longest side and two more all
 * round, scalars Labels, int: 0 outside, 1, 2, ... other areas without strokes, -1 - i on stroke i.
 *
 * A stroke that no drawing needs is rejected (Role -1) with one warning: one of fewer than two distinct
 * points (closed: three), one that leaves the canvas, a closed one round less than 9 px, an open one in no
 * closed one.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming each stroke and what it meets
 * where, for strokes that cross or touch another one or themselves, and for one that touches more areas than
 * its kind does (open ones; with ContactShare 0 closed ones too); for a stroke without a finite sample, cells
 * that are no polylines, a canvas without extent; MissingArray without Canvas. Curves without points give
 * empty outputs silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: some 10 ms at 1024 px. The result
 * stays, as the same arrays, while points, polylines, canvas and parameters do: a change of other arrays
 * classifies nothing anew.
 *
 * @sa vtkOversketchCanvas vtkOversketchTreatment vtkOversketchDistance
 */
#ifndef vtkOversketchClassify_h
#define vtkOversketchClassify_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class vtkImageData;

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchClassify : public vtkOversketchFilter
{
public:
  static vtkOversketchClassify* New();
  vtkTypeMacro(vtkOversketchClassify, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The raster with its areas, on port 1.
   */
  vtkImageData* GetLabelsOutput();

  ///@{
  /**
   * An area that a stroke touches with less than this share of the pixels that it touches its largest one
   * with is ignored [0 to 1, default 0.05; 0: every area counts, as published].
   */
  vtkSetClampMacro(ContactShare, double, 0.0, 1.0);
  vtkGetMacro(ContactShare, double);
  ///@}

  ///@{
  /**
   * Pixels along the canvas's longest side, of this raster and all that follow [16 to 16384, default 1024].
   */
  vtkSetClampMacro(Resolution, int, 16, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * As the paper prints it: ContactShare counts as 0. Default off.
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * How many times strokes have been classified: executions that the kept result did not answer.
   */
  vtkGetMacro(ClassificationCount, vtkIdType);
  /**
   * How many strokes crossed themselves or each other the last time that they were classified.
   */
  vtkGetMacro(CrossingCount, int);

protected:
  vtkOversketchClassify();
  ~vtkOversketchClassify() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  double ContactShare = 0.05;
  int Resolution = 1024;
  bool AsPublished = false;
  vtkIdType ClassificationCount = 0;
  int CrossingCount = 0;

  struct Cache;
};

#endif
