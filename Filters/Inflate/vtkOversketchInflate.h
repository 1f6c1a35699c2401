/**
 * @class vtkOversketchInflate
 * @brief blows a drawing's mesh up to a closed surface: a choice of cross-sections over the distance to its
 * rim
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.3, Figs. 12a and 14: points are pushed out of the
 * plane, to both sides, by a function of their distance d to the rim and of the thickness D there, the
 * distance at the skeleton: s k_z D f(d / D), of the circle sqrt(D^2 - (D - d)^2); front and back share the
 * rim's points. Departures, which AsPublished turns off: D jumps where the skeleton's nearest place does,
 * which makes hoops and crumpled crests, so heights of the circle are those of a membrane under pressure,
 * which has no creases, multiplied by what varies slowly so that they are those of the greatest balls that
 * lie in the drawing (ProfileSmoothing); for other profiles D is smoothed over the inside
 * (LocalMaxSmoothing). And points beside the rim come closer to it, so that triangles there are even, and
 * edges that cut off the surface give way to others (UnstretchedRims), which the paper names as future work.
 * An option that is ours: Mode Poisson. Kernels/Inflate/heights.h, unstretch.h and swap_edges.h and
 * Kernels/Raster/grid_smoothing.h have the equations.
 *
 * Input 0 (Mesh): the drawing's mesh in the plane, triangles or quads, as vtkOversketchPlanarRefine puts it
 * out, holes trimmed; its point array BoundaryKind says what is a rim.
 *
 * Input 1 (Distance, vtkImageData): the
 * same drawing's distance image, output 1 of vtkOversketchDistance.
 *
 * Output 0 (Mesh): the closed surface, front and rim first, in the mesh's order, then the back; of quads
 * quads. All arrays are passed, and
 * - point array Displacement, double: distance from the plane [world],
 * - point and cell array Side, int: 1 front, -1 back, 0 on the rim,
 * - point array PlanarId, int: the point of the input.
 * Output 1 (Heights, vtkImageData): the raster with what was read of it, float point arrays Ratio, the
 * heights' squares over T [px], and LocalMaxSmooth, the thickness [px]: D, smoothed; of the smoothed circle
 * and of Poisson's mode the radius of the circle that stands on the rim and has the height.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray naming an absent array; BadMesh,
 * naming points, where the mesh is no sheet, has a border that is no rim (BoundaryKind 1 or 2), a rim inside
 * (holes that are not trimmed), or an edge inside that joins two points of rims (refine once more), and where
 * it lies outside the image; BadStroke for a Profile that is none and numbers out of range. A mesh without
 * points gives an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: mostly the two solves, some 0.2 s
 * each for an object that fills 1024 px, which are kept: another HeightFactor repeats none, another Profile
 * or ProfileSmoothing not that of D, a mesh with further features none.
 *
 * @sa vtkOversketchDistance vtkOversketchExtrude vtkOversketchTunnel vtkOversketchProjectTexture
 */
#ifndef vtkOversketchInflate_h
#define vtkOversketchInflate_h

#include "OversketchFiltersInflateModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <string>

class vtkImageData;

class OVERSKETCHFILTERSINFLATE_EXPORT vtkOversketchInflate : public vtkOversketchFilter
{
public:
  static vtkOversketchInflate* New();
  vtkTypeMacro(vtkOversketchInflate, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The distance image, on port 1.
   */
  void SetDistanceConnection(vtkAlgorithmOutput* distance) { this->SetInputConnection(1, distance); }
  void SetDistanceData(vtkDataObject* distance) { this->SetInputData(1, distance); }

  /**
   * Maps that heights were read from, on port 1.
   */
  vtkImageData* GetHeightsOutput();

  enum ModeType
  {
    Circular = 0,
    Poisson = 1
  };
  ///@{
  /**
   * Circular (default), by the cross-section of Profile, or Poisson: a membrane under pressure, z^2 = u with
   * Laplacian u = -4, as smooth, but limbs become twice as thick; Profile and smoothings are not read.
   */
  vtkSetClampMacro(Mode, int, Circular, Poisson);
  vtkGetMacro(Mode, int);
  void SetModeToCircular() { this->SetMode(Circular); }
  void SetModeToPoisson() { this->SetMode(Poisson); }
  ///@}

  ///@{
  /**
   * The cross-section: empty (default) or "circle", "linear", "step", a plateau with round shoulders, or a
   * curve on the unit square, "0 0, x y, ..., 1 y": height by distance to the rim, both as shares of the
   * thickness, with x rising and y above 0 from the second point on.
   */
  void SetProfile(const char* text);
  const char* GetProfile() const { return this->Profile.c_str(); }
  ///@}

  ///@{
  /**
   * k_z: heights are multiplied by it [above 0, default 1].
   */
  vtkSetMacro(HeightFactor, double);
  vtkGetMacro(HeightFactor, double);
  ///@}

  ///@{
  /**
   * How far the thickness is smoothed, as a share of itself [>= 0, default 0.5; as published: 0, not at all].
   * The smoothed circle does not read it.
   */
  vtkSetMacro(LocalMaxSmoothing, double);
  vtkGetMacro(LocalMaxSmoothing, double);
  ///@}

  ///@{
  /**
   * How far what a membrane's heights are multiplied by is smoothed, as a share of the thickness; 0 leaves
   * the profile as it is, with its creases [default -1: 0.3 for the circle, 0 for other profiles, whose
   * creases are meant; as published: 0].
   */
  vtkSetMacro(ProfileSmoothing, double);
  vtkGetMacro(ProfileSmoothing, double);
  ///@}

  ///@{
  /**
   * Move points that lie on no stroke towards the rim before they are pushed out, so that triangles there are
   * stretched less and the rim is round, and swap edges that cut more than a pixel off the surface [default
   * on; as published: off]. No triangle of the plane is turned over by it. Only where the surface begins
   * upright: not of "linear" and of curves.
   */
  vtkSetMacro(UnstretchedRims, bool);
  vtkGetMacro(UnstretchedRims, bool);
  vtkBooleanMacro(UnstretchedRims, bool);
  ///@}

  ///@{
  /**
   * Inflate as printed: without either smoothing and with points where they are, whatever the parameters say
   * [default off].
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  ///@{
  /**
   * How many times the thickness, the ratio and the surface have been computed: executions that the kept ones
   * did not answer.
   */
  vtkGetMacro(ThicknessCount, vtkIdType);
  vtkGetMacro(RatioCount, vtkIdType);
  vtkGetMacro(InflateCount, vtkIdType);
  ///@}

protected:
  vtkOversketchInflate();
  ~vtkOversketchInflate() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Mode = Circular;
  std::string Profile;
  double HeightFactor = 1.0;
  double LocalMaxSmoothing = 0.5;
  double ProfileSmoothing = -1.0;
  bool UnstretchedRims = true;
  bool AsPublished = false;
  vtkIdType ThicknessCount = 0;
  vtkIdType RatioCount = 0;
  vtkIdType InflateCount = 0;

  struct Cache;
};

#endif
