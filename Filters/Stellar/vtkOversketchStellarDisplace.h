/**
 * @class vtkOversketchStellarDisplace
 * @brief raises a mesh along curves, carves it, or moves it to a silhouette sketch
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-C.2, Eqs. 1 and 2: a
 * vertex at distance d of a curve moves by (1 - d / r)^s times the height and its normal, or times the vector
 * from the curve to the sketch. Departures: vertices rise along the normals that the surface had before the
 * stroke (Normals), where several curves reach one, the nearest acts alone (Combine), and none goes so far
 * that it meets another part of the model (HoldBack).
 *
 * Input 0 (Mesh): 4-8 mesh, see vtkOversketchStellarBase and Filters/Stellar/README.md. Points move by 1 -
 * Mask of their way, a point array that vtkOversketchMask makes.
 * Input 1 (Curves): polylines of vtkOversketchSurfaceStroke or vtkOversketchSilhouetteSketch; of their arrays
 * Normals, Pressure and Room are read, and the cell arrays Radius, Height and Sharpness go before parameters.
 * Input 2 (Sketch, optional): output 1 of vtkOversketchSilhouetteSketch, points and cells those of the curves
 * one to one. With it heights are not read.
 *
 * Output 0 (Mesh): the 4-8 mesh; point arrays Feature (share of the height) and Displacement [model length],
 * StellarMoved with 2 where a vertex rose. The stroke ends here: BaseNormal and CurveDigest are gone, CurveId
 * is -1, and StellarMoved has 4 where vertices were snapped. Point normals turn with the surface.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, cell or
 * point, where the mesh is no sound 4-8 mesh or was changed by a filter in between; BadStroke for curves that
 * are none, for others than the mesh is snapped to (field array CurveDigest), and parameters out of range.
 * A mesh without points gives an empty output silently, without curves it goes through.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does. Another shape costs what is near the curves.
 *
 * @sa vtkOversketchStellarSnap vtkOversketchStellarSimplify
 */
#ifndef vtkOversketchStellarDisplace_h
#define vtkOversketchStellarDisplace_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <limits>
#include <string>

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarDisplace : public vtkOversketchFilter
{
public:
  static vtkOversketchStellarDisplace* New();
  vtkTypeMacro(vtkOversketchStellarDisplace, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curves, on port 1.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(1, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(1, curves); }

  /**
   * The silhouette sketch, on port 2.
   */
  void SetSketchConnection(vtkAlgorithmOutput* sketch) { this->SetInputConnection(2, sketch); }
  void SetSketchData(vtkPolyData* sketch) { this->SetInputData(2, sketch); }

  ///@{
  /**
   * How far from the curve the feature ends [model length, default -1: 0.03 of the mesh's diagonal]. A
   * curve's own Radius goes before it.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Height of the feature on the curve, below 0 inward [model length, default 0: half the radius]. A curve's
   * own Height goes before it.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Exponent s of the feature's profile (1 - distance / radius)^s, not negative [default 1.5]. A curve's own
   * Sharpness goes before it.
   */
  vtkSetMacro(Sharpness, double);
  vtkGetMacro(Sharpness, double);
  ///@}

  ///@{
  /**
   * A polyline "x y, x y, ..." with x rising from 0 to 1 in the profile's place; empty (default): none.
   */
  void SetProfile(const char* text);
  const char* GetProfile() const { return this->Profile.c_str(); }
  ///@}

  enum DistanceType
  {
    Straight = 0,
    Geodesic = 1
  };
  ///@{
  /**
   * Distances through space (default, as published) or over the surface, which do not reach round thin parts.
   */
  vtkSetClampMacro(Distance, int, Straight, Geodesic);
  vtkGetMacro(Distance, int);
  void SetDistanceToStraight() { this->SetDistance(Straight); }
  void SetDistanceToGeodesic() { this->SetDistance(Geodesic); }
  ///@}

  ///@{
  /**
   * With straight distances, reach only what is joined to the curve through what is reached [default on; as
   * published: off].
   */
  vtkSetMacro(ConnectedOnly, bool);
  vtkGetMacro(ConnectedOnly, bool);
  vtkBooleanMacro(ConnectedOnly, bool);
  ///@}

  ///@{
  /**
   * Multiply the height by the pen's Pressure at the nearest point of the curve [default off].
   */
  vtkSetMacro(UsePressure, bool);
  vtkGetMacro(UsePressure, bool);
  vtkBooleanMacro(UsePressure, bool);
  ///@}

  ///@{
  /**
   * Length at either end of an open curve over which it runs out into a point, of a curve shorter than two of
   * it half the curve: the width as a sine, the height as its square [model length; default 0: ends are
   * round].
   */
  vtkSetMacro(Taper, double);
  vtkGetMacro(Taper, double);
  ///@}

  enum NormalsType
  {
    Base = 0,
    Current = 1
  };
  ///@{
  /**
   * Vertices rise along BaseNormal (default), or as published along the Current normals, which turn where
   * triangles are uneven.
   */
  vtkSetClampMacro(Normals, int, Base, Current);
  vtkGetMacro(Normals, int);
  void SetNormalsToBase() { this->SetNormals(Base); }
  void SetNormalsToCurrent() { this->SetNormals(Current); }
  ///@}

  /**
   * Keep BaseNormal, along which a further stroke then rises on this one's flanks, too [default off].
   */
  vtkSetMacro(KeepBaseNormals, bool);
  vtkGetMacro(KeepBaseNormals, bool);

  enum CombineType
  {
    Nearest = 0,
    Sum = 1
  };
  ///@{
  /**
   * Where several curves reach a vertex: the Nearest by share of its radius alone (default), or as published
   * the Sum, which stands twice as high where two cross.
   */
  vtkSetClampMacro(Combine, int, Nearest, Sum);
  vtkGetMacro(Combine, int);
  void SetCombineToNearest() { this->SetCombine(Nearest); }
  void SetCombineToSum() { this->SetCombine(Sum); }
  ///@}

  ///@{
  /**
   * Grooves and ridges take two fifths of the curves' Room, how far it is to another part of the model, and
   * no more [default on; as published: off].
   */
  vtkSetMacro(HoldBack, bool);
  vtkGetMacro(HoldBack, bool);
  vtkBooleanMacro(HoldBack, bool);
  ///@}

  ///@{
  /**
   * Count triangles that pass through others [default on].
   */
  vtkSetMacro(CountIntersections, bool);
  vtkGetMacro(CountIntersections, bool);
  vtkBooleanMacro(CountIntersections, bool);
  ///@}

  ///@{
  /**
   * Figures of the last displacement: vertices that rose, faces that turned over (by over 90 degrees, and to
   * the other side of the way they rose), the greatest Feature; triangles that newly meet others elsewhere
   * than in a common corner, -1 where not counted; points of curves with less room than the height, and the
   * least share of it that was left.
   */
  vtkGetMacro(Moved, int);
  vtkGetMacro(FlippedFaces, int);
  vtkGetMacro(Peak, double);
  vtkGetMacro(IntersectingFaces, int);
  vtkGetMacro(HeldBack, int);
  vtkGetMacro(LeastShare, double);
  /**
   * Feature on the last displacement's curves, one value every twentieth of a radius but for the ends: 1
   * where the mesh holds the crest; NaN where curves are shorter than two radii. And how many places.
   */
  vtkGetMacro(CrestMean, double);
  vtkGetMacro(CrestMinimum, double);
  vtkGetMacro(CrestPlaces, int);
  /**
   * How many times a mesh has been displaced, and distances were measured: not answered by kept results.
   */
  vtkGetMacro(DisplaceCount, vtkIdType);
  vtkGetMacro(DistanceCount, vtkIdType);
  ///@}

protected:
  vtkOversketchStellarDisplace();
  ~vtkOversketchStellarDisplace() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Radius = -1.0, Height = 0.0, Sharpness = 1.5, Taper = 0.0;
  std::string Profile;
  int Distance = Straight, Normals = Base, Combine = Nearest;
  bool ConnectedOnly = true, UsePressure = false, HoldBack = true, KeepBaseNormals = false;
  bool CountIntersections = true;
  int Moved = 0, FlippedFaces = 0, IntersectingFaces = -1, HeldBack = 0;
  double LeastShare = 1.0;
  double Peak = 0.0, CrestMean = std::numeric_limits<double>::quiet_NaN(),
         CrestMinimum = std::numeric_limits<double>::quiet_NaN();
  int CrestPlaces = 0;
  vtkIdType DisplaceCount = 0, DistanceCount = 0;

  struct Cache;
};

#endif
