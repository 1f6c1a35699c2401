/**
 * @class vtkOversketchDistance
 * @brief how far inside its object's rim each pixel of a drawing is, and how thick the object is there
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.3, Fig. 13: the distance to the nearest pixel of a
 * boundary, those of holes included, tunnels and features not; its ridge, the skeleton; and the distance at
 * the ridge that belongs to a pixel. Departures and readings (Kernels/Raster/distance_maps.h): the distance
 * is exact; a plain maximum over eight neighbours keeps only plateaus of the ridge, so slopes below 0.75
 * belong to it from 3 px on; the printed formula, the object's greatest distance, is LocalMaxMode Global.
 *
 * Input 0 (Curves): curves of vtkOversketchClassify; cell array Treatment (see vtkOversketchTreatment) may be
 * absent: all filled.
 *
 * Output 0 (Curves): the same.
 * Output 1 (Distance, vtkImageData): the raster of the drawing with the point arrays
 * - T, float, the scalars: distance to the nearest rim [px], 0 on it and outside,
 * - LocalMax, float: T at the ridge that the steepest way up leads to, nowhere less than T [px],
 * - Skeleton, unsigned char: 1 on the ridge,
 * - Object, int: the object, its rim's pixels included; -1 outside.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without Canvas or the arrays of
 * vtkOversketchClassify; BadStroke for contradictions in them and for a rim that leaves the canvas. Curves
 * without points give empty outputs silently; without an object T is 0 and Object -1.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: some 30 ms at 1024 px. The image
 * stays, as the same arrays, while the rims, the raster and the mode do: features and tunnels compute nothing
 * anew.
 *
 * @sa vtkOversketchClassify vtkOversketchTreatment
 */
#ifndef vtkOversketchDistance_h
#define vtkOversketchDistance_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class vtkImageData;

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchDistance : public vtkOversketchFilter
{
public:
  static vtkOversketchDistance* New();
  vtkTypeMacro(vtkOversketchDistance, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Mode
  {
    LOCAL = 0,
    GLOBAL = 1
  };

  /**
   * The maps, on port 1.
   */
  vtkImageData* GetDistanceOutput();

  ///@{
  /**
   * Rule of LocalMax: Local, T at the ridge; Global, the object's greatest T, which makes thin limbs several
   * times too thick [default Local].
   */
  vtkSetClampMacro(LocalMaxMode, int, LOCAL, GLOBAL);
  vtkGetMacro(LocalMaxMode, int);
  void SetLocalMaxModeToLocal() { this->SetLocalMaxMode(LOCAL); }
  void SetLocalMaxModeToGlobal() { this->SetLocalMaxMode(GLOBAL); }
  ///@}

  /**
   * How many times maps have been computed: executions that the kept ones did not answer.
   */
  vtkGetMacro(DistanceCount, vtkIdType);

protected:
  vtkOversketchDistance();
  ~vtkOversketchDistance() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int LocalMaxMode = LOCAL;
  vtkIdType DistanceCount = 0;

  struct Cache;
};

#endif
