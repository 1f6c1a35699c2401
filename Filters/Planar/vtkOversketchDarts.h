/**
 * @class vtkOversketchDarts
 * @brief points thrown into a drawing's inside, for rounder triangles
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.2.4, Fig. 11. Departure (Kernels/Planar/darts.h):
 * the distance to keep is 0.7 of how thick the object is there, so that limbs get darts too, less beside
 * corners that point inwards, and strokes' polylines are kept clear of; by the published rule, half of the
 * object's greatest distance from its rim, thin limbs have none. The paper's darts are an option, off by
 * default.
 *
 * Input 0 (Polylines): those of vtkOversketchPolyline.
 * Input 1 (Distance, vtkImageData, optional): that of vtkOversketchDistance, of the same drawing. Not read
 * with DartMode Off.
 *
 * Output 0 (Darts): points, one vertex cell each, z = 0, double, in the order they were thrown in.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray for absent arrays or a distance image
 * that is needed; BadStroke for polylines that are none. Polylines without points give an empty output
 * silently.
 *
 * Deterministic: the same darts for a seed, on every machine and for any number of threads. Cost: some 50 ms
 * at 1024 px. The result stays while polylines, distance and parameters do.
 *
 * @sa vtkOversketchPolyline vtkOversketchCoarseMesh
 */
#ifndef vtkOversketchDarts_h
#define vtkOversketchDarts_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchDarts : public vtkOversketchFilter
{
public:
  static vtkOversketchDarts* New();
  vtkTypeMacro(vtkOversketchDarts, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Mode
  {
    LOCAL = 0,
    PUBLISHED = 1,
    OFF = 2
  };

  /**
   * The distance image, on port 1.
   */
  void SetDistanceConnection(vtkAlgorithmOutput* distance) { this->SetInputConnection(1, distance); }
  void SetDistanceData(vtkDataObject* distance) { this->SetInputData(1, distance); }

  ///@{
  /**
   * Distance that darts keep: Local, 0.7 of the thickness there, at least 6 px, less beside corners that
   * point inwards; Published, half of the object's greatest distance from its rim; Off, there are none
   * [default Local].
   */
  vtkSetClampMacro(DartMode, int, LOCAL, OFF);
  vtkGetMacro(DartMode, int);
  void SetDartModeToLocal() { this->SetDartMode(LOCAL); }
  void SetDartModeToPublished() { this->SetDartMode(PUBLISHED); }
  void SetDartModeToOff() { this->SetDartMode(OFF); }
  ///@}

  ///@{
  /**
   * Seed of the random numbers [0 to 2147483647, default 1].
   */
  vtkSetClampMacro(Seed, int, 0, VTK_INT_MAX);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * As the paper prints it: DartMode counts as Off. Default off.
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * How many times darts have been thrown: executions that the kept result did not answer.
   */
  vtkGetMacro(DartsCount, vtkIdType);

protected:
  vtkOversketchDarts();
  ~vtkOversketchDarts() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int DartMode = LOCAL;
  int Seed = 1;
  bool AsPublished = false;
  vtkIdType DartsCount = 0;
};

#endif
